// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/bvh.h"

#include "accel/structure.h"

namespace alidade {

template std::unique_ptr<Accelerator> over_triangles<Bvh>(const TriangleView&, const AccelOptions&);
template std::unique_ptr<Accelerator> over_set<Bvh>(std::shared_ptr<const PrimitiveSet>, const AccelOptions&);

template std::unique_ptr<Accelerator> over_triangles<FastBvh>(const TriangleView&, const AccelOptions&);
template std::unique_ptr<Accelerator> over_set<FastBvh>(std::shared_ptr<const PrimitiveSet>, const AccelOptions&);

template std::unique_ptr<Accelerator> over_triangles<CompactBvh>(const TriangleView&, const AccelOptions&);
template std::unique_ptr<Accelerator> over_set<CompactBvh>(std::shared_ptr<const PrimitiveSet>, const AccelOptions&);

}  // namespace alidade
