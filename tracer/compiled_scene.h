// SPDX-License-Identifier: Apache-2.0
/// What a ray needs of a scene. Made by compile(), read by integrators; nothing in it changes while rays are traced.
#pragma once

#include "accel/accelerator.h"
#include "eval/csg_expression.h"
#include "eval/placed.h"
#include "eval/shapes/shape_ops.h"
#include "tracer/lights.h"
#include "tracer/render.h"
#include "tracer/sky.h"

namespace alidade {

class BoundTests;
class InstanceSet;
class Projector;
class Textures;
struct PlainPovSurface;

/// Something that can be hit, in its own space: a mesh with an accelerator over its triangles, or a closed-form shape. Stored once, however many
/// instances show it.
struct Geometry {
    ShapeId shape;
    const ShapeGeometry* source = nullptr;
    const Mesh* mesh = nullptr;             ///< null for closed forms
    std::unique_ptr<Accelerator> triangles; ///< null for closed forms
    const ShapeOps* ops = nullptr;          ///< null for meshes
    Bounds bounds;                          ///< infinite where the shape is
    bool endless = false;                   ///< of what is inside in sets (csg_endless)
    std::vector<Attribute<Vec4f>> tangents; ///< by texture coordinate set: of a mesh that has none, where a normal map asks for them
};

/// An interior behind a surface, with what the surface says of it.
struct CompiledInterior : Interior {
    bool hollow = false;           ///< there is fog in it, too
};

/// A material as an instance's slot has it, with the interior that its transmission leads into.
struct SlotMaterial {
    uint32_t material = 0;
    uint32_t interior = kNoId;
    uint32_t space = kNoId;   ///< into CompiledScene::pattern_spaces; without one where the material has no patterns
};

/// Where a material's patterns are looked up.
struct PatternSpace {
    Transform to_world, from_world;   ///< from and into the space of the node that carries the material
};

/// One path from a root to a node with a shape.
struct Instance {
    Transform to_world, to_local;
    bool in_place = false;         ///< both are the identity
    bool inexact = false;          ///< what they make of a ray is corrected: roundings would cost digits
    PlacedNorms norms;
    Bounds bounds;                 ///< in world space; empty for parts of a solid, which are not met by themselves
    uint32_t geometry = 0;
    uint32_t first_slot = 0;       ///< into CompiledScene::slots, as many as the shape has
    uint32_t inside_slot = kNoId;  ///< of all that is seen from inside, behind those; without one the others hold there, too
    Mask mask = kMaskAll;
    bool double_illuminate = false;   ///< POV: lit from both sides
    bool uv_mapped = false;        ///< patterns are looked up at (u, v, 0) of its surface (NodeFlags::uv_mapping)
    bool usual_material = false;   ///< of its slots: no node on the path says what they are
    bool inverted = false;         ///< taken away from a solid: its normals point inwards
    bool turned = false;           ///< inverse, or a part of a solid that goes on for ever: its inside is where its normals point
    uint32_t carrier = 0;          ///< of its interior: parts of one object that carries it have the same
    uint32_t object = 0;           ///< what it is a part of, as POV-Ray counts objects: a solid, a union that is a whole, or itself
    bool of_whole = true;          ///< its interior is not its own alone, if it is part of a solid or a union that is one object, but that of the whole
    NodeId node;
    uint32_t light_set = 0;        ///< into CompiledScene::lit_by
    uint32_t bound_test = kNoId;   ///< of CompiledScene::bound_tests: rays that fail it do not meet its surface
    uint32_t cutaway = kNoId;      ///< into CompiledScene::cutaways: its surface shows what it lays open

    /// In the space of the geometry.
    Ray local(const Ray& ray) const { return in_place ? ray : inexact ? corrected(ray) : to_local.ray(ray); }
    Vec3 local(const Vec3& point) const { return in_place ? point : inexact ? corrected(point) : to_local.point(point); }

