// SPDX-License-Identifier: Apache-2.0
#include "tracer/shade_point.h"

#include "core/lanes.h"
#include "core/next_up.h"
#include "eval/mesh_points.h"
#include "eval/placed.h"

namespace alidade {
namespace {

void place_on_mesh(const Mesh& mesh, const Instance& instance, const Hit& hit, ShadePoint& p) {
    p.mesh = &mesh;
    p.triangle = hit.primitive;
    p.u = hit.u, p.v = hit.v;
    if (!mesh.slots.empty()) p.slot += mesh.slots[hit.primitive];
    p.geometric_normal = normalized(instance.to_local.transposed(triangle_normal(mesh, hit.primitive)));
    p.shading_normal = p.geometric_normal;
    if (!mesh.normals.present()) return;
    const Vec3 n(interpolate(mesh.normals, mesh, hit.primitive, hit.u, hit.v));
    const Vec3 world = normalized(instance.to_local.transposed(n));
    if (std::abs(dot(world, world) - 1) < 1e-6) p.shading_normal = world;   // opposite vertex normals can cancel: stay flat there
    // Files exist whose normals point against the winding: the normals then say which side is the front.
    if (dot(p.shading_normal, p.geometric_normal) < 0) p.geometric_normal = -p.geometric_normal;
}

/// The mesh's own tangents, else those that were made for the set; null if there are none.
const Attribute<Vec4f>* tangents_of(const Geometry& geometry, uint32_t uv_set) {
    if (geometry.mesh->tangents.present()) return &geometry.mesh->tangents;
    return uv_set < geometry.tangents.size() && geometry.tangents[uv_set].present() ? &geometry.tangents[uv_set] : nullptr;
}

void place_on_shape(const Geometry& geometry, const Instance& instance, const Ray& local, const Hit& hit, ShadePoint& p) {
    // A position in the world may be as coarse as the whole shape.
    p.on_shape = {geometry.ops, geometry.source, instance.inexact ? local.at(hit.t) : instance.local(p.position), hit.part};
    p.geometric_normal = p.shading_normal = normalized(instance.to_local.transposed(geometry.ops->normal_at(*geometry.source, p.on_shape.point, hit.part)));
    if (!geometry.ops->shading_normal) return;
    p.shading_normal = normalized(instance.to_local.transposed(geometry.ops->shading_normal(*geometry.source, p.on_shape.point)));
    if (dot(p.shading_normal, p.geometric_normal) < 0) p.geometric_normal = -p.geometric_normal;
}

/// Of triangles it is asked for nothing.
Ray local_ray_of(const Instance& instance, const Geometry& geometry, const Ray& ray) { return geometry.mesh && !instance.inexact ? ray : instance.local(ray); }

void place(const Geometry& geometry, const Instance& instance, const Ray& local, const Hit& hit, ShadePoint& p) {
    if (geometry.mesh) place_on_mesh(*geometry.mesh, instance, hit, p);
    else place_on_shape(geometry, instance, local, hit, p);
    if (instance.inverted) p.geometric_normal = -p.geometric_normal, p.shading_normal = -p.shading_normal;
}

/// Has the triangle normals that are not the same in all of its corners?
bool is_smooth(const Mesh& mesh, uint32_t triangle) {
    if (!mesh.normals.present()) return false;
    const Index3& corners = mesh.triangles[triangle];
    const auto at = [&](int corner) { return mesh.normals.values[mesh.normals.index(triangle, corner, corners)]; };
    return at(0) != at(1) || at(0) != at(2);
}

/// Does the ray come from the side that POV-Ray shows interior_texture on? Of smooth triangles that is where the interpolated normal does not point, of
/// others the side on which their corners go around counterclockwise in a right-handed space, whatever normals they are given (probed). Out of line: few
/// scenes have textures for the inside alone.
[[gnu::noinline]] bool sees_inside(const Instance& instance, const Ray& ray, const ShadePoint& p) {
    if (p.mesh && is_smooth(*p.mesh, p.triangle)) return (dot(ray.dir, p.shading_normal) > 0) != instance.turned;
    const bool behind = p.mesh ? dot(ray.dir, instance.to_local.transposed(triangle_normal(*p.mesh, p.triangle))) <= 0 : !p.front;
    return (behind != instance.turned) != (p.mesh && instance.inverted);
}

/// How far the surface may be from `position`, in world space.
double error_of(const Instance& instance, const Geometry& geometry, const Ray& ray, const Ray& local, const Hit& hit, const Vec3& position) {
    const ErrorBound own = geometry.mesh ? hit.error : geometry.ops->error(*geometry.source, local, hit.t, hit.part);
    const double mapped = instance.inexact ? corrected_error(instance.norms, ray, local, hit.t) : mapped_error(instance.norms, ray, hit.t);
    return placed_error(instance.norms, own, mapped, ray, hit.t, position);
}

/// `moved` to the next number on in the direction of `offset`, so that it was not rounded back.
Vec3 rounded_on(const Vec3& moved, const Vec3& offset) {
    Vec3 out = moved;
    for (int k = 0; k < 3; ++k)
        if (offset[k] != 0) out[k] = offset[k] > 0 ? next_up(moved[k]) : -next_up(-moved[k]);
    return out;
}

#ifdef __x86_64__
/// origin = position + offset, rounded on: the same bits. The numbers of one sign are in the order of their bits.
[[gnu::target("avx2")]] void begin_off_in_lanes(const Vec3& position, const Vec3& offset, Ray& ray) {
    const __m256d zero = _mm256_setzero_pd(), away = lanes_of(offset), moved = lanes_of(position) + away, size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), moved);
    const __m256d usual = _mm256_and_pd(_mm256_cmp_pd(size, zero, _CMP_GT_OQ), _mm256_cmp_pd(size, _mm256_set1_pd(kInf), _CMP_LT_OQ));
    const __m256d against = _mm256_xor_pd(_mm256_cmp_pd(moved, zero, _CMP_GT_OQ), _mm256_cmp_pd(away, zero, _CMP_GT_OQ));
    const __m256i step = _mm256_or_si256(_mm256_castpd_si256(against), _mm256_set1_epi64x(1));   // 1 or -1
    const __m256i steps = _mm256_and_si256(step, _mm256_castpd_si256(_mm256_cmp_pd(away, zero, _CMP_NEQ_OQ)));
    _mm256_storeu_pd(&ray.origin.x, _mm256_castsi256_pd(_mm256_add_epi64(_mm256_castpd_si256(moved), steps)));   // and what is written over follows
    if ((_mm256_movemask_pd(usual) & 7) != 7) ray.origin = rounded_on(position + offset, offset);
}
#endif

