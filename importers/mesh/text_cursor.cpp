// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace alidade::mesh {
namespace {

constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                   1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kLargestExactPower = 22;   // greater powers of ten are no doubles

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// digits x 10^exponent, as far as 19 digits go; the text from `begin` to `end`.
struct Decimal {
    uint64_t digits = 0;
    int exponent = 0;
    int count = 0;         ///< of digits; if they are more than 19, without those that lead with 0
    bool valid = false;
    const char* end = nullptr;
};

/// More than 64 bits may hold.
void read_many_digits(const char* at, const char* end, Decimal& d) {
    for (; at != end; ++at) {
        if (d.count < 19) d.digits = d.digits * 10 + uint64_t(*at - '0');
        d.count += d.digits > 0;
    }
}

const char* read_digits(const char* at, const char* end, Decimal& d) {
    const char* begin = at;
    uint64_t digits = d.digits;
    for (; at != end && is_digit(*at); ++at) digits = digits * 10 + uint64_t(*at - '0');
    if (d.count + (at - begin) > 19) read_many_digits(begin, at, d);
    else d.digits = digits, d.count += int(at - begin);
    return at;
}

/// An unsigned decimal number with an optional exponent.
Decimal read_decimal(const char* at, const char* end) {
    Decimal d;
    const char* begin = at;
    at = read_digits(at, end, d);
    ptrdiff_t digits = at - begin;
    if (at != end && *at == '.') {
        const char* point = ++at;
        at = read_digits(at, end, d);
        digits += at - point;
        d.exponent = -int(std::min<ptrdiff_t>(at - point, 1 << 20));
    }
    d.end = at;
    if (digits == 0) return d;
    d.valid = true;
    if (at == end || (*at != 'e' && *at != 'E')) return d;
    bool negative = false;
    if (++at != end && (*at == '-' || *at == '+')) negative = *at++ == '-';
    d.valid = at != end && is_digit(*at);
    int exponent = 0;
    for (; at != end && is_digit(*at); ++at) exponent = std::min(exponent * 10 + (*at - '0'), 1 << 20);
    d.exponent += negative ? -exponent : exponent;
    d.end = at;
    return d;
}

/// Digits that are exact as a double, times or over a power of ten that is: one rounding, so the nearest double.
/// Source   Clinger, "How to Read Floating Point Numbers Accurately", PLDI 1990, section 3 (the fast case).
bool is_exact_case(const Decimal& d) { return d.count < 20 && d.digits <= uint64_t(1) << 53 && std::abs(d.exponent) <= kLargestExactPower; }

double from_exact_case(const Decimal& d) {
    const double power = kPowersOfTen[std::abs(d.exponent)];
    return d.exponent < 0 ? double(d.digits) / power : double(d.digits) * power;
}

/// The library's reading, which leaves too large and too small open.
double from_library(const char* begin, const Decimal& d) {
    double value = 0;
    const auto [end, error] = std::from_chars(begin, d.end, value);
    if (error == std::errc::result_out_of_range) value = d.exponent + d.count > 0 ? std::numeric_limits<double>::infinity() : 0;
    return value;
}

/// The last digit's unit is value / digits.
bool exceeds_float(const Decimal& d, double value) {
    const double error = std::abs(double(float(value)) - value);
    return error > 0 && (d.count > 19 || error * 2 * double(d.digits) > value);
}

std::string printable(std::string_view text, size_t longest) {
    std::string out(text.substr(0, longest));
    std::replace_if(out.begin(), out.end(), [](char c) { return c == '\t'; }, ' ');
    std::replace_if(out.begin(), out.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; }, '?');
    return out;
}

}  // namespace

void TextCursor::skip_line_end() {
    if (at_ == end_) return;
    const bool cr = *at_ == '\r';
    ++at_;
    if (cr && at_ != end_ && *at_ == '\n') ++at_;
    line_begin_ = at_;
    ++line_;
}

