// SPDX-License-Identifier: Apache-2.0
/// Functions of strings (POV-Ray reference, 3.3.1.9.4).
#include "importers/pov/builtins/builtins.h"
#include "importers/pov/expressions.h"
#include "importers/pov/integers.h"
#include "importers/pov/utf8.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <ctime>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

/// What is asked for beyond this has no use, and would only fill memory.
constexpr int kMostDigits = 1000;

/// What is longer in str() is written with an exponent, and what is longer even so is no number (by experiment).
constexpr size_t kMostCharacters = 254;

/// A width or precision as a whole number that is no larger.
int at_most(double asked) { return std::clamp(to_int(asked), -kMostDigits, kMostDigits); }

/// POV-Ray's str(): "%*.*f", with zeros in front for a negative width, and six digits for a negative precision.
std::string formatted(double x, double width, double precision) {
    const int w = at_most(width), p = std::max(at_most(precision), -1);
    char digits[kMostDigits + 400];                      // 309 stand before the point of the largest double
    const char* const end = std::to_chars(digits, std::end(digits), x, std::chars_format::fixed, p < 0 ? 6 : p).ptr;
    std::string text(digits, size_t(end - digits));
    const size_t missing = size_t(std::abs(w)) - std::min(size_t(std::abs(w)), text.size());
    const bool zeros = w < 0 && std::isfinite(x);
    text.insert(zeros && std::signbit(x) ? 1 : 0, missing, zeros ? '0' : ' ');
    return text;
}

std::string one_string(Parser& p) {
    p.expect('(', "before the arguments of a function");
    std::string s = parse_string(p);
    close(p);
    return s;
}

Value str(Parser& p, Place) {
    p.expect('(', "behind str");
    const double x = parse_float(p), width = next_float(p), precision = next_float(p);
    p.expect(')', "behind the arguments of str");
    std::string text = formatted(x, width, precision);
    if (text.size() > kMostCharacters) text = fmt::format("{:{}.{}g}", x, std::abs(at_most(width)), precision < 0 ? 6 : at_most(precision));
    return Value::string(text.size() > kMostCharacters ? "<invalid>" : std::move(text));
}

/// vstr(terms, vector, separator, width, precision); from two to five terms are shown whatever is asked for.
Value vstr(Parser& p, Place) {
    p.expect('(', "behind vstr");
    const int terms = std::clamp(to_int(parse_float(p)), 2, 5);
    p.accept(',');
    const Place at = p.peek().place();
    const Value value = parse_expression(p);
    if (!value.numeric()) p.fail(at, fmt::format("a vector is expected, not {}", kind_name(value)));
    const std::array<double, 5>& v = value.c;        // a float is not promoted here
    p.accept(',');
    const std::string separator = parse_string(p);
    const double width = next_float(p), precision = next_float(p);
    p.expect(')', "behind the arguments of vstr");
    std::string all = formatted(v[0], width, precision);
    for (int i = 1; i < terms; ++i) all += separator + formatted(v[i], width, precision);
    return Value::string(std::move(all));
}

Value concat(Parser& p, Place at) {
    p.expect('(', "behind concat");
    std::string all = parse_string(p);
    while (!p.accept(')')) {
        p.accept(',');                                    // as everywhere, commas may be left out
        all += parse_string(p);
        if (all.size() > p.options.limits.string_bytes) p.fail_limit(at, &Limits::string_bytes, fmt::format("a string has more than {} bytes", p.options.limits.string_bytes));
    }
    return Value::string(std::move(all));
}

Value chr(Parser& p, Place at) {
    const int code = to_int(one_float(p));
    if (code < 0 || code > 0xFFFF) p.fail(at, fmt::format("there is no character {}", code));
    std::string s;
    if (code != 0) append_utf8(s, uint32_t(code));
    return Value::string(std::move(s));
}

Value asc(Parser& p, Place) {
    const std::string s = one_string(p);
    return Value::number(s.empty() ? 0 : double(characters(s)[0]));
}

