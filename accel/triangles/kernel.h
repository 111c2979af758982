// SPDX-License-Identifier: Apache-2.0
/// What a leaf of triangles does for each kind of Intersect: a filter of eight lanes, and an answer for each lane that passes it.
#pragma once

#include "accel/triangles/decide.h"
#include "accel/triangles/moller_trumbore.h"
#include "accel/triangles/watertight.h"
#include "core/ray.h"

namespace alidade {

/// Intersect::robust has two: in the lanes where boxes are widened for it, as those of the BVH are, else in double.
enum class TriangleTest { exact, watertight, watertight_in_double, fast };

/// R: of the mesh.
///
/// - `Ray`: what it makes of a ray, once; its `filter` is for the lanes. `kEntry`: where it is to begin, see local_ray().
/// - `crossing`: of a lane that passed, in local t; nothing where the triangle is not hit. Crossings that are surely before the local interval or beyond `limit` may be left out.
/// - `error`: how far ray.at(t) may be from the triangle's plane, as far as what is spawned there must know.
template <class R, TriangleTest test> struct TriangleKernel;

template <class R> struct TriangleKernel<R, TriangleTest::exact> {
    static constexpr RayEntry kEntry{true, kFar};
    struct Ray {
        [[gnu::always_inline]] inline Ray(const alidade::Ray& ray, const LocalRay& local) : Ray(local, ShearAxes(local.dir), begins_at_origin(ray, local)) {}
        /// The axes by themselves: copied from one to the other, two numbers would be read where one was just written, and wait.
        [[gnu::always_inline]] inline Ray(const LocalRay& local, const ShearAxes axes, bool asked) : decide(local, axes), filter(local, axes, decide.shear_x, decide.shear_y, asked) {}
        DecideRay decide;
        FilterRay<R> filter;
    };
    static EdgeFilter<R> filter(Isa isa) { return edge_filter<R>(isa); }
    static std::optional<TriangleCrossing> crossing(const Ray& ray, const LocalRay& local, const TriangleBlock<R>&, uint32_t, const Corners& corners, double limit, WorkCounters& work) {
        return decide(ray.decide, corners, local.tmin, limit, work.exact);
    }
    static ErrorBound error(const alidade::Ray& ray, double t, const Corners& corners) { return plane_error(ray, t, corners); }
};

template <class R> struct TriangleKernel<R, TriangleTest::watertight_in_double> : TriangleKernel<R, TriangleTest::exact> {
    using Ray = typename TriangleKernel<R, TriangleTest::exact>::Ray;
    static std::optional<TriangleCrossing> crossing(const Ray& ray, const LocalRay&, const TriangleBlock<R>&, uint32_t, const Corners& corners, double, WorkCounters&) { return decide_watertight(ray.decide, corners); }
};

template <class R> struct TriangleKernel<R, TriangleTest::watertight> {
    static constexpr RayEntry kEntry{true, 2};   // pads grow with the distance
    struct Ray {
        Ray(const alidade::Ray& ray, const LocalRay& local) : filter(local, begins_at_origin(ray, local)) {}
        WatertightRay<R> filter;
    };
    static WatertightTest<R> filter(Isa isa) { return watertight_test<R>(isa); }
    static std::optional<TriangleCrossing> crossing(const Ray& ray, const LocalRay& local, const TriangleBlock<R>& block, uint32_t lane, const Corners& corners, double, WorkCounters& work) {
        if (ray.filter.unsure >> lane & 1) {
            ++work.exact;
            if (!is_met(block, lane, ray.filter)) return std::nullopt;
        }
        return crossing_within(local, ray.filter.axes.z, corners);
    }
    static ErrorBound error(const alidade::Ray& ray, double t, const Corners& corners) { return plane_error(ray, t, corners); }
};

template <class R> struct TriangleKernel<R, TriangleTest::fast> {
    static constexpr RayEntry kEntry{false, kFar};
    struct Ray {
        Ray(const alidade::Ray& ray, const LocalRay& local) : filter(local, local.lower(ray.tmin), local.upper(ray.tmax)) {}
        FastRay<R> filter;
    };
    static FastTest<R> filter(Isa isa) { return fast_test<R>(isa); }
    static std::optional<TriangleCrossing> crossing(const Ray& ray, const LocalRay&, const TriangleBlock<R>&, uint32_t lane, const Corners&, double limit, WorkCounters&) {
        const FastRay<R>& found = ray.filter;
        if (double(found.t[lane]) > double(SlabRay<R>::limit(limit))) return std::nullopt;   // t is rounded to R, the limit is not: a wall of the bounds is at it
        return TriangleCrossing{double(found.t[lane]), double(found.u[lane]), double(found.v[lane])};
    }
    /// The next ray's test rounds its origin to R, and all that follows.
    static ErrorBound error(const alidade::Ray& ray, double t, const Corners& corners) {
        const Vec3 at = ray.at(t);
        return {plane_error(ray, t, corners).along_normal + gamma_bound<R>(8) * double(max_abs(at) + max_abs(corners[0] - at))};
    }
};

}  // namespace alidade
