// SPDX-License-Identifier: Apache-2.0
/// Vectors and matrices. The only file that includes GLM (a test checks it), with explicit and initialising constructors forced:
/// a double vector never narrows to float without a cast that can be seen.
#pragma once

#ifndef GLM_FORCE_EXPLICIT_CTOR
#define GLM_FORCE_EXPLICIT_CTOR
#endif
#ifndef GLM_FORCE_CTOR_INIT
#define GLM_FORCE_CTOR_INIT
#endif
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace alidade {

template <class R> using Vec3T = glm::vec<3, R, glm::defaultp>;
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;
using Index3 = glm::uvec3;
using Joints4 = glm::vec<4, uint16_t, glm::defaultp>;
using Mat3 = glm::dmat3;   ///< column-major: m[column][row]

/// Linear Rec.709 (radiance, reflectance, transmittance).
using Color = Vec3;

using glm::cross;
using glm::dot;

inline constexpr double kInf = std::numeric_limits<double>::infinity();
inline constexpr double kPi = 3.14159265358979323846;

/// v[axis], for axes that only the data know: GLM's is a switch, and what it costs are branches that no processor foresees.
template <class R> R component(const Vec3T<R>& v, int axis) { return reinterpret_cast<const R*>(&v)[axis]; }

template <class R> R max_component(const Vec3T<R>& v) { return std::max({v.x, v.y, v.z}); }
template <class R> R max_abs(const Vec3T<R>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

template <class R> bool is_finite(const Vec3T<R>& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Do the squares neither overflow nor vanish?
inline bool is_plain_square(double square) { return square > 1e-280 && square < 1e280; }

/// `v`, finite and not zero, with the largest component between 1 and 2, by a power of two: no digit changes.
[[gnu::noinline]] inline Vec3 of_plain_size(const Vec3& v, int& exponent) {
    exponent = std::ilogb(max_abs(v));
    return {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
}

/// Euclidean length without overflow or underflow of the squares (GLM's squares first).
inline double length(const Vec3& v) {
    if (const double square = dot(v, v); is_plain_square(square)) return std::sqrt(square);
    if (v == Vec3(0) || !is_finite(v)) return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    int exponent;
    const Vec3 plain = of_plain_size(v, exponent);
    return std::scalbn(std::sqrt(dot(plain, plain)), exponent);
}

/// `v` over its length; the zero vector and non-finite vectors come back unchanged, so that a caller can test for them.
inline Vec3 normalized(const Vec3& v) {
    if (const double square = dot(v, v); is_plain_square(square)) return v / std::sqrt(square);
    if (v == Vec3(0) || !is_finite(v)) return v;
    int exponent;
    const Vec3 plain = of_plain_size(v, exponent);
    return plain / std::sqrt(dot(plain, plain));
}

/// Rec.709 luminance.
inline double luminance(const Color& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

/// POV-Ray's brightness of a colour.
inline double pov_grey(const Color& c) { return 0.297 * c.x + 0.589 * c.y + 0.114 * c.z; }

/// 3 t^2 - 2 t^3.
inline double smooth_step(double t) { return t * t * (3 - 2 * t); }

inline bool is_black(const Color& c) { return c.x == 0 && c.y == 0 && c.z == 0; }

/// Two unit vectors that make a right-handed frame with the unit vector `n`.
/// Source   Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
inline void orthonormal_basis(const Vec3& n, Vec3& s, Vec3& t) {
    const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    s = Vec3(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    t = Vec3(b, sign + n.y * n.y * a, -n.y);
}

}  // namespace alidade
