// SPDX-License-Identifier: Apache-2.0
#include "scene/dump_line.h"

namespace alidade {

void put(std::string& out, const std::string& text) {
    out += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\', out += c;
        else if (static_cast<unsigned char>(c) < 0x20) out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        else out += c;
    }
    out += '"';
}

void put(std::string& out, const SourcePos& at) {
    out += at.file == kNoFile ? std::string("-") : fmt::format("{}", at.file);
    out += fmt::format(":{}:{}", at.line, at.column);
    if (!at.pointer.empty()) out += ':', put(out, at.pointer);
}

void put(std::string& out, CsgKind kind) {
    static constexpr const char* kNames[] = {"none", "union", "merge", "intersection", "difference"};
    out += kNames[size_t(kind)];
}

void put(std::string& out, Projection projection) {
    static constexpr const char* kNames[] = {"perspective", "orthographic", "fisheye",     "ultra_wide_angle",
                                             "omnimax",     "panoramic",    "cylindrical", "spherical"};
    out += kNames[size_t(projection)];
}

void put(std::string& out, Fit fit) {
    static constexpr const char* kNames[] = {"stretch", "show_all", "height"};
    out += kNames[size_t(fit)];
}

void put(std::string& out, Wrap wrap) {
    static constexpr const char* kNames[] = {"repeat", "clamp", "mirror", "once"};
    out += kNames[size_t(wrap)];
}

void put(std::string& out, Filter filter) { out += filter == Filter::nearest ? "nearest" : "linear"; }

void put(std::string& out, WarpKind kind) {
    static constexpr const char* kNames[] = {"transform",   "turbulence", "black_hole", "repeat", "planar",
                                             "cylindrical", "spherical",  "toroidal",   "cubic"};
    out += kNames[size_t(kind)];
}

void put(std::string& out, PictureMap map) {
    static constexpr const char* kNames[] = {"planar", "spherical", "cylindrical", "toroidal"};
    out += kNames[size_t(map)];
}

void put(std::string& out, PictureFilter filter) {
    static constexpr const char* kNames[] = {"none", "bilinear", "bicubic", "distance"};
    out += kNames[size_t(filter)];
}

void put(std::string& out, PictureCode code) {
    static constexpr const char* kNames[] = {"stored", "told_or_srgb", "told_or_stored", "srgb", "power"};
    out += kNames[size_t(code)];
}

void put(std::string& out, PictureValue value) {
    static constexpr const char* kNames[] = {"grey", "transmission", "palette", "number"};
    out += kNames[size_t(value)];
}

void put(std::string& out, NoiseGenerator generator) { put(out, int(generator)); }

void put(std::string& out, Wave wave) {
    static constexpr const char* kNames[] = {"ramp", "sine", "triangle", "scallop", "cubic", "poly"};
    out += kNames[size_t(wave)];
}

void put(std::string& out, AlphaMode mode) {
    static constexpr const char* kNames[] = {"opaque", "mask", "blend"};
    out += kNames[size_t(mode)];
}

void put(std::string& out, AreaLight::Form form) {
    static constexpr const char* kNames[] = {"rectangle", "disc", "sphere"};
    out += kNames[size_t(form)];
}

void put(std::string& out, ChannelPath path) {
    static constexpr const char* kNames[] = {"translation", "rotation", "scale", "weights"};
    out += kNames[size_t(path)];
}

void put(std::string& out, Interpolation interpolation) {
    static constexpr const char* kNames[] = {"step", "linear", "cubic"};
    out += kNames[size_t(interpolation)];
}

void put(std::string& out, SeeThrough what) { out += what == SeeThrough::all ? "all" : what == SeeThrough::black ? "black" : "opaque"; }
void put(std::string& out, LightUnits units) { out += units == LightUnits::radiometric ? "radiometric" : "photometric"; }

}  // namespace alidade
