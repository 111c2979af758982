// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace alidade::test {

struct Sample {
    std::string name;
    Scene scene;
};

/// Scenes of meshes that pass validate(): made here, read from the assets, and from the shared data where they are.
const std::vector<Sample>& samples();

/// A scene of one node with one mesh of one triangle.
Scene triangle_scene();

}  // namespace alidade::test