void begin_off(const Vec3& position, const Vec3& offset, Ray& ray) {
#ifdef __x86_64__
    if (kHasLanes) return begin_off_in_lanes(position, offset, ray);
#endif
    ray.origin = rounded_on(position + offset, offset);
}

}  // namespace

double world_error(const CompiledScene& scene, const Ray& ray, const Hit& hit, const Vec3& position) {
    const Instance& instance = scene.instances[hit.instance];
    const Geometry& geometry = scene.geometries[instance.geometry];
    return error_of(instance, geometry, ray, local_ray_of(instance, geometry, ray), hit, position);
}

Vec3 geometric_normal(const CompiledScene& scene, const Ray& ray, const Hit& hit) {
    const Instance& instance = scene.instances[hit.instance];
    const Geometry& geometry = scene.geometries[instance.geometry];
    ShadePoint p;
    p.position = ray.at(hit.t);
    place(geometry, instance, local_ray_of(instance, geometry, ray), hit, p);
    return p.geometric_normal;
}

Vec2 ShadePoint::uv(uint32_t set) const {
    if (!mesh) return on_shape.ops ? on_shape.ops->surface(*on_shape.shape, on_shape.point, on_shape.part).uv : Vec2(0);
    if (set >= mesh->uvs.size() || !mesh->uvs[set].present()) return Vec2(0);
    return Vec2(interpolate(mesh->uvs[set], *mesh, triangle, u, v));
}

Vec3 ShadePoint::pattern_point() const {
    if (!space) return position;
    return space->from_world.point(position);
}

