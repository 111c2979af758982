// SPDX-License-Identifier: Apache-2.0
/// The padded box test. What is claimed here is derived in docs/numerics.md, "The box test".
#pragma once

#include "core/bounds.h"
#include "core/error_bound.h"

namespace alidade {

/// Relative width of the pads, in units of roundoff: the two ends of a slab carry four roundings each, the pad itself two.
inline constexpr int kSlabPad = 12;

/// Coordinates of vertices, boxes and ray origins beyond this are refused: products of them would overflow.
template <class R> inline constexpr double kLargestCoordinate = 0x1p120;
template <> inline constexpr double kLargestCoordinate<double> = 0x1p480;

/// Absolute pad of an origin: 16 times the quantum of coordinates (the smallest float; for double the 2^-300 of local_ray.h).
template <class R> inline constexpr R kOriginPad = R(0x1p-145);
template <> inline constexpr double kOriginPad<double> = 0x1p-296;

/// Direction components below this are taken as 0, their drift goes into the origin's pad: neither they nor their inverses can then overflow.
template <class R> inline constexpr double kSmallestSlope = 0x1p-100;
template <> inline constexpr double kSmallestSlope<double> = 0x1p-240;

/// `x` moved up or down by more than all roundings between a slab's end and a hit on it.
inline double padded_up(double x, double pad = kSlabPad * kUnitRoundoff<double>) { return x + (std::abs(x) * pad + kOriginPad<double>); }
inline double padded_down(double x, double pad = kSlabPad * kUnitRoundoff<double>) { return x - (std::abs(x) * pad + kOriginPad<double>); }

/// A ray made ready for tests against boxes with coordinates of type R.
///
/// A box that the exact ray touches at a t in the exact interval is never missed, and the reported entry of a box is not greater than limit(t) for
/// any hit at t inside it, however deep boxes are nested: all pads are relative to the ray and to the box's own planes, not to the scene.
template <class R> class SlabRay {
  public:
    /// `inverse`: of the components of `dir`, in double; those without slope are not asked. `reach` bounds |t| of all points of interest.
    [[gnu::always_inline]] inline SlabRay(const Vec3& origin, const Vec3& dir, const Vec3& inverse, double reach) {
        for (int a = 0; a < 3; ++a) {
            const bool flat = std::abs(dir[a]) < kSmallestSlope<R>;
            const double drift = flat ? (std::abs(dir[a]) + 0x1p-300) * reach : 0;
            const R o = R(origin[a]);
            const R e = 4 * kUnitRoundoff<R> * std::abs(o) + (kOriginPad<R> + R(2 * drift));
            negative_[a] = !flat & (dir[a] < 0);
            const R outward = negative_[a] ? -e : e;
            near_origin_[a] = o + outward;
            far_origin_[a] = o - outward;
            inverse_[a] = flat ? std::numeric_limits<R>::infinity() : R(inverse[a]);
        }
    }

    /// A bound for `enter`: hits at up to t are not lost.
    static R limit(double t) { return R(std::min(padded_up(t, kSlabPad * double(kUnitRoundoff<R>)), double(std::numeric_limits<R>::max()))); }
    static R start(double t) { return R(std::max(padded_down(t, kSlabPad * double(kUnitRoundoff<R>)), -double(std::numeric_limits<R>::max()))); }

    /// Where the ray crosses the planes that bound a slab, as the near and as the far end. Without slope, infinite or (on the plane) NaN.
    R enter_slab(int axis, R low, R high) const { return ((negative_[axis] ? high : low) - near_origin_[axis]) * inverse_[axis]; }
    R leave_slab(int axis, R low, R high) const { return ((negative_[axis] ? low : high) - far_origin_[axis]) * inverse_[axis]; }

    /// Narrows [near, far] by a slab's ends; a NaN keeps the old bound.
    static void narrow(R enter, R leave, R& near, R& far) {
        near = enter > near ? enter : near;
        far = leave < far ? leave : far;
    }
    /// The far end, padded, after all slabs narrowed it.
    static R padded(R far) { return far + std::abs(far) * (kSlabPad * kUnitRoundoff<R>); }

    /// Narrows [near, far] to the box; empty on a miss (near > far, or far is NaN).
    [[gnu::always_inline]] inline void clip(const BoundsT<R>& box, R& near, R& far) const {   // for each node of a walk: a call costs a twentieth of a picture
        for (int a = 0; a < 3; ++a) narrow(enter_slab(a, box.min[a], box.max[a]), leave_slab(a, box.min[a], box.max[a]), near, far);
        far = padded(far);
    }

    /// Where the ray enters the box, not before `start`; infinity if it misses it or enters beyond `limit`.
    R enter(const BoundsT<R>& box, R start, R limit) const {
        R far = limit;
        clip(box, start, far);
        return start <= far && start <= limit ? start : std::numeric_limits<R>::infinity();
    }

    /// What the slabs are computed from, for tests of many boxes at once.
    bool negative(int axis) const { return negative_[axis]; }
    R near_origin(int axis) const { return near_origin_[axis]; }
    R far_origin(int axis) const { return far_origin_[axis]; }
    R inverse(int axis) const { return inverse_[axis]; }

  private:
    R near_origin_[3], far_origin_[3], inverse_[3];
    bool negative_[3];
};

}  // namespace alidade
