// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/token_stream.h"

namespace alidade::pov {

uint16_t TokenStream::add(Source source, Names& names, const Limits& limits) {
    const uint16_t number = uint16_t(units_.size());
    auto unit = std::make_unique<Unit>(Unit{std::move(source), {}});
    unit->list = lex(unit->source, number, names, limits.tokens_in_file, room_);
    units_.push_back(std::move(unit));
    return number;
}

void TokenStream::push_file(uint16_t number, Place from) {
    const TokenList& list = units_[number]->list;
    frames_.push_back({list.tokens.data(), 0, uint32_t(list.tokens.size() - 1), number, nullptr, {}, from, conditions_.size()});
}

void TokenStream::push_macro(Ref<Macro> macro, Place from) {
    const Macro* body = macro.get();
    frames_.push_back({units_[body->source]->list.tokens.data(), body->begin, body->end, body->source, body, std::move(macro), from, conditions_.size()});
}

void TokenStream::pop() {
    conditions_.resize(frames_.back().first_condition);
    frames_.pop_back();
}

}  // namespace alidade::pov
