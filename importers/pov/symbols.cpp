// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/symbols.h"

namespace alidade::pov {

std::vector<Symbols::Binding>& Symbols::of(WordId id) {
    if (id >= bindings_.size()) bindings_.resize(size_t(id) * 2 + 1), newest_.resize(bindings_.size());
    return bindings_[id];
}

Slot& Symbols::bind(WordId id, size_t level, Ref<Slot> slot) {
    std::vector<Binding>& all = of(id);
    size_t at = all.size();
    while (at > 0 && all[at - 1].level > level) --at;
    levels_[level].push_back(id);
    Slot& bound = *all.insert(all.begin() + std::ptrdiff_t(at), {level, std::move(slot)})->slot;
    note_newest(id);
    return bound;
}

void Symbols::leave() {
    const size_t level = --depth_;
    for (WordId id : levels_[level])
        if (std::vector<Binding>& all = bindings_[id]; !all.empty() && all.back().level == level) {     // #undef may have taken it already
            all.pop_back();
            note_newest(id);
        }
    levels_[level].clear();
}

Slot& Symbols::declare(WordId id) {
    if (Slot* known = find(id)) return *known;
    return bind(id, 0, Ref<Slot>(new Slot));
}

Slot& Symbols::local(WordId id, size_t depth) {
    const size_t level = depth - 1;
    const std::vector<Binding>& all = of(id);
    for (size_t i = all.size(); i-- > 0 && all[i].level >= level; )      // from the newest: of a macro that calls itself there are many
        if (all[i].level == level) return *all[i].slot;
    return bind(id, level, Ref<Slot>(new Slot));
}

Slot& Symbols::global(WordId id) { return local(id, 1); }

void Symbols::alias(WordId id, Ref<Slot> slot) {
    std::vector<Binding>& all = of(id);
    const size_t level = depth_ - 1;
    if (!all.empty() && all.back().level == level) all.back().slot = std::move(slot), note_newest(id);
    else bind(id, level, std::move(slot));
}

bool Symbols::undefine(WordId id) {
    if (!find(id)) return false;
    of(id).pop_back();
    note_newest(id);
    return true;
}

}  // namespace alidade::pov
