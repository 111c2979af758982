// SPDX-License-Identifier: Apache-2.0
/// What every structure finds out before it is built: which primitives there are, and where.
#pragma once

#include "accel/leaf.h"
#include "core/parallel.h"

namespace alidade {

struct SortedOut {
    std::vector<uint32_t> bounded, unbounded, removed;   ///< empty ones are in none
    Bounds bounds;                                       ///< of the bounded ones
};

template <class R, class Source> SortedOut sorted_range(const Source& source, uint32_t first, uint32_t end) {
    SortedOut out;
    BoundsT<R> bounds;
    size_t bounded = 0;
    out.bounded.resize(end - first);
    for (uint32_t id = first; id < end; ++id) {
        switch (source.kind(id)) {
            case PrimitiveKind::bounded: out.bounded[bounded++] = id, bounds.extend(box_of<R>(source, id)); break;
            case PrimitiveKind::unbounded: out.unbounded.push_back(id); break;
            case PrimitiveKind::removed: out.removed.push_back(id); break;
            case PrimitiveKind::empty: break;
        }
    }
    out.bounded.resize(bounded);
    out.bounds = {Vec3(bounds.min), Vec3(bounds.max)};
    return out;
}

/// In the order of their numbers, whatever the number of threads.
template <class R, class Source> SortedOut sort_out(const Source& source, int threads) {
    std::vector<SortedOut> ranges((source.size() + kRange - 1) / kRange);
    for_ranges(source.size(), threads, [&](size_t first, size_t end) { ranges[first / kRange] = sorted_range<R>(source, uint32_t(first), uint32_t(end)); });
    SortedOut all;
    all.bounded.reserve(source.size());
    const auto append = [](std::vector<uint32_t>& to, const std::vector<uint32_t>& from) { to.insert(to.end(), from.begin(), from.end()); };
    for (const SortedOut& range : ranges) {
        append(all.bounded, range.bounded), append(all.unbounded, range.unbounded), append(all.removed, range.removed);
        all.bounds.extend(range.bounds);
    }
    return all;
}

}  // namespace alidade
