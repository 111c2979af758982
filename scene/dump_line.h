// SPDX-License-Identifier: Apache-2.0
/// The lines that dump() is made of.
#pragma once

#include "core/fingerprint.h"
#include "scene/queries.h"

#include <fmt/format.h>

#include <cstring>
#include <iterator>
#include <string_view>

namespace alidade {

/// Numbers stand with the fewest digits that read back as the same number, vectors as <1 2 3>, matrices by columns, lists as [1 2 3], an absent
/// optional as `none`, text in quotes.
template <class T> requires std::is_arithmetic_v<T> void put(std::string& out, T value) { fmt::format_to(std::back_inserter(out), "{}", value); }
template <class Tag> void put(std::string& out, Id<Tag> id) { put(out, id.index); }
void put(std::string& out, const std::string& text);
void put(std::string& out, const SourcePos& at);
void put(std::string& out, CsgKind kind);
void put(std::string& out, Projection projection);
void put(std::string& out, Fit fit);
void put(std::string& out, Wrap wrap);
void put(std::string& out, Filter filter);
void put(std::string& out, WarpKind kind);
void put(std::string& out, PictureMap map);
void put(std::string& out, PictureFilter filter);
void put(std::string& out, PictureCode code);
void put(std::string& out, PictureValue value);
void put(std::string& out, NoiseGenerator generator);
void put(std::string& out, Wave wave);
void put(std::string& out, AlphaMode mode);
void put(std::string& out, AreaLight::Form form);
void put(std::string& out, ChannelPath path);
void put(std::string& out, Interpolation interpolation);
void put(std::string& out, LightUnits units);
void put(std::string& out, SeeThrough what);

template <glm::length_t L, class T> void put(std::string& out, const glm::vec<L, T>& v) {
    for (glm::length_t i = 0; i < L; ++i) out += i ? ' ' : '<', put(out, v[i]);
    out += '>';
}
inline void put(std::string& out, const Mat3& m) {
    for (int column = 0; column < 3; ++column) put(out, m[column]);
}
inline void put(std::string& out, const Transform& t) { put(out, t.linear), put(out, t.translation); }

template <class T> void put(std::string& out, const std::vector<T>& list);
template <class T> void put(std::string& out, const std::optional<T>& value) {
    if (value) put(out, *value);
    else out += "none";
}
template <class T> void put(std::string& out, const std::vector<T>& list) {
    out += '[';
    for (size_t i = 0; i < list.size(); ++i) {
        if (i) out += ' ';
        put(out, list[i]);
    }
    out += ']';
}

/// True only if both are written alike, but found without writing them: most fields have their usual value.
template <class T> bool surely_alike(const T& a, const T& b) {
    if constexpr (std::is_trivially_destructible_v<T>) return std::memcmp(&a, &b, sizeof(T)) == 0;   // owns nothing: its bytes are its value
    else if constexpr (requires { a.empty(); }) return a.empty() && b.empty();
    else return false;
}

/// One line of the dump; ends itself.
class Line {
  public:
    Line(std::string& out, std::string_view head) : out_(out) { out_ += head; }
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;
    ~Line() { out_ += '\n'; }

    /// ` name=value`, unless the value is written like `fallback`.
    template <class T> Line& field(std::string_view name, const T& value, const T& fallback = T()) {
        if (surely_alike(value, fallback)) return *this;
        std::string text, usual;
        put(text, value), put(usual, fallback);
        if (text != usual) out_ += ' ', out_ += name, out_ += '=', out_ += text;
        return *this;
    }
    /// ` name=value`.
    template <class T> Line& always(std::string_view name, const T& value) {
        out_ += ' ', out_ += name, out_ += '=';
        put(out_, value);
        return *this;
    }
    /// ` name=[...]`, unless the list is empty; or ` name=LENGTH:FINGERPRINT`.
    template <class T> Line& list(std::string_view name, const std::vector<T>& values, MeshLists how) {
        static_assert(std::is_trivially_destructible_v<T>);
        if (how == MeshLists::written || values.empty()) return field(name, values);
        return word(fmt::format("{}={}:{:016x}", name, values.size(), fingerprint(std::as_bytes(std::span(values)))));
    }
    /// A word by itself.
    Line& word(std::string_view text) {
        out_ += ' ', out_ += text;
        return *this;
    }

  private:
    std::string& out_;
};

void dump_nodes(std::string& out, const Scene& scene);
void dump_shapes(std::string& out, const Scene& scene, MeshLists lists);
/// Images, signals, materials and interiors.
void dump_surfaces(std::string& out, const Scene& scene);
void dump_function(std::string& out, size_t i, const FunctionProgram& f);
void dump_media(std::string& out, const std::vector<Interior::Medium>& media);

}  // namespace alidade