  private:
    // Out of line: most instances pay for a comparison alone.
    Ray corrected(const Ray& ray) const;
    Vec3 corrected(const Vec3& point) const;
};

/// Solids made of instances by set operations.
struct Solid {
    CsgTree tree;                  ///< its leaves are instances, in world space
    Mask mask = kMaskAll;          ///< of all leaves
};

/// Of a solid, or a union that is one object, of which a part has an interior of its own: what a camera in it is in.
struct WholeInterior {
    uint32_t object = 0, carrier = 0, interior = kNoId;
};

/// An operation whose cuts show what they lay open, or a part of it: each is followed by what is in it.
struct CutawayNode {
    CsgOp op = CsgOp::leaf;
    bool inverse = false;
    bool inverted = false;         ///< with all around it
    bool cuts = false;             ///< a part of a difference or a clip behind the first
    uint32_t instance = kNoId;     ///< of a leaf
    uint32_t parent = 0;
    uint32_t end = 0;              ///< of what is in it
};

/// A camera with its node's transform applied: all in world space.
struct PlacedCamera {
    Camera camera;
};

/// What the render kernel is a template over: a bit is set if the scene needs it.
enum Feature : unsigned {
    kTextures = 1,        ///< signals that are not constant, vertex colours, normal maps
    kAlpha = 2,           ///< surfaces that are not there, or not wholly: rays pass, shadow rays collect what they pass
    kTransmission = 4,    ///< glass: refracted rays, shadow rays collect
    kMirrors = 8,         ///< reflected rays
    kSampledLights = 16,  ///< lights with an extent, and skies: shadow rays to points chosen at random
    kAllFeatures = 31,
};

struct CompiledScene {
    Scene scene;
    std::vector<Geometry> geometries;
    std::vector<Instance> instances;
    std::vector<Solid> solids;
    std::vector<Bounds> object_boxes;      ///< by Instance::object; empty unless RenderSettings::first_box_shows
    bool first_box_shows = false;          ///< of surfaces that coincide, that of the object whose box a ray enters first is seen. Else that of the first instance
    std::unique_ptr<BoundTests> bound_tests;   ///< null if nothing is bounded
    std::vector<std::vector<CutawayNode>> cutaways;   ///< operations whose parts are looked up at points of faces that show them
    std::vector<SlotMaterial> slots;
    std::vector<std::optional<Color>> uniform_filters;   ///< by slot: what it lets through of any shadow ray, where that is the same at all of its points; empty unless `filters_light`
    std::vector<std::unique_ptr<const PlainPovSurface>> plain_surfaces;   ///< by slot: what is the same at all points of a surface, null where it is not; empty if none is so
    std::vector<PatternSpace> pattern_spaces;
    std::vector<CompiledInterior> interiors;
    std::vector<WholeInterior> whole_interiors;   ///< by object
    std::shared_ptr<const InstanceSet> set;   ///< the instances and solids
    std::unique_ptr<Accelerator> top;      ///< over them
    std::unique_ptr<Accelerator> filters;  ///< over those that let a part of the light through; null if `filters_light` is false
    Bounds filter_bounds;                  ///< of those
    std::unique_ptr<Accelerator> opaques;  ///< over those that let none of it through; null where they are most of all, or if `filters_light` is false
    std::unique_ptr<Textures> textures;
    std::vector<PlacedLight> lights;
    std::vector<std::vector<bool>> lit_by; ///< which lights shine, by Instance::light_set; empty: all on all
    std::vector<std::unique_ptr<Projector>> projectors;   ///< by light, null for most; empty: none has one
    std::vector<PlacedCamera> cameras;     ///< at least one
    Transform sky_from_world;              ///< into the space of the sky's pigments
    std::unique_ptr<Sky> sky;              ///< what a ray sees that leaves the scene, and what lights it from there
    bool glows = false;                    ///< a surface emits light (or is unlit)
    bool filters_light = false;            ///< some surface lets a part of the light on a shadow ray pass
    bool all_air = true;                   ///< no interior bends, dims or colours light: rays need not know what they are in
    Intersect intersect = Intersect::exact;   ///< of its meshes
    unsigned features = 0;                 ///< of the kernel: what the scene needs, or more
    std::string kernel;                    ///< the features in words, each with what asked for it

    CompiledScene();
    ~CompiledScene();
    CompiledScene(const CompiledScene&) = delete;   // `geometries` and `textures` point into `scene`
    CompiledScene& operator=(const CompiledScene&) = delete;
};

}  // namespace alidade
