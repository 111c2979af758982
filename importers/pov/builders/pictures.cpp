// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/pictures.h"

#include "core/image.h"
#include "eval/noise/single.h"
#include "importers/pov/builders/function_pictures.h"
#include "importers/pov/builders/functions.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

/// A word for a format, and the ending that names may leave out. `encoded`: what the file does not say, version 3.7 takes for sRGB. What a file is, is seen by its content.
struct Format {
    WordId word;
    const char* ending;
    bool encoded = true;
};
constexpr Format kFormats[] = {{"png"_w, ".png"}, {"jpeg"_w, ".jpg"}, {"gif"_w, ".gif"}, {"tga"_w, ".tga"}, {"iff"_w, ".iff"}, {"bmp"_w, ".bmp"}, {"sys"_w, ".bmp"},
                               {"ppm"_w, ".ppm", false}, {"pgm"_w, ".pgm", false}, {"tiff"_w, ".tif", false}, {"exr"_w, ".exr"}, {"hdr"_w, ".hdr"}};

/// Null without a word.
const Format* take_format(Cursor& at) {
    for (const Format& format : kFormats)
        if (at.accept(format.word)) return &format;
    return nullptr;
}

/// Without a word, what the file's ending says, or else what POV-Ray writes if nothing else is asked for.
const Format& format_of(const std::string& path) {
    std::string ending = lower_ending(path);
    if (ending == ".tiff") ending = ".tif";
    const auto found = std::find_if(std::begin(kFormats), std::end(kFormats), [&](const Format& format) { return ending == format.ending; });
    return found == std::end(kFormats) ? kFormats[0] : *found;
}

ImageId add_image(Build& build, const std::string& name, const Format& format, Place place) {
    auto found = build.p.finder.find(name);
    if (!found) found = build.p.finder.find(name + format.ending);
    if (!found) build.p.fail(place, fmt::format("the picture \"{}\" is not found", name), "pictures are looked for where includes are: below the scene's folder and the include paths");
    const auto [at, added] = build.images.try_emplace(found->path, ImageId{uint32_t(build.scene.images.size())});
    if (!added) return at->second;
    if (found->other_case) build.p.warn(place, fmt::format("the picture \"{}\" is found as {}", name, found->path));
    Image image;
    image.name = name, image.path = found->path, image.from = build.position(place);
    build.scene.images.push_back(std::move(image));
    return at->second;
}

/// What the file's numbers mean if the scene does not say. POV-Ray decodes a picture as it comes to it (by experiment): before any assumed_gamma for version
/// 3.7 to linear numbers, which they stay whatever gamma follows, and for older ones not at all.
void set_usual_code(const Block& block, const Format& format, PatternPicture& out) {
    const bool is_colour = block.word == "image_map"_w, old = !block.version_given || double(block.version) < 3.7 - 1e-6;
    out.scene_gamma = is_colour && block.gamma_given;
    if (!is_colour || (old && !block.gamma_given)) return;
    out.code = format.encoded && !old ? PictureCode::told_or_srgb : PictureCode::told_or_stored;
}

void take_gamma(Build& build, Cursor& at, PatternPicture& out) {
    const Place place = at.place();
    if (at.accept("srgb"_w)) {
        out.code = PictureCode::srgb;
        return;
    }
    out.code = PictureCode::power;
    out.gamma = single(at.number("the gamma of a picture"));
    if (!(out.gamma > 0)) build.p.fail(place, "the gamma of a picture must be greater than 0");
}

void take_map(Build& build, Cursor& at, PatternPicture& out) {
    const Place place = at.place();
    const double type = at.number("the type of a map");
    if (type == 0) out.map = PictureMap::planar;
    else if (type == 1) out.map = PictureMap::spherical;
    else if (type == 2) out.map = PictureMap::cylindrical;
    else if (type == 5) out.map = PictureMap::toroidal;
    else build.p.fail(place, fmt::format("there is no map_type {}", type), "0 is planar, 1 spherical, 2 cylindrical, 5 a torus");
}

/// Of an image_map POV-Ray refuses other kinds; behind the other words it takes them.
void take_filter(Build& build, Cursor& at, PatternPicture& out) {
    const Place place = at.place();
    const int type = at.integer("the kind of interpolation", -1, 5);
    const bool known = type >= 0 && type <= 4;
    if (!known && at.block().word == "image_map"_w) build.p.fail(place, "there is no such kind of interpolation", "0 is none, 2 is bilinear, 3 bicubic, 4 weighs by distance");
    static constexpr PictureFilter kKinds[] = {PictureFilter::none, PictureFilter::none, PictureFilter::bilinear, PictureFilter::bicubic, PictureFilter::distance};
    out.filter = known ? kKinds[type] : PictureFilter::none;
}

