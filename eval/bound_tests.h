// SPDX-License-Identifier: Apache-2.0
/// What rays miss because they miss what bounds it (Node::bounds).
#pragma once

#include "eval/kept_boxes.h"
#include "eval/solid_query.h"

#include <vector>

namespace alidade {

/// POV-Ray trusts `bounded_by`: a ray that neither begins in one of the shapes nor comes to it, however far away that is, sees nothing of what they bound. What is inside of a part of a solid stays
/// inside: such a ray sees the hole that the part leaves, and not its walls.
/// Source   experiments with POV-Ray 3.7
class BoundTests {
  public:
    /// The scene must outlive this, and the nodes may not change any more.
    explicit BoundTests(const Scene& scene) : scene_(scene), meshes_(scene), boxes_(scene) {}

    /// Is a node on the path bounded?
    static bool bounded(const Scene& scene, const std::vector<NodeId>& path);
    /// The number of a test for what stands at the end of `path`, whose first node `placed` places, always the same way, and has its surface in the box `surface`. kNoId where it would surely be passed.
    /// Paths that begin with the same nodes should be asked for one after the other, so that they share tests.
    uint32_t by_shapes(const std::vector<NodeId>& path, const Transform& placed, const Bounds& surface);
    /// The box that POV-Ray keeps of the object at the end of `path`: with what clips and bounds it, where that is smaller.
    Bounds kept_box(const std::vector<NodeId>& path, const Transform& placed);
    /// The number of a test that passes what passes the test `before` and meets the box that is kept of an object. `before` itself where the box holds the surface.
    uint32_t in_box(uint32_t before, const Bounds& kept, const Bounds& surface);
    bool passes(uint32_t test, const Ray& ray) const;

  private:
    /// A shape that bounds a node, in the space of that.
    struct Bound {
        SolidQuery solid;
        bool convex = false;
        bool has_discs = false;                ///< which hold all that is on one side of them: a ray that begins there must meet the box
        const ShapeOps* ops = nullptr;         ///< of a closed form that stands alone, which is asked without the solid; else null
        const ShapeGeometry* shape = nullptr;
        Bounds own;                            ///< of the shape
        Transform to_shape;
    };
    /// What passes a test meets a shape or a box, and passes those before it: what stands deep in bounds shares the tests of all around it.
    struct Test {
        const Bound* shape = nullptr;          ///< null: the box
        Transform to_local;                    ///< of the shape
        Bounds box;
        uint32_t before = kNoId;
        bool passes(const Ray& ray) const;
    };
    /// A node of the path that was asked for last.
    struct Step {
        NodeId node;
        Transform to_world;
        std::optional<Transform> to_local;                                   ///< where something bounds it
        std::map<std::pair<uint32_t, const Bound*>, uint32_t> tests;         ///< by the test before and the shape
    };
    void follow(const std::vector<NodeId>& path, const Transform& placed);
    const std::vector<Bound>& bounds_of(NodeId node);
    void ask_shape(Bound& bound, NodeId node) const;
    static bool meets(const Bound& bound, const Ray& ray);

    const Scene& scene_;
    MeshAccelerators meshes_;
    KeptBoxes boxes_;
    std::map<uint32_t, std::vector<Bound>> bounds_;   ///< by node
    std::vector<Test> tests_;
    std::vector<Step> trail_;
};

}  // namespace alidade
