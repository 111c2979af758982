// SPDX-License-Identifier: Apache-2.0
/// What can be asked of a part of a scene without rendering it: what a ray meets first, and which points are inside.
#pragma once

#include "accel/accelerator.h"
#include "eval/csg.h"
#include "scene/scene.h"

#include <map>
#include <memory>
#include <optional>

namespace alidade {

class BoundTests;
class BoundedPaths;

/// The accelerators of a scene's meshes, each built when it is first asked for. The scene may grow meanwhile.
class MeshAccelerators {
  public:
    explicit MeshAccelerators(const Scene& scene) : scene_(scene) {}
    const Accelerator& of(ShapeId shape);

  private:
    const Scene& scene_;
    std::map<uint32_t, std::unique_ptr<Accelerator>> made_;
};

/// Where a ray meets a surface.
struct FoundSurface {
    Vec3 point{0};
    Vec3 normal{0};         ///< unit, outwards, whichever side the ray comes from: of a smooth triangle, interpolated; of a part that is taken away, turned round
    ShapeId shape;
    uint32_t part = 0;      ///< of the shape (Hit::part)
    double t = 0;           ///< along the ray
    uint32_t leaf = 0;      ///< of the query: which of its shapes
    uint32_t slot = 0;      ///< the material slot of the shape
    bool facet = false;     ///< a triangle without normals of its own: outwards is where its corners are seen counter-clockwise
};

/// A node with all below it, as a solid. Shapes whose transform has no inverse are left out.
///
/// Method   the whole is one CsgTree over the shapes that the node leads to; meshes have their accelerators.
/// Error    that of the shapes' own crossings (eval/shapes), and the roundings of the transform.
class SolidQuery {
  public:
    /// Both must outlive the query. The nodes below `root` must be acyclic; they may not change any more. Space is that of the root's parent,
    SolidQuery(const Scene& scene, NodeId root, MeshAccelerators& meshes) : SolidQuery(scene, root, meshes, scene.nodes[root.index].to_parent) {}
    /// or that to which `placed` leads from the root's own. `clipped` false: without what clips the root itself.
    SolidQuery(const Scene& scene, NodeId root, MeshAccelerators& meshes, const Transform& placed, bool clipped = true);
    ~SolidQuery();
    SolidQuery(SolidQuery&&) noexcept;

    /// Does it stand for all that the node leads to? Not where more than a million paths lead to its parts, or one of more than a thousand levels.
    bool complete() const { return complete_; }
    /// The nearest surface with tmin <= t <= tmax, of all that a camera sees that misses nothing that bounds it.
    std::optional<FoundSurface> first(const Ray& ray) const {
        uint64_t unused = 0;
        return first(ray, unused);
    }
    /// All surfaces that any ray sees on the line, bounded or not, appended in order of t.
    void all(const Ray& ray, std::vector<FoundSurface>& out) const;
    bool inside(const Vec3& point) const {
        uint64_t unused = 0;
        return inside(point, unused);
    }
    /// The same; `work` grows by the number of shapes that were looked at.
    std::optional<FoundSurface> first(const Ray& ray, uint64_t& work) const;
    bool inside(const Vec3& point, uint64_t& work) const;
    /// The box of all surfaces, infinite where they are; empty if there are none.
    Bounds bounds() const { return tree_ ? tree_->bounds() : Bounds(); }
    /// Of the root or a node below it; nothing if none of them carries one.
    std::optional<MaterialId> material(const FoundSurface& at) const;
    /// How many shapes it looks at.
    size_t size() const { return shapes_.size(); }

  private:
    class Parts;
    class Leaves;
    struct PlacedShape {
        ShapeId shape;
        Transform to_world, to_local;
        const Accelerator* triangles = nullptr;   ///< null for closed forms
        const ShapeOps* ops = nullptr;            ///< null for meshes
        bool inverted = false;
        NodeId node;
        std::optional<MaterialId> inherited;      ///< what its parents give it
        uint32_t bound_test = kNoId;              ///< of bounds_
    };

    FoundSurface surface(const Ray& ray, const Hit& hit) const;
    void find_bounds(const BoundedPaths& bounded, const Transform& placed);

    const Scene& scene_;
    std::vector<PlacedShape> shapes_;
    std::optional<CsgTree> tree_;                 ///< none where there are no shapes
    std::unique_ptr<BoundTests> bounds_;          ///< none where nothing is bounded
    bool complete_ = true;
};

}  // namespace alidade
