// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace alidade {

/// A list that needs no memory of its own while it has at most N entries.
template <class T, size_t N> class ShortList {
    static_assert(std::is_trivially_destructible_v<T>);

  public:
    ShortList() {}   // `short_` stays as it is
    ShortList(const ShortList& other) : long_(other.long_), count_(other.count_) { copy_short(other); }
    ShortList& operator=(const ShortList& other) {
        if (this == &other) return *this;
        long_ = other.long_, count_ = other.count_;
        copy_short(other);
        return *this;
    }

    void push_back(const T& entry) {
        if (count_ < N) {
            new (short_ + count_++) T(entry);
            return;
        }
        if (count_ == N) long_.assign(short_, short_ + N);
        long_.push_back(entry);
        ++count_;
    }

    size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    T* data() { return count_ <= N ? short_ : long_.data(); }
    const T* data() const { return count_ <= N ? short_ : long_.data(); }
    T& operator[](size_t i) { return data()[i]; }
    const T& operator[](size_t i) const { return data()[i]; }
    T* begin() { return data(); }
    T* end() { return data() + count_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + count_; }
    const T& front() const { return *data(); }

  private:
    void copy_short(const ShortList& other) {
        if (count_ <= N) std::uninitialized_copy(other.short_, other.short_ + count_, short_);
    }

    union {
        T short_[N];
    };
    std::vector<T> long_;   ///< all of them, where they are more
    size_t count_ = 0;
};

}  // namespace alidade
