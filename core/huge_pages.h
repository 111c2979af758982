// SPDX-License-Identifier: Apache-2.0
/// Memory for large arrays that are read here and there: in huge pages where the system gives them, so that addresses are found without a walk.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace alidade {

/// At least `alignment` aligned; from two huge pages on, aligned to one. Throws std::bad_alloc.
void* allocate_large(size_t bytes, size_t alignment);
void free_large(void* memory) noexcept;

template <class T> struct HugePageAllocator {
    using value_type = T;

    HugePageAllocator() = default;
    template <class U> HugePageAllocator(const HugePageAllocator<U>&) {}
    T* allocate(size_t count) { return static_cast<T*>(allocate_large(count * sizeof(T), alignof(T))); }
    /// What has no default of its own stays as it is: large arrays are filled by whoever makes them, on all threads.
    template <class U> void construct(U* place) { ::new (static_cast<void*>(place)) U; }
    template <class U, class... Args> void construct(U* place, Args&&... args) { ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...); }
    void deallocate(T* memory, size_t) noexcept { free_large(memory); }
    template <class U> bool operator==(const HugePageAllocator<U>&) const { return true; }
};

template <class T> using LargeVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace alidade
