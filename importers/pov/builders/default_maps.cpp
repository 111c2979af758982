// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/default_maps.h"

#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/pigments.h"

#include <span>

namespace alidade::pov {

namespace {

struct Entry {
    float value;
    Color color;
};

constexpr Color kRed(1, 0, 0), kGreen(0, 1, 0), kBlue(0, 0, 1), kCyan(0, 1, 1), kMagenta(1, 0, 1), kYellow(1, 1, 0), kWhite(1), kBlack(0);

constexpr Entry kGray[] = {{0, kBlack}, {1, kWhite}};
constexpr Entry kBozo[] = {{.4f, kWhite}, {.4f, kGreen}, {.6f, kGreen}, {.6f, kBlue}, {.8f, kBlue}, {.8f, kRed}};
constexpr Entry kWood[] = {{.6f, {.666, .312, .2}}, {.6f, {.4, .1333, .066}}};
constexpr Entry kAgate[] = {{0, kWhite}, {.5f, {.95, .75, .5}}, {.5f, {.9, .7, .5}}, {.6f, {.9, .7, .4}}, {.6f, {1, .7, .4}}, {1, {.6, .3, 0}}};
constexpr Entry kMarble[] = {{0, {.9, .8, .8}}, {.9f, {.9, .08, .08}}, {.9f, kBlack}};
constexpr Entry kRadial[] = {{0, kCyan}, {.333f, kYellow}, {.666f, kMagenta}, {1, kCyan}};
constexpr Entry kMandel[] = {{.001f, kBlack}, {.001f, kCyan}, {.012f, kYellow}, {.015f, kMagenta}, {.1f, kCyan}};
constexpr Entry kBrick[] = {{0, Color(.5)}, {1, {.6, .15, .15}}};
constexpr Entry kBlocks[] = {{0, kBlue}, {1, kGreen}, {2, kRed}};
constexpr Entry kFaces[] = {{0, kRed}, {1, kGreen}, {2, kBlue}, {3, kYellow}, {4, kCyan}, {5, kMagenta}};

struct Row {
    std::string_view pattern;
    std::span<const Entry> map;
};
constexpr Row kRows[] = {{"bozo", kBozo}, {"wood", kWood}, {"agate", kAgate}, {"marble", kMarble}, {"radial", kRadial}, {"mandel", kMandel}, {"brick", kBrick},
                         {"checker", kBlocks}, {"hexagon", kBlocks}, {"square", kFaces}, {"triangular", kFaces}, {"cubic", kFaces}};

/// Of the Mandelbrot sets, that of z^2 + c alone has colours.
bool is_higher_mandel(const PatternSignal& s) {
    constexpr size_t kExponent = 1;
    return s.pattern == "mandel" && s.parameters.size() > kExponent && s.parameters[kExponent] != 2;
}

std::span<const Entry> usual(const PatternSignal& s) {
    if (is_higher_mandel(s)) return kGray;
    for (const Row& row : kRows)
        if (row.pattern == s.pattern) return row.map;
    return kGray;
}

}  // namespace

void add_default_map(Build& build, PatternSignal& s) {
    const std::span<const Entry> map = usual(s);
    const size_t length = list_length(s);
    if (!length && !s.map.empty()) return;
    const size_t wanted = length ? length : map.size();
    for (size_t i = s.map.size(); i < wanted; ++i) {
        const Vec3f c(map[i].color);   // POV-Ray keeps colours in single precision
        s.map.push_back({double(map[i].value), add_colour(build, {c.x, c.y, c.z, 0, 0}, {})});
    }
}

}  // namespace alidade::pov
