// SPDX-License-Identifier: Apache-2.0
/// Finds the shift between two pictures.
#include "tools/diff/cause.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace alidade {
namespace {

/// A channel of grays, one a pixel.
struct Gray {
    int width, height;
    std::vector<float> values;

    float at(int x, int y) const { return values[size_t(y) * size_t(width) + size_t(x)]; }
    /// Between pixels: linear in both directions. The point has pixels all around it.
    double at(double x, double y) const {
        const int u = int(std::floor(x)), v = int(std::floor(y));
        const double s = x - u, t = y - v;
        return (1 - t) * ((1 - s) * at(u, v) + s * at(u + 1, v)) + t * ((1 - s) * at(u, v + 1) + s * at(u + 1, v + 1));
    }
};

Gray gray_of(const Picture& picture, int colors) {
    Gray out{picture.width, picture.height, std::vector<float>(size_t(picture.width) * size_t(picture.height))};
    for (size_t p = 0; p < out.values.size(); ++p)
        for (int c = 0; c < colors; ++c) out.values[p] += picture.values[p * size_t(picture.channels) + size_t(c)] / float(colors);
    return out;
}

/// The pixels that shifts are judged by: away from the border, of a large picture each so many-th row and column.
struct InteriorPixels {
    int margin, step;

    template <class See>
    void each(const Gray& picture, See&& see) const {
        for (int y = margin; y < picture.height - margin; y += step)
            for (int x = margin; x < picture.width - margin; x += step) see(x, y);
    }
};

double square(double v) { return v * v; }

struct Whole {
    int x = 0, y = 0;
};

/// Of the shifts `about` +- most.
Whole best_whole_shift(const Gray& reference, const Gray& test, const InteriorPixels& inside, int most, Whole about = {}) {
    Whole best;
    double least = INFINITY;
    for (int ring = 0; ring <= most; ++ring)   // from the middle: of equal ones the smallest
        for (int y = -ring; y <= ring; ++y)
            for (int x = -ring; x <= ring; ++x) {
                if (std::max(std::abs(x), std::abs(y)) != ring) continue;
                double error = 0;
                inside.each(reference, [&](int u, int v) { error += square(double(test.at(u + about.x + x, v + about.y + y)) - reference.at(u, v)); });
                if (error < least) least = error, best = {about.x + x, about.y + y};
            }
    return best;
}

/// The means of blocks of `times` x `times` pixels.
Gray shrunk(const Gray& picture, int times) {
    Gray out{picture.width / times, picture.height / times, std::vector<float>(size_t(picture.width / times) * size_t(picture.height / times))};
    for (int y = 0; y < out.height * times; ++y)
        for (int x = 0; x < out.width * times; ++x) out.values[size_t(y / times) * size_t(out.width) + size_t(x / times)] += picture.at(x, y) / float(times * times);
    return out;
}

/// How far shifts are looked for in a picture of this size: pixels are left to judge them by.
int most_of(const Gray& picture) { return std::min(8, (std::min(picture.width, picture.height) - 4) / 4); }

/// Of a large picture, some rows and columns are enough.
InteriorPixels interior(const Gray& picture, int margin) { return {margin, std::max(1, int(std::sqrt(double(picture.width) * picture.height / 60000)))}; }

bool is_farthest(const Whole& w, int farthest) { return std::max(std::abs(w.x), std::abs(w.y)) == farthest; }

/// Up to 32 pixels, found in pictures of a quarter of the size. A shift that is one of the farthest is no minimum.
std::optional<Whole> far_shift(const Gray& reference, const Gray& test) {
    constexpr int kTimes = 4;
    const Gray small_reference = shrunk(reference, kTimes), small_test = shrunk(test, kTimes);
    const int most = most_of(small_reference);
    if (most < 1) return std::nullopt;
    const Whole small = best_whole_shift(small_reference, small_test, interior(small_reference, most + 3), most);
    if (is_farthest(small, most)) return std::nullopt;
    return best_whole_shift(reference, test, interior(reference, kTimes * (most + 1) + 3), kTimes, {kTimes * small.x, kTimes * small.y});
}

/// One step of Lucas and Kanade: how much further test lies than `at`.
Shift refined(const Gray& reference, const Gray& test, const InteriorPixels& inside, Shift at) {
    double xx = 0, xy = 0, yy = 0, xe = 0, ye = 0;
    inside.each(reference, [&](int x, int y) {
        const double u = x + at.x, v = y + at.y;
        const double gx = 0.5 * (test.at(u + 1, v) - test.at(u - 1, v)), gy = 0.5 * (test.at(u, v + 1) - test.at(u, v - 1));
        const double error = reference.at(x, y) - test.at(u, v);
        xx += gx * gx, xy += gx * gy, yy += gy * gy, xe += gx * error, ye += gy * error;
    });
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-9 * square(xx + yy))) return at;
    return {at.x + std::clamp((yy * xe - xy * ye) / determinant, -0.5, 0.5), at.y + std::clamp((xx * ye - xy * xe) / determinant, -0.5, 0.5), 0};
}

double squared_error(const Gray& reference, const Gray& test, const InteriorPixels& inside, Shift at) {
    double error = 0;
    inside.each(reference, [&](int x, int y) { error += square(test.at(x + at.x, y + at.y) - reference.at(x, y)); });
    return error;
}

/// Up to 8 pixels, or farther where that leaves more than a twentieth of the squared error.
std::optional<Whole> whole_shift(const Gray& reference, const Gray& test) {
    const int most = most_of(reference);
    if (most < 1) return std::nullopt;
    const auto error = [&](const InteriorPixels& inside, const Whole& w) { return squared_error(reference, test, inside, {double(w.x), double(w.y), 0}); };
    const InteriorPixels inside = interior(reference, most + 3);
    const Whole near = best_whole_shift(reference, test, inside, most);
    if (!is_farthest(near, most) && error(inside, near) <= 0.05 * error(inside, {})) return near;
    const std::optional<Whole> far = far_shift(reference, test);
    if (!far) return is_farthest(near, most) ? std::nullopt : std::optional(near);
    const InteriorPixels both = interior(reference, std::max({std::abs(far->x), std::abs(far->y), most}) + 3);
    return error(both, *far) < error(both, near) ? far : near;
}

}  // namespace

std::optional<Shift> find_shift(const PicturePair& pair) {
    const Gray reference = gray_of(pair.reference, pair.colors()), test = gray_of(pair.test, pair.colors());
    const std::optional<Whole> found = whole_shift(reference, test);
    if (!found) return std::nullopt;
    const Whole whole = *found;
    const InteriorPixels inside = interior(reference, std::max({std::abs(whole.x), std::abs(whole.y), most_of(reference)}) + 3);
    const double before = squared_error(reference, test, inside, {});
    if (before == 0) return std::nullopt;
    Shift best{double(whole.x), double(whole.y), 0};
    double least = squared_error(reference, test, inside, best);
    for (Shift at = best; const int i [[maybe_unused]] : {0, 1, 2, 3, 4, 5}) {
        at = refined(reference, test, inside, at);
        if (std::abs(at.x - whole.x) > 1 || std::abs(at.y - whole.y) > 1) break;
        if (const double error = squared_error(reference, test, inside, at); error < least) least = error, best = at;
    }
    best.explained = 1 - least / before;
    return best.explained >= kShiftExplains ? std::optional(best) : std::nullopt;
}

}  // namespace alidade
