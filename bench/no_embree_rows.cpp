// SPDX-License-Identifier: Apache-2.0
#include "bench/workload.h"

namespace alidade::bench {

void register_embree_rows(const std::shared_ptr<const Workload>&) {}

}  // namespace alidade::bench
