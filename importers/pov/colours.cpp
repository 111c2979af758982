// SPDX-License-Identifier: Apache-2.0
/// Colour expressions (POV-Ray reference, 3.3.1.7), as probed: what `rgb` and the others make of a float or a vector, and components behind a colour.
#include "importers/pov/expressions.h"
#include "importers/pov/operators.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <span>

namespace alidade::pov {

namespace {

/// A word that says which components follow.
struct ColourWord {
    WordId word;
    uint8_t terms;
    bool transmit_only;    ///< the fourth is transmit
    bool srgb;
};

constexpr ColourWord kWordsOfColour[] = {
    {"rgb"_w, 3, false, false}, {"rgbf"_w, 4, false, false}, {"rgbt"_w, 4, true, false}, {"rgbft"_w, 5, false, false},
    {"srgb"_w, 3, false, true}, {"srgbf"_w, 4, false, true}, {"srgbt"_w, 4, true, true}, {"srgbft"_w, 5, false, true},
};

const ColourWord* find_colour_word(const Token& token) {
    if (token.kind == TokenKind::word)
        for (const ColourWord& entry : kWordsOfColour)
            if (entry.word == token.id) return &entry;
    return nullptr;
}

/// `alpha` is an old name of `filter`.
int component_of(const Token& token) {
    static constexpr WordId kOrder[] = {"red"_w, "green"_w, "blue"_w, "filter"_w, "transmit"_w};
    if (token.kind == TokenKind::word)
        for (int i = 0; i < 5; ++i)
            if (token.id == kOrder[i]) return i;
    return token.is_word("alpha"_w) ? 3 : -1;
}

constexpr double kSrgb = 0;

constexpr WordId kAssumedGamma = "assumed_gamma"_w;   // clang 14 calls consteval functions that stand in templates

/// What `assumed_gamma` says among items of global_settings: powers of light, or kSrgb.
template <class I> std::optional<double> given_gamma(std::span<const I> items) {
    for (size_t i = 0; i + 1 < items.size(); ++i) {
        if (items[i].kind != Item::Kind::word || items[i].word != kAssumedGamma) continue;
        const I& given = items[i + 1];
        return given.kind == Item::Kind::value && given.value_kind() == Kind::number ? given.number() : kSrgb;
    }
    return std::nullopt;
}

/// What the scene's numbers mean, by the first `assumed_gamma` so far, which may stand in the same block.
double working_gamma(Parser& p, Place at) {
    for (const Value& settings : p.globals)
        if (const std::optional<double> gamma = given_gamma(settings.as<Block>().items())) return *gamma;
    if (const std::optional<double> gamma = given_gamma(std::span<const OpenItem>(p.open_items))) return *gamma;
    p.fail(at, "a colour in sRGB stands before assumed_gamma", "begin with global_settings { assumed_gamma 1 }");
}

/// A component in sRGB (IEC 61966-2-1) as a number of the scene: in single precision throughout, as POV-Ray calculates it.
double from_srgb(double value, double gamma) {
    constexpr double kNeutral = 0.01;        // so near to 1 a gamma counts as 1
    const float v = float(value);
    if (gamma == kSrgb) return double(v);
    const float linear = v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
    return std::abs(gamma - 1) <= kNeutral ? double(linear) : double(std::pow(std::max(linear, 0.0f), float(1 / gamma)));
}

Value from_word(Parser& p, const ColourWord& entry, Standing standing) {
    const Place at = p.peek().place();
    const Value given = parse_expression(p, standing);
    if (!given.numeric()) p.fail(at, fmt::format("a colour is expected, not {}", kind_name(given)));
    if (given.terms > entry.terms && given.kind == Kind::vector) p.warn(at, fmt::format("{} components stand behind {}", given.terms, kWords[entry.word]));
    std::array<double, 5> c = promoted(given, entry.terms);
    if (entry.transmit_only && given.kind == Kind::colour && c[4] != 0) p.warn(at, "behind rgbt a colour's filter is what is transmitted, and its transmit is lost, as in POV-Ray", "write color, or rgbft");
    if (entry.transmit_only) c[4] = c[3], c[3] = 0;
    if (entry.srgb) {
        const double gamma = working_gamma(p, at);
        for (int i = 0; i < 3; ++i) c[i] = from_srgb(c[i], gamma);
    }
    return Value::colour(c);
}

}  // namespace

bool begins_colour(const Token& token) {
    static const std::array<bool, kWordCount> begins = [] {
        std::array<bool, kWordCount> all{};
        for (WordId word : {"color"_w, "colour"_w, "red"_w, "green"_w, "blue"_w, "filter"_w, "transmit"_w, "alpha"_w}) all[word] = true;
        for (const ColourWord& entry : kWordsOfColour) all[entry.word] = true;
        return all;
    }();
    return token.kind == TokenKind::word && begins[token.id];
}

Value parse_colour_components(Parser& p, Value colour, Standing standing) {
    for (;;) {
        const int index = component_of(peek_behind(p, standing));
        if (index < 0) return colour;
        p.next();
        colour.c[index] = double(float(parse_float(p, standing)));
    }
}

Value parse_colour(Parser& p, Standing standing) {
    Token token = p.next();
    const Nested nested(p, token.place());
    if (token.is_word("color"_w) || token.is_word("colour"_w)) token = p.next();
    if (const ColourWord* entry = find_colour_word(token)) return parse_colour_components(p, from_word(p, *entry, standing), standing);
    p.put_back(token);
    if (component_of(token) >= 0) return parse_colour_components(p, Value::colour({}), standing);
    if (!begins_expression(p, token)) {
        const bool twice = token.is_word("color"_w) || token.is_word("colour"_w);
        p.warn(token.place(), twice ? "color stands twice: behind the first there is no colour, which is black, as in POV-Ray" : fmt::format("no colour is given before {}: it is black, as in POV-Ray", p.describe(token)));
        return Value::colour({});
    }
    const Value given = parse_expression(p, standing);
    if (!given.numeric()) p.fail(token.place(), fmt::format("a colour is expected, not {}", kind_name(given)));
    return parse_colour_components(p, Value::colour(promoted(given, 5)), standing);
}

}  // namespace alidade::pov