void TextCursor::skip_blank() {
    const bool joint = *at_ == '\\';
    ++at_;
    if (joint) skip_line_end();
}

void TextCursor::next_line() {
    while (at_ != end_ && !is_line_end(*at_)) {
        if (*at_ == '\\' && is_joint()) skip_blank();
        else ++at_;
    }
    skip_line_end();
}

std::string_view TextCursor::word() {
    skip_blanks();
    const char* begin = at_;
    while (!at_word_end()) ++at_;
    return {begin, size_t(at_ - begin)};
}

std::string_view TextCursor::rest_of_line() {
    skip_blanks();
    const char* begin = at_;
    const char* last = at_;
    while (at_ != end_ && !is_line_end(*at_) && !(*at_ == '\\' && is_joint()))
        if (!is_blank(*at_++)) last = at_;
    return {begin, size_t(last - begin)};
}

bool TextCursor::plain_corner(std::array<uint32_t, 3>& numbers) {
    const char *at = at_, *const end = end_;
    numbers = {0, 0, 0};
    for (size_t i = 0;; ++i, ++at) {
        const char* begin = at;
        uint32_t n = 0;
        for (; at != end && is_digit(*at); ++at) n = n * 10 + uint32_t(*at - '0');
        const bool left_out = i == 1 && at == begin, ends = at == end || is_blank(*at) || is_line_end(*at);
        if (at - begin > 9 || (n == 0 && (!left_out || ends))) return false;
        numbers[i] = n;
        if (ends) break;
        if (*at != '/' || i == 2) return false;
    }
    at_ = at;
    return true;
}

std::optional<Number> TextCursor::number() {
    skip_blanks();
    const Mark start = mark();
    const bool negative = accept('-');
    if (!negative) accept('+');
    const char* unsigned_begin = at_;
    const Decimal d = read_decimal(at_, end_);
    at_ = d.end;
    if (!d.valid || !at_word_end()) {
        back_to(start);
        return special_number();
    }
    const double value = is_exact_case(d) ? from_exact_case(d) : from_library(unsigned_begin, d);
    return Number{negative ? -value : value, exceeds_float(d, value)};
}

std::optional<Number> TextCursor::special_number() {
    const Mark start = mark();
    std::string text(word());
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    const bool negative = text.starts_with('-');
    const std::string_view name = std::string_view(text).substr(negative || text.starts_with('+'));
    const bool infinite = name == "inf" || name == "infinity" || name.starts_with("1.#inf");
    if (infinite || name.starts_with("nan") || name.starts_with("1.#ind") || name.starts_with("1.#qnan") || name.starts_with("1.#snan")) {
        const double value = infinite ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
        return Number{negative ? -value : value, false};
    }
    back_to(start);
    return std::nullopt;
}

std::optional<int32_t> TextCursor::integer() {
    const char* start = at_;
    const bool negative = accept('-');
    if (!negative) accept('+');
    constexpr int64_t kMax = std::numeric_limits<int32_t>::max();
    int64_t value = 0;
    const char* digits = at_;
    for (; at_ != end_ && is_digit(*at_); ++at_) value = std::min(value * 10 + (*at_ - '0'), kMax);
    if (at_ == digits) {
        at_ = start;
        return std::nullopt;
    }
    return int32_t(negative ? -value : value);
}

std::string TextCursor::word_at(const Mark& mark) const {
    const char* last = mark.at;
    while (last != end_ && !is_blank(*last) && !is_line_end(*last)) ++last;
    return printable({mark.at, size_t(last - mark.at)}, 40);
}

std::string TextCursor::line_at(const Mark& mark) const {
    constexpr size_t kShown = 160;
    const char* last = mark.line_begin;
    while (last != end_ && !is_line_end(*last) && size_t(last - mark.line_begin) < kShown) ++last;
    return mark.column() > kShown ? std::string() : printable({mark.line_begin, size_t(last - mark.line_begin)}, kShown);
}

}  // namespace alidade::mesh
