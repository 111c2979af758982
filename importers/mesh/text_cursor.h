// SPDX-License-Identifier: Apache-2.0
/// Reading the line-based text of OBJ and MTL files: words, numbers, and where they stand.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace alidade::mesh {

/// A number as the file writes it.
struct Number {
    double value = 0;
    bool exceeds_float = false;   ///< the file says more than a float can hold: rounding to float moves it by over half a unit of its last digit
};

/// A reading position in a text. A line ends with LF, CR LF or CR; a backslash before the end joins the next line to it, and counts as a blank.
/// Columns count bytes, from 1.
class TextCursor {
  public:
    /// A place in the text, to be named later.
    struct Mark {
        const char* at;
        const char* line_begin;
        uint32_t line;

        uint32_t column() const { return uint32_t(at - line_begin) + 1; }
    };

    explicit TextCursor(std::string_view text) : at_(text.data()), end_(at_ + text.size()), line_begin_(at_) {}

    bool at_end() const { return at_ == end_; }
    /// Skips blanks; true if nothing but a comment is left of the line.
    bool at_line_end() {
        skip_blanks();
        return at_ == end_ || is_line_end(*at_) || *at_ == '#';
    }
    /// Is the next character one that ends a word?
    bool at_word_end() const { return at_ == end_ || is_blank(*at_) || is_line_end(*at_) || (*at_ == '\\' && is_joint()); }
    bool accept(char c) { return at_ != end_ && *at_ == c && (++at_, true); }

    /// Moves to the start of the next line.
    void next_line();
    /// Up to the next blank or end of the line; empty at the end of the line.
    std::string_view word();
    /// All that is left of the line, without blanks around it; a name may hold blanks and #.
    std::string_view rest_of_line();
    /// A word that is a decimal number, correctly rounded; "nan", "inf" and what C libraries make of them count. Nothing, and the cursor stays,
    /// if it is no number. Too large is infinite, too small is 0.
    std::optional<Number> number();
    /// A word v, v/vt, v//vn or v/vt/vn of whole numbers above 0 of at most 9 digits, as nearly all faces have them; 0 for one that is left out. False, and
    /// the cursor stays, if there is anything else.
    bool plain_corner(std::array<uint32_t, 3>& numbers);
    /// A decimal integer; nothing, and the cursor stays, if there is none. Beyond 32 bits it is the nearest one that fits.
    std::optional<int32_t> integer();

    Mark mark() const { return {at_, line_begin_, line_}; }
    void back_to(const Mark& mark) { at_ = mark.at, line_begin_ = mark.line_begin, line_ = mark.line; }
    /// The word at a mark, shortened and fit to be printed.
    std::string word_at(const Mark& mark) const;
    /// The line of a mark, shortened and fit to be printed; empty if the marked column lies beyond that.
    std::string line_at(const Mark& mark) const;

  private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
    bool is_joint() const { return at_ + 1 == end_ || is_line_end(at_[1]); }
    void skip_blanks() {
        while (at_ != end_ && (is_blank(*at_) || (*at_ == '\\' && is_joint()))) skip_blank();
    }
    void skip_blank();
    void skip_line_end();
    std::optional<Number> special_number();

    const char* at_;
    const char* end_;
    const char* line_begin_;
    uint32_t line_ = 1;
};

}  // namespace alidade::mesh
