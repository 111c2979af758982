// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/sdl.h"

#include "exporters/numbers.h"
#include "exporters/output_files.h"

namespace alidade::pov_export {

void Sdl::number(double x) {
    if (!std::isfinite(x)) ++not_finite_, x = 0;
    append_number(text_, x);
}

void Sdl::vector(std::span<const double> values) {
    char before = '<';
    for (const double x : values) text_ += before, number(x), before = ',';
    text_ += "> ";
}

void Sdl::put(const Index3& v) {
    text_ += '<';
    append_number(text_, v.x), text_ += ',';
    append_number(text_, v.y), text_ += ',';
    append_number(text_, v.z), text_ += "> ";
}

/// The word says what follows: a colour without filter and transmit stays short.
void Sdl::put(const Rgbft& c) {
    if (c.filter == 0 && c.transmit == 0) {
        text_ += "color rgb ";
        vector({c.color.x, c.color.y, c.color.z});
    } else {
        text_ += "color rgbft ";
        vector({c.color.x, c.color.y, c.color.z, c.filter, c.transmit});
    }
}

void Sdl::put(const ExactColour& c) {
    if (c.value.is_single()) return put(c.value);
    put(kUnit), put("*");
    vector({c.value.color.x, c.value.color.y, c.value.color.z, c.value.filter, c.value.transmit});
}

void Sdl::put(const Expression& e) {
    const Color& c = e.color;
    if (Color(Vec3f(c)) == c) put(Rgbft{c});
    else if (c.x == c.y && c.y == c.z) put(c.x);
    else put(c);
}

/// Where x, y, z and the origin go.
void Sdl::put(const Transform& t) {
    const Mat3& m = t.linear;
    const Vec3& o = t.translation;
    text_ += "matrix ";
    vector({m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z, o.x, o.y, o.z});
}

void Sdl::comment(const std::string& text) {
    if (text.empty()) return;
    line("//", plain_name(text, "_"));
}

void Sdl::end_items() {
    if (text_.back() == '\n') text_.pop_back();
    if (text_.back() == ',') text_.pop_back();
    text_ += '\n';
    items_ = 0;
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

}  // namespace alidade::pov_export