Vec3 ShadePoint::uv_place() const {
    if (mesh) {
        if (mesh->uvs.empty() || !mesh->uvs[0].present()) return Vec3(0);
        const Vec2 at = uv(0);
        return {at.x, 1 - at.y, 0};
    }
    const bool mapped = on_shape.shape && (std::holds_alternative<Sphere>(*on_shape.shape) || std::holds_alternative<Box>(*on_shape.shape) || std::holds_alternative<Torus>(*on_shape.shape));
    return mapped ? Vec3(uv(0), 0) : Vec3(position.x, position.y, 0);   // as POV-Ray has it for shapes that it knows no (u, v) of
}

Vec4 ShadePoint::vertex_color() const {
    if (!has_vertex_color()) return Vec4(1);
    return Vec4(interpolate(mesh->colors[0], *mesh, triangle, u, v));
}

namespace {

template <bool kMeasured> [[gnu::always_inline]] inline ShadePoint placed(const CompiledScene& scene, const Ray& ray, const Hit& hit) {
    const Instance& instance = scene.instances[hit.instance];
    const Geometry& geometry = scene.geometries[instance.geometry];
    ShadePoint p;
    p.instance = hit.instance;
    p.slot = instance.first_slot;
    p.position = ray.at(hit.t);
    const Ray local = local_ray_of(instance, geometry, ray);
    if constexpr (kMeasured) p.error = error_of(instance, geometry, ray, local, hit, p.position);
    place(geometry, instance, local, hit, p);
    p.front = dot(ray.dir, p.geometric_normal) <= 0;
    if (instance.inside_slot != kNoId && sees_inside(instance, ray, p)) p.slot = instance.inside_slot;
    p.space = pattern_space(scene, p);
    p.uv_mapped = instance.uv_mapped;
    return p;
}

}  // namespace

ShadePoint shade_point(const CompiledScene& scene, const Ray& ray, const Hit& hit) { return placed<true>(scene, ray, hit); }
ShadePoint passed_point(const CompiledScene& scene, const Ray& ray, const Hit& hit) { return placed<false>(scene, ray, hit); }

uint32_t plain_slot(const CompiledScene& scene, const Hit& hit) {
    const Instance& instance = scene.instances[hit.instance];
    if (instance.inside_slot != kNoId || instance.cutaway != kNoId) return kNoId;
    const Mesh* mesh = scene.geometries[instance.geometry].mesh;
    if (!mesh) return instance.first_slot;
    if (!mesh->corner_slots.empty()) return kNoId;
    return instance.first_slot + (mesh->slots.empty() ? 0 : mesh->slots[hit.primitive]);
}

void tangent_frame(const CompiledScene& scene, uint32_t uv_set, ShadePoint& p) {
    const Instance& instance = scene.instances[p.instance];
    const Attribute<Vec4f>* tangents = p.mesh ? tangents_of(scene.geometries[instance.geometry], uv_set) : nullptr;
    Vec3 along_u(0);
    double handedness = 1;
    if (tangents) {
        const Vec4 t(interpolate(*tangents, *p.mesh, p.triangle, p.u, p.v));
        along_u = instance.to_world.vector(Vec3(t.x, t.y, t.z));
        handedness = (t.w < 0 ? -1 : 1) * (instance.to_world.determinant() < 0 ? -1 : 1);
    }
    const Vec3& n = p.shading_normal;
    const Vec3 t = normalized(along_u - n * dot(n, along_u));
    if (std::abs(dot(t, t) - 1) > 1e-6) return orthonormal_basis(n, p.tangent, p.bitangent);
    p.tangent = t;
    p.bitangent = cross(n, t) * handedness;
}

Ray spawn_ray(const ShadePoint& point, const Vec3& dir, double tmax) {
    const double side = dot(dir, point.geometric_normal) < 0 ? -1 : 1;
    Ray ray;
    // Once for the error of this point, once for that of the test which must not find the surface again.
    const Vec3 offset = point.geometric_normal * (side * 2 * point.error);
    begin_off(point.position, offset, ray);
    ray.dir = dir;
    ray.tmin = 0;
    ray.tmax = tmax;
    return ray;
}

}  // namespace alidade
