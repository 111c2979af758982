// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

namespace alidade::test {

/// A valid scene with one of everything that a scene can hold.
///
///   0 root ── 1 mesh (skinned, morphed, animated) ── 2 joint
///         ├── 3 sphere (CSG with 4), clipped by 6
///         ├── 4 plane
///         ├── 5 light, looks like 7
///         └── 8 camera
Scene sample_scene();

/// Parts of the sample scene.
inline Mesh& mesh(Scene& s) { return std::get<Mesh>(s.shapes[3].geometry); }
inline GltfPbr& gltf(Scene& s) { return std::get<GltfPbr>(s.materials[0].layers[0]); }
inline PovFinish& pov(Scene& s) { return std::get<PovFinish>(s.materials[1].layers[0]); }

/// A node that holds `what`.
template <class Id> Node node_with(Id what) {
    Node node;
    node.what = what;
    return node;
}

/// A scene of one node tree: `nodes`, the first of which is the root, and unit spheres as shape 0.
Scene scene_of(std::vector<Node> nodes);

}  // namespace alidade::test
