// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/compiled_scene.h"
#include "tracer/cutaway.h"

namespace alidade {

/// A point on a closed form, in the space of that.
struct ClosedFormPoint {
    const ShapeOps* ops = nullptr;
    const ShapeGeometry* shape = nullptr;
    Vec3 point{0};
    uint32_t part = 0;
};

/// A hit, placed: all that materials ask of it. Texture coordinates are found when a signal asks for them.
struct ShadePoint {
    ShadePoint() {}   // not by default: that would clear all of it first, and then set it

    const Mesh* mesh = nullptr;
    uint32_t triangle = 0;
    double u = 0, v = 0;              ///< barycentric on meshes
    ClosedFormPoint on_shape;         ///< where there is no mesh
    Vec3 position{0};                 ///< world space
    Vec3 geometric_normal{0, 0, 1};   ///< unit, world space, on the front of the surface (outside)
    Vec3 shading_normal{0, 0, 1};     ///< unit, world space, interpolated; on the front
    Vec3 tangent{1, 0, 0}, bitangent{0, 1, 0};   ///< world space; set by tangent_frame()
    double error = 0;                 ///< how far `position` may be from the true surface, world space
    uint32_t instance = 0;
    uint32_t slot = 0;                ///< into CompiledScene::slots
    bool front = true;                ///< the ray came from outside
    const PatternSpace* space = nullptr;   ///< of the material's patterns, if it has any
    bool uv_mapped = false;                ///< patterns take uv_place() for the point in the world

    Vec2 uv(uint32_t set) const;
    /// Where POV-Ray looks up what is uv_mapped: (u, v, 0), v upwards.
    Vec3 uv_place() const;
    /// Where patterns are looked up.
    Vec3 pattern_point() const;
    /// The mesh's vertex colour, or white.
    bool has_vertex_color() const { return mesh && !mesh->colors.empty() && mesh->colors[0].present(); }
    Vec4 vertex_color() const;
};

/// The material, and what else the surface at `point` has of its slot.
inline const SlotMaterial& slot_at(const CompiledScene& scene, const ShadePoint& point) { return scene.slots[point.slot]; }
inline const PatternSpace* pattern_space(const CompiledScene& scene, const ShadePoint& point) {
    const uint32_t space = slot_at(scene, point).space;
    return space == kNoId ? nullptr : &scene.pattern_spaces[space];
}

/// Calls f(point, share) for each slot whose light is mixed at a point, as the point would be if it had that slot alone: the shares add up to 1, or there is none.
template <class F> void for_each_mixed_slot(const CompiledScene& scene, const ShadePoint& point, const F& f) {
    const auto take = [&](uint32_t slot, double share) {
        ShadePoint own = point;
        own.slot = slot;
        own.space = pattern_space(scene, own);
        f(own, share);
    };
    const Instance& instance = scene.instances[point.instance];
    if (point.slot == instance.inside_slot) return f(point, 1.0);
    if (instance.cutaway != kNoId) {
        const std::vector<uint32_t> open = slots_laid_open(scene, point);
        for (const uint32_t slot : open) take(slot, 1 / double(open.size()));
        return;
    }
    if (!point.mesh || point.mesh->corner_slots.empty()) return f(point, 1.0);
    const double shares[] = {1 - point.u - point.v, point.u, point.v};
    const uint32_t* slots = &point.mesh->corner_slots[3 * size_t(point.triangle)];
    if (slots[0] == slots[1] && slots[1] == slots[2]) return f(point, 1.0);
    for (int corner = 0; corner < 3; ++corner)   // what is not worth a ray is left out, and the others stay as they are (by experiment)
        if (shares[corner] >= scene.scene.settings.adc_bailout) take(instance.first_slot + slots[corner], shares[corner]);
}

/// `ray` is the world-space ray that found `hit`.
ShadePoint shade_point(const CompiledScene& scene, const Ray& ray, const Hit& hit);
/// The same for a ray that goes on: without `error`.
ShadePoint passed_point(const CompiledScene& scene, const Ray& ray, const Hit& hit);
/// The slot of a hit where it is plain without its point: kNoId where parts of it, or the side that was met, decide.
uint32_t plain_slot(const CompiledScene& scene, const Hit& hit);

/// How far the true surface may be from a hit that was found with a transformed ray, in world space.
double world_error(const CompiledScene& scene, const Ray& ray, const Hit& hit, const Vec3& position);

/// The unit normal of what was hit, in world space, on its outside.
Vec3 geometric_normal(const CompiledScene& scene, const Ray& ray, const Hit& hit);

inline const Material& material_at(const CompiledScene& scene, const ShadePoint& point) { return scene.scene.materials[slot_at(scene, point).material]; }

/// Fills in `tangent` and `bitangent`: the mesh's own, else those that compile() made along the texture coordinates of `uv_set`; any, if there are none.
void tangent_frame(const CompiledScene& scene, uint32_t uv_set, ShadePoint& point);

/// A ray from `point` that cannot meet the surface it starts on: the origin is moved off it along the normal, to the side that `dir` points to, by the
/// position's error bound (docs/numerics.md, "Spawned rays").
Ray spawn_ray(const ShadePoint& point, const Vec3& dir, double tmax = kInf);

}  // namespace alidade
