// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"
#include "scene/validation.h"

namespace alidade {

Diagnostics validate(const Scene& scene) {
    Validation v(scene);
    check_references(v);
    check_functions(v);
    if (v.found.has_errors()) return v.found;   // the other checks follow these references
    check_shapes(v);
    check_surfaces(v);
    check_lights_and_cameras(v);
    check_atmosphere(v);
    check_graph(v);
    check_animations(v);
    check_deformations(v);
    return v.found;
}

}  // namespace alidade
