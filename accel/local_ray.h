// SPDX-License-Identifier: Apache-2.0
/// The entry point that all structures share: the ray is scaled and, if it begins far away, moved, in double, to where it enters the bounds of the primitives.
#pragma once

#include "accel/isa.h"
#include "accel/slab.h"
#include "core/next_up.h"
#include "core/ray.h"

namespace alidade {

/// Coordinates of rays and of double vertices are rounded to multiples of 2^-300, so that exact signs (triangles/exact_sign.h) cannot underflow.
inline constexpr double kQuantumShift = 0x1.8p-248, kQuantizedBelow = 0x1p-249;   // the ulp of the shift is 2^-300
inline double quantized(double x) { return std::abs(x) < kQuantizedBelow ? (x + kQuantumShift) - kQuantumShift : x; }
inline Vec3 quantized(const Vec3& v) { return {quantized(v.x), quantized(v.y), quantized(v.z)}; }

/// More than a hit's t may be off, relatively (kDepthError of triangles/decide.cpp), and the roundings around it: a box that holds the exact hit is not culled by the computed one.
inline constexpr double kHitPad = 0x1p-29;

/// The ray that structures and leaves see. From here on (origin, dir) *is* the ray: every decision is about these numbers, exactly, and they
/// depend on the caller's ray and on the bounds alone, so that all structures decide the same.
struct alignas(32) LocalRay {
    Vec3 origin;                        ///< these three are written and read as vectors of four
    double origin_lane;
    Vec3 dir;                           ///< the caller's times a power of two: its largest component is in [1, 2)
    double dir_lane;
    Vec3 inverse;                       ///< of dir's components
    double inverse_lane;
    double shift = 0;                   ///< local t of the new origin, seen from the caller's origin
    double to_caller = 1, to_local = 1; ///< powers of two
    double tmin = 0, tmax = -1;         ///< local interval that holds all hits; empty if the ray misses the bounds
    double reach = 0;                   ///< bounds |t| in the bounds, where somebody needs it: boxes, if a component of dir is very small (kSmallestSlope<float>)

    LocalRay() {}   // not one by one in memory: that takes longer than a box test
    bool enters_box() const { return tmin <= tmax; }
    /// Do the powers of two neither overflow nor vanish in products with what is as small, or large, as coordinates are?
    bool is_plain() const { return to_local >= 0x1p-300 && to_local <= 0x1p300; }
    double caller_t(double t) const { return shift * to_caller + t * to_caller; }
    /// Sets tmin and tmax to the ends of an interval, padded; to an empty one if near > far.
    void set_interval(double near, double far) {
        far = SlabRay<double>::padded(far);
        if (near <= far) tmin = padded_down(near), tmax = padded_up(far);
        else tmin = 0, tmax = -1;
    }
    /// The interval as it is seen from the point at tmin, rounded. How far rounding may shift the planes of both ends, in t, is twice the blurs and what the shift
    /// itself loses.
    void move(double near_blur, double far_blur) {
        shift = tmin;
        tmin = -(2 * near_blur + 0x1p-50 * std::abs(shift)), tmax = padded_up((tmax - shift) + (2 * far_blur + 0x1p-50 * std::abs(shift)));
    }
    /// Not less than any local t whose caller_t is at most `caller`, and the same from below.
    double upper(double caller) const { return padded_up((above(caller) - shift * to_caller) * to_local, kHitPad); }
    double lower(double caller) const { return padded_down((-above(-caller) - shift * to_caller) * to_local, kHitPad); }
    /// The part of the interval that is the caller's.
    void narrow(const Ray& ray) { tmin = std::max(tmin, lower(ray.tmin)), tmax = std::min(tmax, upper(ray.tmax)); }
    /// The caller's interval, which does not begin before 0; empty if a ray with these ends misses the bounds.
    [[gnu::always_inline]] inline void leave_unclipped(const Ray& ray, double near, double far) {
        far = SlabRay<double>::padded(far);
        tmin = ray.tmin == 0 ? 0 : std::max(0.0, lower(ray.tmin)), tmax = !(near <= far && far >= 0) ? -1 : ray.tmax == std::numeric_limits<double>::infinity() ? ray.tmax : upper(ray.tmax);
    }

  private:
    /// A number above x, the next one but for 0: processors take a hundred cycles for a product with a denormal number, and most rays begin at 0. What is
    /// given away is far below kOriginPad.
    static double above(double x) { return x == 0 ? 0x1p-600 : next_up(x); }
};

/// Not less than any |t| at which the ray is in the box: it is not along the largest component of the direction, which is at least 1.
inline double reach_of(const LocalRay& ray, const Bounds& box) {
    const auto largest = [](const Vec3& v) { return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z)); };
    return padded_up(std::max(largest(box.min - ray.origin), largest(box.max - ray.origin)));
}

/// The ray for tests against boxes of type R.
template <class R> SlabRay<R> slab_of(const LocalRay& ray) { return {ray.origin, ray.dir, ray.inverse, ray.reach}; }

/// Does `ray` have a direction, no NaN, and an origin within `largest` (kLargestCoordinate)? Others hit nothing.
inline bool can_hit(const Ray& ray, double largest) {
    const Vec3 &o = ray.origin, &d = ray.dir;
    return std::abs(o.x) <= largest && std::abs(o.y) <= largest && std::abs(o.z) <= largest && is_finite(d) && !(d.x == 0 && d.y == 0 && d.z == 0) && ray.tmin <= ray.tmax;
}

/// What is made of a ray that begins far from the bounds, `far` times their greatest extent from the middle, and of one that begins near.
struct RayEntry {
    bool moves;          ///< far: to where it enters the bounds. Custom primitives answer in the caller's t, so for them the ray stays where it is
    double far;
    bool clips = true;   ///< near: its interval is that in which it is in the bounds. Else, where that does not begin before 0, it is the caller's, or empty where the ray misses them: nothing waits for the ends to be known
};
/// Pads grow with the distance: from as far away they are about a hundred thousandth of a mesh in float.
inline constexpr double kFar = 64;

/// Bounds (finite or empty) as rays are compared with them, four numbers at once: the last is one that decides nothing.
struct alignas(32) RayBounds {
    RayBounds() : RayBounds(Bounds()) {}
    RayBounds(const Bounds& bounds);   // NOLINT: it is the bounds

    double low[4], high[4];
    double doubled_middle[4];   ///< low + high
    double doubled_size;        ///< twice the greatest extent; of empty bounds negative

    bool empty() const { return doubled_size < 0; }
    Bounds bounds() const { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

/// `ray`, which can hit, made ready for primitives within `bounds`. The same bits for all instructions.
LocalRay local_ray(const Ray& ray, const RayBounds& bounds, RayEntry entry, Isa isa = Isa::best);

}  // namespace alidade
