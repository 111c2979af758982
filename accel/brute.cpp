// SPDX-License-Identifier: Apache-2.0
#include "accel/brute.h"

#include "accel/structure.h"

namespace alidade {

template std::unique_ptr<Accelerator> over_triangles<Brute>(const TriangleView&, const AccelOptions&);
template std::unique_ptr<Accelerator> over_set<Brute>(std::shared_ptr<const PrimitiveSet>, const AccelOptions&);

}  // namespace alidade
