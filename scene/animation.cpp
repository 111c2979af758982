// SPDX-License-Identifier: Apache-2.0
#include "scene/animation.h"

namespace alidade {

Transform Trs::transform() const {
    // Files round quaternions to float, so they are unit vectors only nearly; a zero one turns nothing.
    const double norm = std::sqrt(dot(rotation, rotation));
    Transform out;
    if (norm > 0) out = Transform::from_quaternion(rotation / norm);
    for (int axis = 0; axis < 3; ++axis) out.linear[axis] *= scale[axis];
    out.translation = translation;
    return out;
}

}  // namespace alidade
