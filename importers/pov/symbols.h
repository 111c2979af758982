// SPDX-License-Identifier: Apache-2.0
/// What identifiers mean just now. Scoping is dynamic: the file, each include and each macro call is a level, and the newest level that knows a name wins.
#pragma once

#include "importers/pov/value.h"

namespace alidade::pov {

class Symbols {
  public:
    void enter() {
        if (depth_++ == levels_.size()) levels_.emplace_back();
    }
    void leave();
    size_t depth() const { return depth_; }

    /// The slot that `id` means, or null.
    Slot* find(WordId id) const { return id < newest_.size() ? newest_[id] : nullptr; }
    /// Is what `id` means of the present level?
    bool is_at_this_level(WordId id) const { return id < bindings_.size() && !bindings_[id].empty() && bindings_[id].back().level + 1 == depth_; }
    /// #declare: the slot that `id` means, or a new one at the outermost level.
    Slot& declare(WordId id);
    /// #local: the slot at a level (depth() where the directive stands: macros in its value may not have ended yet); made if there is none.
    Slot& local(WordId id, size_t depth);
    /// The slot at the outermost level: what #macro and #fopen make.
    Slot& global(WordId id);
    /// At the present level, `id` is another name of `slot`.
    void alias(WordId id, Ref<Slot> slot);
    /// Takes the newest meaning away; false if there is none.
    bool undefine(WordId id);

  private:
    struct Binding {
        size_t level;
        Ref<Slot> slot;
    };
    std::vector<Binding>& of(WordId id);
    /// After every change of of(id).
    void note_newest(WordId id) { newest_[id] = bindings_[id].empty() ? nullptr : bindings_[id].back().slot.get(); }
    Slot& bind(WordId id, size_t level, Ref<Slot> slot);

    std::vector<std::vector<Binding>> bindings_;    ///< by name, the outermost level first
    std::vector<Slot*> newest_;                     ///< by name: the slot of its last binding; asked for every name that is read
    std::vector<std::vector<WordId>> levels_{1};    ///< the names that each level has bound; those above depth_ are empty, and kept for the next call
    size_t depth_ = 1;
};

}  // namespace alidade::pov
