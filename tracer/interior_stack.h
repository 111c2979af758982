// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace alidade {

/// The solids that a point is in, in the order in which the ray entered them: what carries the interior (Instance::carrier), and the index of the
/// compiled interior. Solids may overlap: leaving one takes out its own entry, wherever it stands.
class InteriorStack {
  public:
    /// Deeper nesting keeps the innermost entries.
    static constexpr int kDepth = 64;
    struct Entry {
        uint32_t carrier, interior;
    };

    InteriorStack() = default;
    InteriorStack(const InteriorStack& other) { take(other); }
    InteriorStack& operator=(const InteriorStack& other) {
        if (this != &other) take(other);
        return *this;
    }

    bool empty() const { return count_ == 0; }
    std::span<const Entry> entries() const { return {entries_, size_t(count_)}; }
    const Entry& top() const { return entries_[count_ - 1]; }

    void enter(Entry e) {
        if (count_ == kDepth) std::copy(entries_ + 1, entries_ + count_--, entries_);
        entries_[count_++] = e;
    }
    /// Takes out the last entry of `carrier`; false if there is none.
    bool leave(uint32_t carrier) {
        for (int i = count_ - 1; i >= 0; --i) {
            if (entries_[i].carrier != carrier) continue;
            std::copy(entries_ + i + 1, entries_ + count_, entries_ + i);
            --count_;
            return true;
        }
        return false;
    }

  private:
    /// Rays are seldom in more than two solids: for those no function is called.
    void take(const InteriorStack& other) {
        count_ = other.count_;
        if (count_ > 2) std::copy_n(other.entries_, count_, entries_);
        else if (count_ > 0) {
            entries_[0] = other.entries_[0];
            if (count_ > 1) entries_[1] = other.entries_[1];
        }
    }

    Entry entries_[kDepth];   // only the first count_ are ever read
    int count_ = 0;
};

}  // namespace alidade
