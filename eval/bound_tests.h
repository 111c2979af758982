// SPDX-License-Identifier: Apache-2.0
/// What rays miss because they miss what bounds it (Node::bounds).
#pragma once

#include "eval/solid_query.h"

#include <vector>

namespace alidade {

/// POV-Ray trusts `bounded_by`: a ray that neither begins in one of the shapes nor comes to it, however far away that is, sees nothing of what they bound. What is inside of a part of a solid stays
/// inside: such a ray sees the hole that the part leaves, and not its walls.
/// Source   experiments with POV-Ray 3.7
class BoundTests {
  public:
    /// The scene must outlive this, and the nodes may not change any more.
    explicit BoundTests(const Scene& scene) : scene_(scene), meshes_(scene) {}

    /// Is a node on the path bounded?
    static bool bounded(const Scene& scene, const std::vector<NodeId>& path);
    /// The number of a test for what stands at the end of `path`, whose first node `placed` places, and has its surface in the box `surface`. kNoId where it would surely be passed.
    uint32_t by_shapes(const std::vector<NodeId>& path, const Transform& placed, const Bounds& surface);
    /// The same where the box around what bounds it counts alone, and only if it is smaller than that of the surface: so it is with most shapes that stand alone.
    uint32_t by_boxes(const std::vector<NodeId>& path, const Transform& placed, const Bounds& surface);
    bool passes(uint32_t test, const Ray& ray) const;

  private:
    /// A shape that bounds a node, in the space of that.
    struct Bound {
        SolidQuery solid;
        bool convex = false;
        const ShapeOps* ops = nullptr;         ///< of a closed form that stands alone, which is asked without the solid; else null
        const ShapeGeometry* shape = nullptr;
        Bounds own;                            ///< of the shape
        Transform to_shape;
    };
    /// One of a test.
    struct Placed {
        const Bound* bound = nullptr;
        Transform to_local;
    };
    struct Test {
        std::vector<Placed> shapes;
        Bounds box{Vec3(-kInf), Vec3(kInf)};   ///< all that passes meets it
    };
    const std::vector<Bound>& bounds_of(NodeId node);
    void ask_shape(Bound& bound, NodeId node) const;
    static bool meets(const Bound& bound, const Ray& ray);
    uint32_t add(Test test);

    const Scene& scene_;
    MeshAccelerators meshes_;
    std::map<uint32_t, std::vector<Bound>> bounds_;   ///< by node
    std::vector<Test> tests_;
};

}  // namespace alidade
