// SPDX-License-Identifier: Apache-2.0
/// The files that were read, as tokens, and where in them reading stands: a stack of files, includes and macro bodies.
#pragma once

#include "importers/pov/limits.h"
#include "importers/pov/value.h"

#include <span>

namespace alidade::pov {

/// An open #if, #while, #for or #switch.
struct Condition {
    enum class Kind : uint8_t { branch, while_loop, for_loop, switch_ };
    Kind kind = Kind::branch;
    uint32_t opened = 0;          ///< index of its directive in the frame's tokens
    uint32_t body = 0;            ///< of a #for: where a turn begins
    WordId counter = 0;           ///< of a #for
    double last = 0, step = 0;
    std::optional<double> waiting;   ///< of a #switch whose clause is not chosen yet: its value
};

struct Frame {
    const Token* tokens = nullptr;
    uint32_t at = 0, end = 0;
    uint16_t source = 0;
    const Macro* macro = nullptr;    ///< null: a file
    Ref<Macro> hold;                 ///< so that a macro which redefines itself lives on
    Place called_from;
    size_t first_condition = 0;      ///< its conditions stand above this height
};

class TokenStream {
  public:
    /// Lexes a file; its number.
    uint16_t add(Source source, Names& names, const Limits& limits);
    const Source& source(uint16_t number) const { return units_[number]->source; }
    size_t sources() const { return units_.size(); }
    const std::string& text(const Token& token) const { return units_[token.source]->list.texts[token.id]; }
    /// The same with blanks for bytes above 127; null if there are none.
    const std::string* blanked(const Token& token) const {
        const auto& all = units_[token.source]->list.blanked;
        const auto found = all.find(token.id);
        return found == all.end() ? nullptr : &found->second;
    }
    std::span<const double> vector(const Token& token) const {
        const double* count = &units_[token.source]->list.vectors[token.id];
        return {count + 1, size_t(*count)};
    }

    /// The next token of the newest frame as it stands in the text; of kind `end` at the frame's end.
    const Token& raw() {
        Frame& frame = frames_.back();
        if (frame.at >= frame.end) return end_;
        ++tokens_read_;
        return frame.tokens[frame.at++];
    }
    /// Is that a mark as it stands in the text, in the same frame?
    bool goes_on_with(char mark) const { return frames_.back().tokens[frames_.back().at].is(mark); }
    uint64_t tokens_read() const { return tokens_read_; }

    void push_file(uint16_t number, Place from);
    void push_macro(Ref<Macro> macro, Place from);
    void pop();
    std::vector<Frame>& frames() { return frames_; }
    const std::vector<Frame>& frames() const { return frames_; }
    Frame& frame() { return frames_.back(); }
    std::vector<Condition>& conditions() { return conditions_; }
    bool frame_has_conditions() const { return conditions_.size() > frames_.back().first_condition; }

  private:
    struct Unit {
        Source source;
        TokenList list;
    };
    std::vector<std::unique_ptr<Unit>> units_;
    TokenRoom room_;
    std::vector<Frame> frames_;
    std::vector<Condition> conditions_;
    Token end_;
    uint64_t tokens_read_ = 0;
};

}  // namespace alidade::pov
