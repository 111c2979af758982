// SPDX-License-Identifier: Apache-2.0
/// Large arrays that are read where they stand: in memory of their own, or in a mapped file.
#pragma once

#include "core/huge_pages.h"

#include <memory>
#include <span>

namespace alidade {

template <class T> class LargeArray {
  public:
    LargeArray() = default;
    LargeArray(LargeVector<T> own) : own_(std::move(own)), view_(own_) {}
    /// Of memory that lives as long as `keeper`.
    LargeArray(std::span<const T> view, std::shared_ptr<const void> keeper) : keeper_(std::move(keeper)), view_(view) {}
    LargeArray(LargeArray&&) = default;
    LargeArray& operator=(LargeArray&&) = default;

    const T* data() const { return view_.data(); }
    size_t size() const { return view_.size(); }
    const T& operator[](size_t i) const { return view_[i]; }
    std::span<const T> view() const { return view_; }
    size_t bytes() const { return (keeper_ ? view_.size() : own_.capacity()) * sizeof(T); }

    /// To be changed: what was somebody else's becomes a copy.
    std::span<T> writable() {
        if (keeper_) own_.assign(view_.begin(), view_.end()), keeper_.reset(), view_ = own_;
        return own_;
    }

  private:
    LargeVector<T> own_;
    std::shared_ptr<const void> keeper_;
    std::span<const T> view_;
};

}  // namespace alidade
