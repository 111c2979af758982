// SPDX-License-Identifier: Apache-2.0
#include "topology/edges.h"

#include <numeric>

namespace alidade::topology {

Edges::Edges(const Welded& surface) {
    std::vector<uint32_t> begin(surface.points.size() + 1, 0);   // of the sides whose lower vertex is this
    const auto for_each_side = [&](auto body) {
        for (uint32_t t = 0; t < surface.triangles.size(); ++t)
            for (uint32_t k = 0; surface.sound[t] && k < 3; ++k) body(Side{3 * t + k, surface.triangles[t][int(k)], surface.triangles[t][int((k + 1) % 3)]});
    };
    for_each_side([&](const Side& s) { ++begin[std::min(s.from, s.to) + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    sides_.resize(begin.back());
    std::vector<uint32_t> place = begin;
    for_each_side([&](const Side& s) { sides_[place[std::min(s.from, s.to)]++] = s; });
    for (size_t v = 0; v + 1 < begin.size(); ++v) {
        const auto high = [](const Side& s) { return std::max(s.from, s.to); };
        std::sort(sides_.begin() + begin[v], sides_.begin() + begin[v + 1],
                  [&](const Side& a, const Side& b) { return high(a) != high(b) ? high(a) < high(b) : a.corner < b.corner; });
        for (uint32_t i = begin[v]; i < begin[v + 1]; ++i)
            if (i == begin[v] || high(sides_[i]) != high(sides_[i - 1])) first_.push_back(i);
    }
    first_.push_back(uint32_t(sides_.size()));
}

Sets::Sets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

uint32_t Sets::find(uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
}

void Sets::unite(uint32_t a, uint32_t b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

}  // namespace alidade::topology
