// SPDX-License-Identifier: Apache-2.0
/// Text in POV-Ray's scene description language: blocks, lines and numbers.
#pragma once

#include "core/transform.h"

#include <span>
#include <string>
#include <string_view>

namespace alidade::pov_export {

/// Red, green, blue, filter, transmit.
struct Rgbft {
    Color color{0};
    double filter = 0, transmit = 0;

    bool is_single() const { return Color(Vec3f(color)) == color && double(float(filter)) == filter && double(float(transmit)) == transmit; }
};

/// A colour to the last digit: words like `rgb` round to single precision for readers that calculate in doubles, and products of a declared colour do not.
/// It may stand where `kUnit` has been declared.
struct ExactColour {
    Rgbft value;
};
inline constexpr const char* kUnit = "Unit";

/// Where POV-Ray takes any expression for a colour: without a word before it, it is not rounded.
struct Expression {
    Color color{0};
};

/// Writes blocks, indented. Numbers have the fewest digits that read back as the same number; what is no number is written as 0, and counted.
class Sdl {
  public:
    /// `word word {`
    template <class... T> void begin(const T&... words) {
        indent();
        (put(words), ...);
        text_ += "{\n";
        ++depth_;
    }
    void end() {
        --depth_;
        indent();
        text_ += "}\n";
    }
    /// Words, strings and numbers with blanks between them.
    template <class... T> void line(const T&... words) {
        indent();
        (put(words), ...);
        text_.back() = '\n';
    }
    /// A comment in words that cannot end it.
    void comment(const std::string& text);
    /// One item of a long list: numbers without indentation, eight or so a line.
    template <class V> void item(const V& value) {
        put(value);
        text_.back() = ',';
        if (++items_ % 8 == 0) text_ += '\n';
    }
    void end_items();

    const std::string& text() const { return text_; }
    std::string take() { return std::move(text_); }
    /// How many numbers were none.
    size_t not_finite() const { return not_finite_; }

  private:
    void indent() { text_.append(2 * size_t(depth_), ' '); }
    void put(std::string_view word) {
        if (!word.empty()) text_ += word, text_ += ' ';
    }
    void put(const std::string& word) { put(std::string_view(word)); }
    void put(const char* word) { put(std::string_view(word)); }
    void put(double x) { number(x), text_ += ' '; }
    void put(int x) { text_ += std::to_string(x), text_ += ' '; }
    void put(size_t x) { text_ += std::to_string(x), text_ += ' '; }
    void put(uint32_t x) { text_ += std::to_string(x), text_ += ' '; }
    void put(std::span<const double> v) { vector(v); }
    void put(const Vec2& v) { vector({v.x, v.y}); }
    void put(const Vec3& v) { vector({v.x, v.y, v.z}); }
    void put(const Index3& v);
    void put(const Rgbft& c);
    void put(const ExactColour& c);
    void put(const Expression& e);
    void put(const Transform& t);
    void number(double x);
    void vector(std::span<const double> values);
    void vector(std::initializer_list<double> values) { vector(std::span(values.begin(), values.size())); }

    std::string text_;
    int depth_ = 0;
    size_t items_ = 0, not_finite_ = 0;
};

/// `"text"` as POV-Ray reads it back.
std::string quoted(const std::string& text);

}  // namespace alidade::pov_export