/// `filter all F`, `filter N, F`, and the same with transmit.
void take_clearing(Cursor& at, bool filters, PatternPicture& out) {
    PatternPicture::Clearing c;
    if (!at.accept("all"_w)) c.color = at.integer("the number of a colour in a palette", 0, 255);
    (filters ? c.filter : c.transmit) = single(at.number("how much passes a colour"));
    out.clearings.push_back(c);
}

/// What may stand behind the file's name; false where nothing of it stands. Of the patterns, those of normals alone can be of a palette's numbers.
bool take_modifier(Build& build, Cursor& at, PatternPicture& out, double* depth) {
    const bool numbered = at.block().word == "bump_map"_w;
    if (at.accept("gamma"_w)) take_gamma(build, at, out);
    else if (at.accept("premultiplied"_w)) out.premultiplied = at.flag();
    else if (at.accept("map_type"_w)) take_map(build, at, out);
    else if (at.accept("interpolate"_w)) take_filter(build, at, out);
    else if (at.accept("once"_w)) out.once = true;
    else if (at.accept("filter"_w)) take_clearing(at, true, out);
    else if (at.accept("transmit"_w)) take_clearing(at, false, out);
    else if (at.accept("use_alpha"_w)) out.value = PictureValue::transmission;
    else if (at.accept("use_index"_w)) out.value = numbered ? PictureValue::palette : PictureValue::grey;
    else if (at.accept("use_color"_w) || at.accept("use_colour"_w)) out.value = PictureValue::grey;
    else if (depth && at.accept("bump_size"_w)) *depth = at.number("the depth of a normal");
    else return false;
    return true;
}

/// `function W, H { ... }` and what may stand behind it: its numbers are what the scene calculates with.
PatternPicture take_function_picture(Build& build, Cursor& at, double* depth) {
    const Place place = at.place();
    const Function& function = at.next().value().as<Function>();
    if (is_declared(function, place) || !function.size) build.p.fail(place, "the function of a picture stands there itself, with its size", "write function COLUMNS, ROWS { ... }");
    PatternPicture out;
    out.image = build_function_picture(build, function, place);
    out.scene_gamma = false;
    while (!at.done()) {
        const Place here = at.place();
        const WordId kind = at.block().word;
        const bool clears = at.at_word("filter"_w) || at.at_word("transmit"_w);
        const bool elsewhere = (clears && kind != "image_map"_w) || (at.at_word("use_alpha"_w) && kind != "image_pattern"_w);
        if (at.at_word("gamma"_w) || at.at_word("premultiplied"_w) || elsewhere) build.p.fail(here, fmt::format("{} cannot stand behind a function", kWords[at.peek().word]));
        if (!take_modifier(build, at, out, depth)) break;
        if (clears && out.clearings.back().color) build.p.fail(here, "the picture of a function has no palette: filter and transmit are of all its colours", "write filter all F");
    }
    return out;
}

}  // namespace

bool at_picture(const Cursor& at) { return at.at_block("image_map"_w) || at.at_block("image_pattern"_w) || at.at_block("bump_map"_w); }

PatternPicture take_picture(Build& build, Cursor& at, double* depth) {
    const Block& block = at.block();
    PatternPicture out;
    if (at.at_numeric()) at.next();                                  // the old direction, which says nothing any more
    if (at.at_function()) return take_function_picture(build, at, depth);
    const Format* told = take_format(at);
    const Place place = at.place();
    const bool named = !at.done() && at.peek().kind == Item::Kind::value && at.peek().value_kind() == Kind::string;
    if (!named) build.p.fail(place, fmt::format("the name of a file is expected in {}", kWords[block.word]));
    out.image = add_image(build, at.next().text(), told ? *told : kFormats[0], place);
    const Format& format = told ? *told : format_of(build.scene.images[out.image.index].path);
    out.premultiplied = format.word == "exr"_w;                      // as that format has it
    set_usual_code(block, format, out);
    while (!at.done() && take_modifier(build, at, out, depth)) continue;
    return out;
}

PatternPicture build_picture(Build& build, const Block& block, double* depth) {
    Cursor at(build, block);
    const PatternPicture out = take_picture(build, at, depth);
    while (!at.done()) at.skip_unmodelled();
    return out;
}

}  // namespace alidade::pov
