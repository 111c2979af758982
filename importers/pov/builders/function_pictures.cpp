// SPDX-License-Identifier: Apache-2.0
/// Source   POV-Ray 3.7 reference, 3.4.7.1.12.2 "Function Image"; which points and bits by experiments with POV-Ray 3.7
#include "importers/pov/builders/function_pictures.h"

#include "core/deep_png.h"
#include "importers/pov/builders/functions.h"
#include "importers/pov/space_functions.h"

#include <cmath>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

constexpr double kLevels = 65535;

/// What 16 bits keep of a number of steps: it is cut, and begins anew above the last one and below 0.
float in_16_bits(double steps) {
    return std::abs(steps) < 1e15 ? float(double(uint16_t(int64_t(steps))) / kLevels) : 0.0f;
}

/// Asks the function at the corners of its pixels' square: the first column is x = 0, the last x = 1, the first row y = 0.
template <class F> void for_each_pixel(Picture& picture, const F& pixel) {
    const double right = picture.width - 1, bottom = picture.height - 1;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) pixel(picture.at(x, y), Vec3(x / right, y / bottom, 0));
}

void fill(Build& build, const Function& function, Place place, Picture& picture) {
    SpaceFunctions functions(build.p);       // that of the parser may be what is building this
    const Block* block = block_of(function);
    if (!block || block->word == "pattern"_w) {
        for_each_pixel(picture, [&](float* pixel, const Vec3& at) {
            const double xyz[] = {at.x, at.y, at.z};
            *pixel = in_16_bits(functions.number(function, xyz, place) * kLevels);
        });
        return;
    }
    for_each_pixel(picture, [&](float* pixel, const Vec3& at) {
        build.p.charge(1, place);
        const std::array<double, 5> c = functions.pigment(*block, at);
        const auto channel = [](double x) { return in_16_bits(float(x) * float(kLevels)); };   // POV-Ray keeps colours in single precision
        for (size_t i = 0; i < 3; ++i) pixel[i] = channel(c[i]);
        pixel[3] = channel(1 - c[4]);
    });
}

Picture picture_of(Build& build, const Function& function, Place place) {
    constexpr double kMostPixels = 1 << 26;
    const double columns = std::floor((*function.size)[0] + 0.5), rows = std::floor((*function.size)[1] + 0.5);
    if (!(columns >= 1 && rows >= 1)) build.p.fail(place, fmt::format("the picture of a function has {} x {} pixels", columns, rows));
    if (!(columns * rows <= kMostPixels)) build.p.fail_limit(place, fmt::format("the picture of a function has more than {} pixels", kMostPixels));
    const Block* block = block_of(function);
    if (block && block->word == "transform"_w) build.p.fail(place, "the function of a picture gives a number or a colour");
    Picture picture;
    picture.width = int(columns), picture.height = int(rows), picture.channels = block && block->word == "pigment"_w ? 4 : 1;
    picture.values.assign(size_t(columns * rows) * size_t(picture.channels), 0.5f);
    try {
        fill(build, function, place, picture);
    } catch (const Failure& failure) {
        if (!failure.unmodelled) throw;
        build.p.tally(place, failure.diagnostic.message + ": middle grey stands for the picture of a function");
    }
    return picture;
}

}  // namespace

ImageId build_function_picture(Build& build, const Function& function, Place place) {
    const auto known = build.function_pictures.find(&function);
    if (known != build.function_pictures.end()) return known->second;
    auto bytes = encode_number_png(picture_of(build, function, place));
    if (!bytes) build.p.fail(place, bytes.error());
    Image image;
    image.name = fmt::format("function_{}.png", build.function_pictures.size()), image.bytes = std::move(*bytes), image.from = build.position(place);
    build.scene.images.push_back(std::move(image));
    const ImageId id{uint32_t(build.scene.images.size() - 1)};
    build.function_pictures.emplace(&function, id);
    return id;
}

}  // namespace alidade::pov