/// The number that a string begins with, decimal or after 0x hexadecimal, or 0.
Value val(Parser& p, Place) {
    const std::string s = one_string(p);
    size_t begin = std::min(s.find_first_not_of(" \t\n"), s.size());
    const bool negative = s[begin] == '-';
    if (negative || s[begin] == '+') ++begin;
    const bool hexadecimal = s[begin] == '0' && (s[begin + 1] == 'x' || s[begin + 1] == 'X');
    double x = 0;
    const auto read = s[begin] == '-' ? std::from_chars_result{} : std::from_chars(s.c_str() + begin + (hexadecimal ? 2 : 0), s.c_str() + s.size(), x, hexadecimal ? std::chars_format::hex : std::chars_format::general);
    if (read.ec == std::errc::result_out_of_range) x = std::strtod(s.c_str() + begin, nullptr);      // infinite, or 0
    return Value::number(negative ? -x : x);
}

Value strlen_(Parser& p, Place) { return Value::number(double(characters(one_string(p)).size())); }

Value strcmp_(Parser& p, Place) {
    p.expect('(', "behind strcmp");
    const std::vector<uint32_t> a = characters(parse_string(p));
    p.accept(',');
    const std::vector<uint32_t> b = characters(parse_string(p));
    p.expect(')', "behind the strings of strcmp");
    const auto [at_a, at_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    return Value::number(double(at_a == a.end() ? 0 : *at_a) - double(at_b == b.end() ? 0 : *at_b));
}

/// substr(string, first, length), counted from 1. From 0 there is nothing, whatever the length (probed).
Value substr(Parser& p, Place at) {
    p.expect('(', "behind substr");
    const std::vector<uint32_t> s = characters(parse_string(p));
    const int first = to_int(next_float(p)), length = to_int(next_float(p));
    p.expect(')', "behind the arguments of substr");
    if (first == 0 && length >= 0) return Value::string("");
    if (first < 1 || length < 0 || int64_t(first) + length - 1 > int64_t(s.size()))
        p.fail(at, fmt::format("the string has {} characters, there are no {} from number {}", s.size(), length, first));
    std::string part;
    for (int i = 0; i < length; ++i) append_utf8(part, s[size_t(first - 1 + i)]);
    return Value::string(std::move(part));
}

template <int (*change)(int)>
Value changed_case(Parser& p, Place) {
    std::string s = one_string(p);
    for (char& c : s) c = char(change(static_cast<unsigned char>(c)));
    return Value::string(std::move(s));
}

/// datetime(days since 2000 [, strftime format]), in UTC.
Value datetime(Parser& p, Place at) {
    p.expect('(', "behind datetime");
    const double days = parse_float(p);
    const std::string format = p.accept(',') ? parse_string(p) : "%Y-%m-%d %H:%M:%SZ";
    p.expect(')', "behind the arguments of datetime");
    constexpr double kSecondsTo2000 = 946684800;
    if (!(std::fabs(days) < 1e9)) p.fail(at, fmt::format("the date of day {} cannot be told", days));
    const std::time_t seconds = std::time_t(std::floor(days * 86400 + kSecondsTo2000));
    std::tm parts{};
    if (!gmtime_r(&seconds, &parts)) p.fail(at, fmt::format("the date of day {} cannot be told", days));
    char text[400];
    if (format.empty()) return Value::string("");
    const size_t size = std::strftime(text, sizeof text, format.c_str(), &parts);
    if (size == 0) p.fail(at, "the format of this date gives nothing, or more than 400 characters");
    return Value::string(std::string(text, size));
}

Value file_exists(Parser& p, Place) {
    const std::string name = one_string(p);
    return Value::number(p.files.kept(name) || p.finder.find(name));
}

constexpr BuiltinEntry kStringFunctions[] = {
    {"str"_w, str}, {"vstr"_w, vstr}, {"concat"_w, concat}, {"chr"_w, chr}, {"asc"_w, asc}, {"val"_w, val}, {"strlen"_w, strlen_}, {"strcmp"_w, strcmp_},
    {"substr"_w, substr}, {"strlwr"_w, changed_case<std::tolower>}, {"strupr"_w, changed_case<std::toupper>}, {"datetime"_w, datetime},
    {"file_exists"_w, file_exists},
};

}  // namespace

std::span<const BuiltinEntry> string_functions() { return kStringFunctions; }

}  // namespace alidade::pov
