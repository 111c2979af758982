// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/suggestions.h"

#include "importers/pov/builtins/builtins.h"
#include "importers/pov/expressions.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace alidade::pov {

namespace {

bool is_included(const Parser& p, const std::string& file) {
    for (size_t i = 0; i < p.stream.sources(); ++i)
        if (std::filesystem::path(p.stream.source(uint16_t(i)).path()).filename() == file) return true;
    return false;
}

/// What stands around a name, in the text.
struct Neighbours {
    Token before, behind;
};

Neighbours neighbours(const Parser& p, const Token& name) {
    const Frame& frame = p.stream.frames().back();
    uint32_t at = std::min(frame.at, frame.end);
    while (at > 0 && frame.tokens[at].offset > name.offset) --at;
    if (frame.tokens[at].offset != name.offset || frame.source != name.source) return {};
    return {at > 0 ? frame.tokens[at - 1] : Token(), frame.tokens[at + 1]};
}

/// Behind these a value stands: of the words of the language, none but those that begin one.
bool asks_for_value(const Token& before) {
    return before.kind == TokenKind::mark && std::string_view(",(<=+-*/?:>&|lgn").find(before.mark) != std::string_view::npos;
}

/// Can a word of the language stand between these?
bool fits(WordId word, const Neighbours& around) {
    if (is_directive(word)) return false;
    Token token;
    token.kind = TokenKind::word, token.id = word;
    if (begins_colour(token)) return around.behind.kind == TokenKind::number || around.behind.kind == TokenKind::vector || around.behind.is('<');
    if (around.behind.is('{') || !asks_for_value(around.before)) return true;
    const auto is_constant = [&](const BuiltinEntry& entry) { return entry.word == word; };
    const bool constant = std::any_of(constants().begin(), constants().end(), is_constant);
    return find_builtin(word) && (constant || around.behind.is('('));
}

bool is_one_of(WordId word, std::initializer_list<WordId> words) { return std::find(words.begin(), words.end(), word) != words.end(); }

/// Of blocks: what surely is not meant to stand in another. Others may be out of place, too.
bool is_out_of_place(WordId word, WordId block) {
    if (is_one_of(word, {"camera"_w, "global_settings"_w, "background"_w, "sky_sphere"_w, "light_group"_w})) return true;
    const bool of_surface = is_one_of(block, {"pigment"_w, "normal"_w, "finish"_w}), of_one_shape = is_one_of(block, {"sphere"_w, "plane"_w, "box"_w, "cylinder"_w, "cone"_w, "disc"_w, "torus"_w, "light_source"_w});
    if (is_object(word)) return of_one_shape || is_one_of(block, {"finish"_w, "interior"_w, "camera"_w, "global_settings"_w}) || (of_surface && word != "object"_w);
    return of_surface && is_one_of(word, {"finish"_w, "interior"_w, "material"_w});
}

template <class Items>
std::optional<std::pair<WordId, Place>> out_of_place_in(WordId block, const Items& items) {
    for (const auto& item : items) {
        if (item.kind != Item::Kind::block) continue;
        if (is_out_of_place(item.word, block)) return std::pair(item.word, item.place);
        if (const auto found = out_of_place_in(item.word, item.block().items())) return found;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::pair<WordId, Place>> first_out_of_place(WordId block, std::span<const OpenItem> items) { return out_of_place_in(block, items); }

std::string hint_for_undeclared(Parser& p, const Token& name) {
    const std::string_view text = p.names.text(name.id);
    const Neighbours around = neighbours(p, name);
    constexpr size_t kShortestMeant = 4;   // shorter ones are near to everything, but for rbg
    const auto is_near = [&](WordId id) {
        const std::string_view other = p.names.text(id);
        return text.size() >= kShortestMeant || (other.size() == text.size() && std::is_permutation(text.begin(), text.end(), other.begin()));
    };
    const std::string_view declared = p.names.nearest(text, [&](WordId id) { return id >= kWordCount && is_near(id) && p.symbols.find(id); });
    const std::string_view word = p.names.nearest(text, [&](WordId id) { return id < kWordCount && is_near(id) && fits(id, around); });
    const auto meant = [](std::string_view near) { return fmt::format("did you mean {}?", near); };
    if (around.behind.is('{') && !word.empty() && edit_distance(text, word) == 0) return meant(word);        // Sphere {
    if (const std::string file = include_that_declares(text); !file.empty() && !is_included(p, file)) return fmt::format("{0} declares it: #include \"{0}\"", file);
    const bool as_word = declared.empty() || (!asks_for_value(around.before) && !word.empty() && edit_distance(text, word) < edit_distance(text, declared));
    const std::string_view near = as_word ? word : declared;
    return near.empty() ? "" : meant(near);
}

}  // namespace alidade::pov
