// SPDX-License-Identifier: Apache-2.0
/// No structure at all: the oracle of all others.
#pragma once

#include "accel/accelerator.h"
#include "accel/query.h"

namespace alidade {

template <class Leaf> class Brute {
  public:
    Brute(BuildInput<typename Leaf::Source>& input, const AccelOptions&, BuildStats& stats)
        : first_(uint32_t(input.order.size())), count_(uint32_t(input.ids.size())) {
        input.order.insert(input.order.end(), input.ids.begin(), input.ids.end());
        stats.leaves = count_ ? 1 : 0;
        stats.sah_cost = count_;
    }
    template <class Query> void traverse(const LocalRay&, Query& query, WorkCounters&) const { query.visit(first_, count_); }
    size_t bytes() const { return 0; }

  private:
    uint32_t first_, count_;
};

}  // namespace alidade
