// SPDX-License-Identifier: Apache-2.0
/// The first test of triangles: eight at once, in the precision of the mesh. It rejects only those that are surely outside.
#pragma once

#include "accel/accelerator.h"
#include "accel/local_ray.h"
#include "accel/triangles/behind.h"

#include <array>

namespace alidade {

inline constexpr uint32_t kLanes = 8;

/// Eight triangles, coordinate by coordinate: v[3 * corner + axis][lane], and their ids in the source arrays.
template <class T> struct alignas(64) TriangleBlock {
    T v[9][kLanes];
    uint32_t id[kLanes];

    std::array<Vec3, 3> corners(uint32_t lane) const {
        std::array<Vec3, 3> c;
        for (int i = 0; i < 9; ++i) c[size_t(i / 3)][i % 3] = double(v[i][lane]);
        return c;
    }
    void put(const std::array<Vec3, 3>& c, uint32_t lane) {
        for (int i = 0; i < 9; ++i) v[i][lane] = T(c[size_t(i / 3)][i % 3]);
    }
};

/// The axes by the size of the direction's components: z is along the largest, the order stays cyclic so that orientations are kept.
struct ShearAxes {
    int x, y, z;
    explicit ShearAxes(const Vec3& dir) {
        static constexpr int kAfter[] = {1, 2, 0, 1};
        const double ax = std::abs(dir.x), ay = std::abs(dir.y), az = std::abs(dir.z);
        const int up = az > std::max(ax, ay);   // no branch: directions are random
        z = up << 1 | (int(ay > ax) & ~up);
        x = kAfter[z], y = kAfter[z + 1];
    }
};

/// The error of computed edge functions: one that is greater in magnitude has the sign of the exact one. Derived in docs/numerics.md, "The edge functions".
/// `origin`: bounds |origin| of a sheared axis, 0 if the origin was not rounded; `slope`: bounds the shear of the axis; `m`: largest sheared coordinate of
/// the corners; `depth`: largest |z| of the corners.
template <class T> struct EdgeError {
    static constexpr T u = kUnitRoundoff<T>;
    static constexpr T kOrigin = T(1.25) * u, kSheared = T(3.25) * u, kDepth = T(4.5) * u, kLinear = T(2.25), kSquare = T(3);
    static constexpr T kQuanta = 8 * std::numeric_limits<T>::denorm_min();

    static T corner(T origin, T slope, T m, T depth) { return kOrigin * origin + kSheared * m + kDepth * (slope * depth) + kQuanta; }
    static T edge(T dx, T dy, T mx, T my) { return kLinear * (dx * my + dy * mx) + kSquare * (dx * dy) + kQuanta; }
    /// The same for all three functions at once, as the filter asks: `blur` is A + C depth of a FilterRay, `m` the largest sheared coordinate of both axes. Where a
    /// product of coordinates overflows, m m does.
    static constexpr T kBoth = 2 * kLinear, kBothSheared = kBoth * kSheared;
    static T bound(T blur, T m) {
        const T d = blur + kSheared * m;
        return (kBoth * m) * blur + (kBothSheared * (m * m) + (kSquare * (d * d) + kQuanta));
    }
    /// Bounds a rounded shear: what underflow took from it is put back.
    static T slope(T shear) { return std::abs(shear) + 2 * std::numeric_limits<T>::min(); }
};

/// What the filter needs of a ray: p - origin is sheared along the direction, x' = x - shear[0] z, y' = y - shear[1] z. `asked`: begins_at_origin().
template <class T> struct FilterRay {
    [[gnu::always_inline]] inline FilterRay(const LocalRay& ray, const ShearAxes& shear_axes, double shear_x, double shear_y, bool asked)
        : axes(shear_axes), origin{T(component(ray.origin, axes.x)), T(component(ray.origin, axes.y)), T(component(ray.origin, axes.z))} {
        using Error = EdgeError<T>;
        shear[0] = T(shear_x), shear[1] = T(shear_y);
        T farthest = 0, slope = 0;
        for (int i = 0; i < 2; ++i) {
            const T bound = Error::slope(shear[i]);
            slope = std::max(slope, bound), farthest = std::max(farthest, std::abs(origin[i]) + bound * std::abs(origin[2]));
        }
        origin_blur = Error::kOrigin * farthest + Error::kQuanta, depth_blur = Error::kDepth * slope;
        ahead = -std::copysign(T(1), T(component(ray.dir, axes.z))), behind_blur = BehindError<T>::blur(origin, asked);
    }

    ShearAxes axes;
    T origin[3], shear[2];
    T ahead, behind_blur;        ///< which way depths, from the corners to the origin, are ahead
    T origin_blur, depth_blur;   ///< a sheared coordinate is off by this, and this times the depth, and EdgeError::kSheared of itself
};

/// Bit i is set if triangle i of the block may be hit by the line of the ray; if `near`, not behind its origin, where is_behind() can tell.
template <class T> using EdgeFilter = uint32_t (*)(const TriangleBlock<T>&, const FilterRay<T>&, bool near);

/// The filter for these instructions; the scalar one if this machine does not have them. All that fuse (isa.h) give the same bits, and so do the others.
template <class T> EdgeFilter<T> edge_filter(Isa isa);
template <> EdgeFilter<float> edge_filter<float>(Isa isa);
template <> EdgeFilter<double> edge_filter<double>(Isa isa);

}  // namespace alidade
