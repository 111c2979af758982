// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/symbols.h"

#include <algorithm>

namespace alidade::pov {

std::vector<Symbols::Binding>& Symbols::of(WordId id) {
    if (id >= bindings_.size()) bindings_.resize(size_t(id) * 2 + 1);
    return bindings_[id];
}

Slot& Symbols::bind(WordId id, size_t level, Ref<Slot> slot) {
    std::vector<Binding>& all = of(id);
    const auto behind = std::find_if(all.begin(), all.end(), [&](const Binding& b) { return b.level > level; });
    levels_[level].push_back(id);
    return *all.insert(behind, {level, std::move(slot)})->slot;
}

void Symbols::leave() {
    const size_t level = --depth_;
    for (WordId id : levels_[level])
        if (!of(id).empty() && of(id).back().level == level) of(id).pop_back();     // #undef may have taken it already
    levels_[level].clear();
}

Slot& Symbols::declare(WordId id) {
    if (Slot* known = find(id)) return *known;
    return bind(id, 0, Ref<Slot>(new Slot));
}

Slot& Symbols::local(WordId id, size_t depth) {
    const size_t level = depth - 1;
    for (Binding& binding : of(id))
        if (binding.level == level) return *binding.slot;
    return bind(id, level, Ref<Slot>(new Slot));
}

Slot& Symbols::global(WordId id) { return local(id, 1); }

void Symbols::alias(WordId id, Ref<Slot> slot) {
    std::vector<Binding>& all = of(id);
    const size_t level = depth_ - 1;
    if (!all.empty() && all.back().level == level) all.back().slot = std::move(slot);
    else bind(id, level, std::move(slot));
}

bool Symbols::undefine(WordId id) {
    if (!find(id)) return false;
    of(id).pop_back();
    return true;
}

}  // namespace alidade::pov
