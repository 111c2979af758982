// SPDX-License-Identifier: Apache-2.0
/// What can be asked of a Scene without rendering it.
#pragma once

#include "core/diagnostics.h"
#include "scene/scene.h"

#include <functional>

namespace alidade {

/// Checks everything that later stages rely on: ids in range, an acyclic graph, finite numbers, attribute sizes, triangle indices, invertible
/// transforms of what is drawn. Errors make the scene unusable; warnings name what will be left out.
Diagnostics validate(const Scene& scene);

/// A thing that a scene may need and that costs something where it is modelled.
enum class Requirement {
    textures, alpha_mask, alpha_blend, normal_maps, vertex_colors, emission, mirror, transmission, absorption, media, fog,
    point_lights, spot_lights, directional_lights, area_lights, environment, csg, clipping, instances, mirrored_instances,
    analytic_shapes, unbounded_shapes, meshes, animation, skins, morphs, depth_of_field, orthographic, patterns, functions,
};
const char* name(Requirement r);

struct RequiredBy {
    Requirement what;
    size_t count = 0;        ///< how many things ask for it
    SourcePos first;         ///< the first of them
};

/// What the part of `scene` that can be reached from its roots requires, in the order of the enumeration.
std::vector<RequiredBy> requirements(const Scene& scene);

/// The scene with its morph targets and skins applied as its nodes and weights stand; a still without them and without animations. A mesh is copied
/// for each skin and each set of weights that nodes show it with. Skinned meshes are where their joints put them: in nodes of their own, which are
/// added at the end and are roots; the nodes that held them hold nothing. All other ids stay. The scene must have passed validate().
Scene deform(Scene scene);

/// The scene at `time` seconds, deformed: all animations at once, each clamped to its range. The scene must have passed validate().
Scene pose(const Scene& scene, double time);

/// One line a thing, numbers with the fewest digits that read back as the same number: equal scenes give equal text. What meshes have millions of
/// is written, or stands as its fingerprint (core/fingerprint.h), as the bytes of pictures always do.
enum class MeshLists { written, fingerprints };
std::string dump(const Scene& scene, MeshLists lists = MeshLists::written);

/// A node reached from a root, with everything that it inherits on the way.
struct Visit {
    NodeId node;
    Transform to_world;
    std::vector<NodeId> path;   ///< from the root to the node
};
/// In what order siblings are visited: as the document has them, or so that of parts that coincide the one that POV-Ray shows comes first: below a union that
/// is a whole that is the last (probed).
enum class SiblingOrder : uint8_t { document, seen_first };

/// Calls `visitor` for every path from a root to a node. Hidden subtrees are left out. `visitor` returns false to end the walk.
/// The scene must have passed validate().
void visit_paths(const Scene& scene, const std::function<bool(const Visit&)>& visitor, SiblingOrder order = SiblingOrder::document);

/// How many paths visit_paths() would walk, and those through what clips a node, in time linear in the graph: thirty levels of two references each are
/// already a billion. The scene must have passed validate().
double path_count(const Scene& scene);
/// The same of each node: the paths that begin there; 0 of one that is hidden.
std::vector<double> path_counts(const Scene& scene);

/// All signals reachable from `root`, itself included, appended to `out`.
void collect_signals(const Scene& scene, SignalId root, std::vector<SignalId>& out);

/// May light pass where the pigment `root` is? If one of its colours filters or transmits, or if it has pictures, whose alpha transmits.
bool lets_light_through(const Scene& scene, SignalId root);

/// The box of everything bounded that can be seen, in world space (empty if there is none). Cheap: boxes of boxes.
Bounds world_bounds(const Scene& scene);

/// The material of slot `slot` of the shape at the end of `path`: that of the nearest node, from the shape upwards, that says something of it. An
/// ancestor's first material covers all slots.
std::optional<MaterialId> inherited_material(const Scene& scene, const std::vector<NodeId>& path, uint32_t slot);

/// The same with the place in `path` of the node that carries it: in that node's space its patterns are looked up.
struct CarriedMaterial {
    MaterialId material;
    size_t carrier = 0;
};
std::optional<CarriedMaterial> carried_material(const Scene& scene, const std::vector<NodeId>& path, uint32_t slot);
/// That of the inside, of all slots; without one that of the outside is seen from inside, too.
std::optional<CarriedMaterial> carried_inside_material(const Scene& scene, const std::vector<NodeId>& path);

}  // namespace alidade
