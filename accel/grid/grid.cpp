// SPDX-License-Identifier: Apache-2.0
#include "accel/grid/grid.h"

#include "accel/structure.h"

namespace alidade {

template std::unique_ptr<Accelerator> over_triangles<Grid>(const TriangleView&, const AccelOptions&);
template std::unique_ptr<Accelerator> over_set<Grid>(std::shared_ptr<const PrimitiveSet>, const AccelOptions&);

}  // namespace alidade
