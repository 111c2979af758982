// SPDX-License-Identifier: Apache-2.0
/// Affine maps in double precision.
#pragma once

#include "core/bounds.h"
#include "core/ray.h"

#include <optional>

namespace alidade {

/// p -> linear p + translation.
struct Transform {
    Mat3 linear{1.0};
    Vec3 translation{0};

    Vec3 point(const Vec3& p) const { return linear * p + translation; }
    Vec3 vector(const Vec3& v) const { return linear * v; }
    /// The transpose applied to `n`. Normals map by the transpose of the *inverse*: world normal = world_to_local.transposed(local normal).
    Vec3 transposed(const Vec3& n) const { return {dot(linear[0], n), dot(linear[1], n), dot(linear[2], n)}; }
    Bounds bounds(const Bounds& b) const;
    /// Origin and direction mapped, t unchanged: the mapped ray meets the mapped surface at the same t.
    Ray ray(const Ray& r) const;

    bool is_identity() const { return linear == Mat3(1.0) && translation == Vec3(0); }
    bool is_finite() const;
    /// Negative for a mirroring.
    double determinant() const { return dot(linear[0], cross(linear[1], linear[2])); }
    /// Upper bound of the stretch of any vector (Frobenius norm; at most sqrt(3) times the largest singular value).
    double norm() const;

    static Transform translate(const Vec3& t) { return {Mat3(1.0), t}; }
    static Transform scale(const Vec3& s) { return {Mat3(s.x, 0, 0, 0, s.y, 0, 0, 0, s.z), Vec3(0)}; }
    /// Rotation by `angle` radians about the unit vector `axis`, right-handed.
    static Transform rotate(const Vec3& axis, double angle);
    /// From a unit quaternion (x, y, z, w).
    static Transform from_quaternion(const Vec4& q);
};

/// First b, then a.
Transform operator*(const Transform& a, const Transform& b);

/// The inverse, or nothing if the map is singular to working precision or not finite. Rows and columns are scaled by powers of two first, so
/// that `scale <1e-12, 1, 1e12>` is as good as the identity.
std::optional<Transform> inverse(const Transform& a);

}  // namespace alidade
