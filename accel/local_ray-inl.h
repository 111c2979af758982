// SPDX-License-Identifier: Apache-2.0
/// The local ray in vectors, compiled once for each target of a file that includes it (hwy/foreach_target.h).
#if defined(ALIDADE_LOCAL_RAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_LOCAL_RAY_INL
#undef ALIDADE_LOCAL_RAY_INL
#else
#define ALIDADE_LOCAL_RAY_INL
#endif

#include "accel/local_ray.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3   // four doubles at once

/// x, y, z, and a lane that decides nothing.
struct RayLanes {
    using D = hn::FixedTag<double, 4>;
    using V = hn::Vec<D>;
    static constexpr uint64_t kExponent = 0x7ffull << 52, kExponentOfOne = 1023ull << 52;   // of the bits of a double

    static HWY_INLINE HWY_ATTR V first_three(V v, double last) { return hn::IfThenElse(hn::FirstN(D(), 3), v, hn::Set(D(), last)); }
    static HWY_INLINE HWY_ATTR double greatest(V v) { return hn::GetLane(hn::MaxOfLanes(D(), v)); }
    /// One by one: a ray was written just before, and a vector that reaches over several writes would wait for all of them.
    static HWY_INLINE HWY_ATTR V three(const Vec3& v, double last) { return V{_mm256_setr_pd(alone(v.x), alone(v.y), alone(v.z), last)}; }
    static HWY_INLINE HWY_ATTR double alone(double x) {
        asm("" : "+x"(x));   // else compilers read two at once
        return x;
    }
    static HWY_INLINE HWY_ATTR V quantized(V v) {
        const D d;
        return hn::IfThenElse(hn::Lt(hn::Abs(v), hn::Set(d, kQuantizedBelow)), hn::Sub(hn::Add(v, hn::Set(d, kQuantumShift)), hn::Set(d, kQuantumShift)), v);
    }
};

/// As a plain local_ray(), the same bits by a shorter way: slabs are in the caller's t until powers of two are known. False, and nothing to be used, for rays that are
/// along an axis, or very long or short, and for those without a direction, with a NaN, or with an origin that is not within `largest`. The bounds are not empty.
HWY_INLINE HWY_ATTR bool local_ray_lanes(const Ray& ray, const RayBounds& bounds, RayEntry entry, double largest, LocalRay& local) {
    using L = RayLanes;
    using V = L::V;
    const L::D d;
    const hn::RebindToUnsigned<L::D> bits;
    const V given = L::three(ray.dir, 0), inverse = hn::Div(hn::Set(d, 1), L::first_three(given, 1));
    const auto exponent = hn::And(hn::BitCast(bits, hn::MaxOfLanes(d, hn::Abs(given))), hn::Set(bits, L::kExponent));   // of the largest component, in all lanes
    const double to_local = hn::GetLane(hn::BitCast(d, exponent));
    local.to_local = to_local;
    if (!local.is_plain()) return false;
    const V scale = hn::BitCast(d, hn::Sub(hn::Set(bits, 2 * L::kExponentOfOne), exponent)), dir = L::first_three(hn::Mul(given, scale), 1);
    const V at = L::three(ray.origin, 0);
    if (!hn::AllTrue(d, hn::And(hn::Ge(hn::Abs(dir), hn::Set(d, kSmallestSlope<float>)), hn::Le(hn::Abs(at), hn::Set(d, largest))))) return false;
    local.to_caller = hn::GetLane(scale);

    V origin = L::quantized(at);
    const V off = hn::Abs(hn::Sub(hn::Add(origin, origin), hn::Load(d, bounds.doubled_middle)));
    const bool near = hn::AllTrue(d, hn::Le(off, hn::Set(d, entry.far * bounds.doubled_size)));
    const V e = hn::Add(hn::Mul(hn::Abs(origin), hn::Set(d, 4 * kUnitRoundoff<double>)), hn::Set(d, kOriginPad<double>));
    const V a = hn::Mul(hn::Sub(hn::Load(d, bounds.low), hn::Add(origin, e)), inverse), b = hn::Mul(hn::Sub(hn::Load(d, bounds.high), hn::Sub(origin, e)), inverse);
    const V enter = hn::Min(a, b), leave = hn::Max(a, b), first = hn::MaxOfLanes(d, enter), last = hn::MinOfLanes(d, leave);
    if (near && !entry.clips && ray.tmin >= 0) {
        local.leave_unclipped(ray, hn::GetLane(first) * to_local, hn::GetLane(last) * to_local);
    } else {
        local.set_interval(hn::GetLane(first) * to_local, hn::GetLane(last) * to_local);
        if (!near && entry.moves && local.enters_box() && (local.tmin > 0 || local.tmax < 0)) {
            const V blur = hn::Abs(hn::Mul(e, inverse));
            local.move(L::greatest(hn::IfThenElseZero(hn::Eq(enter, first), blur)) * to_local, L::greatest(hn::IfThenElseZero(hn::Eq(leave, last), blur)) * to_local);
            origin = L::quantized(hn::Add(origin, hn::Mul(hn::Set(d, local.shift), dir)));
        }
        if (local.enters_box()) local.narrow(ray);
    }
    hn::Store(origin, d, &local.origin.x), hn::Store(dir, d, &local.dir.x), hn::Store(hn::Mul(inverse, hn::Set(d, to_local)), d, &local.inverse.x);
    return true;
}

#endif

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
