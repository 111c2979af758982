// SPDX-License-Identifier: Apache-2.0
/// A box between two corners. Its parts are its faces: 0 and 1 are the lower and the upper face across x, 2 and 3 across y, 4 and 5 across z.
#include "eval/shapes/rows.h"

namespace alidade {

namespace {

Bounds box_bounds(const ShapeGeometry& geometry) {
    const Box& box = std::get<Box>(geometry);
    return {glm::min(box.a, box.b), glm::max(box.a, box.b)};
}

double plane_of(const Bounds& box, uint32_t face) { return face % 2 ? box.max[int(face / 2)] : box.min[int(face / 2)]; }

/// The face through which the line comes in (or goes out): the one whose plane is met at exactly `t`; of several, at an edge, the first.
/// A division is repeated here as it was made in inside_bounds, so the comparison is exact.
uint32_t face_at(const Bounds& box, const Ray& ray, double t, bool entering) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
        const double d = ray.dir[int(axis)];
        if (d == 0) continue;
        const uint32_t face = 2 * axis + ((d > 0) != entering);
        if ((plane_of(box, face) - ray.origin[int(axis)]) / d == t) return face;
    }
    return 0;
}

/// A bound on the distance of ray.at(t) from the plane of the face: the distance found there and the roundings of ray.at(t).
ErrorBound box_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t face) {
    const int axis = int(face / 2);
    return {(std::abs(ray.at(t)[axis] - plane_of(box_bounds(geometry), face)) + at_rounding(ray, t, axis)) * (1 + gamma_bound(4))};
}

/// The line is in the box where it is between all three pairs of planes. A line in the plane of a face, or along an edge, is in the box; a box that is
/// flat along an axis is crossed twice at the same t.
Crossings box_wanted(const ShapeGeometry&, const Bounds& box, const Ray& ray, Wanted what) {
    Crossings out;
    if (!is_finite(ray)) return out;
    const LineInterval inside = inside_bounds(ray, box);
    if (inside.empty() || !std::isfinite(inside.entry) || !std::isfinite(inside.exit)) return out;
    const bool all = what == Wanted::all;
    if (all || inside.entry >= ray.tmin) out.add(inside.entry, face_at(box, ray, inside.entry, true));
    else out.begins_inside = true;
    if (all || out.count == 0) out.add(inside.exit, face_at(box, ray, inside.exit, false));
    return out;
}

Crossings box_crossings(const ShapeGeometry& geometry, const Ray& ray) { return box_wanted(geometry, box_bounds(geometry), ray, Wanted::all); }

/// Texture coordinates of a face: u = u0 + (su / 4) f, v = v0 + (sv / 3) g, where f and g run from 0 to 1 along two axes of the box.
struct FaceUv {
    int u_axis;
    double u0, su;
    int v_axis;
    double v0, sv;
};

/// The box unfolded into a cross of 4 by 3 squares, in the order -x, +z, +x, -z around y, with -y below and +y above +z.
/// Source   POV-Ray 3.7 manual, "UV mapping"; offsets and signs measured from renders of a unit box, not from its source.
constexpr FaceUv kUnfolded[6] = {
    {2, 0.0 / 4, 1, 1, 1.0 / 3, 1},  {2, 3.0 / 4, -1, 1, 1.0 / 3, 1},   // -x, +x
    {0, 1.0 / 4, 1, 2, 0.0 / 3, 1},  {0, 1.0 / 4, 1, 2, 3.0 / 3, -1},   // -y, +y
    {0, 4.0 / 4, -1, 1, 1.0 / 3, 1}, {0, 1.0 / 4, 1, 1, 1.0 / 3, 1},    // -z, +z
};

Vec3 box_normal(const ShapeGeometry&, const Vec3&, uint32_t part) {
    Vec3 normal(0);
    normal[int(part / 2)] = part % 2 ? 1 : -1;
    return normal;
}

SurfacePoint box_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t part) {
    const Bounds box = box_bounds(geometry);
    Vec3 size = box.extent();
    for (int i = 0; i < 3; ++i)
        if (size[i] == 0) size[i] = 1;   // a face without area still has two directions
    const FaceUv& face = kUnfolded[part];
    const Vec3 along = (point - box.min) / size;
    SurfacePoint out;
    out.normal = box_normal(geometry, point, part);
    out.dpdu = out.dpdv = Vec3(0);
    out.uv = {face.u0 + face.su / 4 * along[face.u_axis], face.v0 + face.sv / 3 * along[face.v_axis]};
    out.dpdu[face.u_axis] = 4 * face.su * size[face.u_axis];
    out.dpdv[face.v_axis] = 3 * face.sv * size[face.v_axis];
    return out;
}

bool box_inside(const ShapeGeometry& geometry, const Vec3& point) { return box_bounds(geometry).contains(point); }

}  // namespace

const ShapeOps kBoxOps = {"box", "the solid between two opposite corners", kind_of<Box>(), box_bounds, box_crossings, box_error, box_surface, box_inside, always_solid, nullptr, false, box_normal, box_wanted, true};

}  // namespace alidade
