// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/decide.h"

#include "accel/triangles/exact_sign.h"

namespace alidade {

namespace {

/// Weights need not be better than this, so that t and (u, v) are right to float.
constexpr double kWeightError = 0x1p-34;
/// Nor t than this, relatively.
constexpr double kDepthError = 0x1p-30;
/// More than clamping moves such a t, and all roundings around it.
constexpr double kClampSlack = 0x1p-28;
/// More than what rounds in t, in the planes' t and in a point at t, of the magnitudes that these are made of.
constexpr double kInsideSlack = 0x1p-49;

/// Edge functions of the sides opposite to each corner; all signs are exact.
struct EdgeFunctions {
    std::array<double, 3> e;
    std::array<double, 3> z;   ///< depths of the corners along the shear axis
    double depth = 0;          ///< largest |z|
    double error = 0;          ///< of each function

    double sum() const { return e[0] + e[1] + e[2]; }
    double largest() const { return std::max(std::max(e[0], e[1]), e[2]); }
    double least() const { return std::min(std::min(e[0], e[1]), e[2]); }
    bool outside() const { return (largest() > 0) == (least() < 0); }   // on both sides, or edge-on
};

/// Evaluates those that their error leaves open; all of them if weights are `blurred`.
[[gnu::noinline]] void make_exact(const DecideRay& ray, const Corners& corners, bool blurred, EdgeFunctions& f, uint64_t& exact) {
    for (size_t c = 0; c < 3; ++c) {
        if (!blurred && std::abs(f.e[c]) > f.error) continue;
        f.e[c] = exact_edge(ray.dir, ray.origin, corners[(c + 1) % 3], corners[(c + 2) % 3]) / ray.dir_z;
        ++exact;
    }
    if (blurred) f.error = 0;
}

EdgeFunctions edge_functions(const DecideRay& ray, const Corners& corners, uint64_t& exact) {
    using Error = EdgeError<double>;
    EdgeFunctions f;
    std::array<double, 3> x, y;
    double mx = 0, my = 0;
    for (size_t c = 0; c < 3; ++c) {
        f.z[c] = component(corners[c], ray.axes.z) - component(ray.origin, ray.axes.z);
        x[c] = (component(corners[c], ray.axes.x) - component(ray.origin, ray.axes.x)) - ray.shear_x * f.z[c];
        y[c] = (component(corners[c], ray.axes.y) - component(ray.origin, ray.axes.y)) - ray.shear_y * f.z[c];
        mx = std::max(mx, std::abs(x[c])), my = std::max(my, std::abs(y[c])), f.depth = std::max(f.depth, std::abs(f.z[c]));
    }
    f.e = {x[1] * y[2] - y[1] * x[2], x[2] * y[0] - y[2] * x[0], x[0] * y[1] - y[0] * x[1]};
    const double dx = Error::corner(0, Error::slope(ray.shear_x), mx, f.depth), dy = Error::corner(0, Error::slope(ray.shear_y), my, f.depth);
    const double error = Error::edge(dx, dy, mx, my);
    if (f.largest() > error && f.least() < -error) return f;   // surely outside: the other sign does not matter
    f.error = error;
    const bool blurred = !(error <= kWeightError * std::abs(f.sum()));
    if (blurred || std::min(std::min(std::abs(f.e[0]), std::abs(f.e[1])), std::abs(f.e[2])) <= error) make_exact(ray, corners, blurred, f, exact);
    return f;
}

/// t from the plane, n.(a - o) / n.d with n = (b - a) x (c - a), where the depths of the corners cancel: close to a triangle that is large.
double t_of_plane(const DecideRay& ray, const Corners& c, uint64_t& exact) {
    Vec3 high = c[0] - ray.origin, low;
    for (int a = 0; a < 3; ++a) {
        const double part = high[a] - c[0][a];
        low[a] = (c[0][a] - (high[a] - part)) - (ray.origin[a] + part);   // the difference is high + low, exactly
    }
    const double scale = std::ldexp(1.0, std::clamp(std::ilogb(max_abs(high)), -1000, 1000));
    const double along = exact_edge(high / scale, c[0], c[1], c[2]) + exact_edge(low / scale, c[0], c[1], c[2]);
    exact += 3;
    return along / exact_edge(ray.dir, c[0], c[1], c[2]) * scale;
}

struct Extent {
    double low, high;
};

Extent extent(const Corners& c, int axis) {
    return {std::min(std::min(c[0][axis], c[1][axis]), c[2][axis]), std::max(std::max(c[0][axis], c[1][axis]), c[2][axis])};
}

/// Moves t into the interval in which the ray is in the box of the corners, by division.
[[gnu::noinline]] double clamped_by_division(const DecideRay& ray, const Corners& corners, double t) {
    double enter = -kInf, leave = kInf;
    for (int a = 0; a < 3; ++a) {
        if (ray.dir[a] == 0) continue;
        const auto [low, high] = extent(corners, a);
        const double t0 = (low - ray.origin[a]) / ray.dir[a], t1 = (high - ray.origin[a]) / ray.dir[a];
        enter = std::max(enter, std::min(t0, t1)), leave = std::min(leave, std::max(t0, t1));
    }
    return std::min(std::max(t, enter), leave);
}

/// The same, where boxes are culled by t the hit is then inside. Points that are in the box by more than all roundings need no division to tell that t stays.
double clamped_to_box(const DecideRay& ray, const Corners& corners, double t) {
    bool inside = true;
    for (int a = 0; a < 3; ++a) {
        const auto [low, high] = extent(corners, a);
        const double travel = t * ray.dir[a], at = ray.origin[a] + travel;
        const double slack = kInsideSlack * (std::abs(ray.origin[a]) + std::abs(travel) + (std::abs(low) + std::abs(high)));
        inside &= (at - low > slack) & (high - at > slack);
    }
    return inside ? t : clamped_by_division(ray, corners, t);
}

}  // namespace

std::optional<TriangleCrossing> decide(const DecideRay& ray, const Corners& corners, double low, double high, uint64_t& exact) {
    const EdgeFunctions f = edge_functions(ray, corners, exact);
    if (f.outside()) return std::nullopt;
    const double sum = f.sum(), a = f.e[0] / sum, b = f.e[1] / sum, c = f.e[2] / sum;
    const double depth = (a * f.z[0] + b * f.z[1]) + c * f.z[2], error = (3 * f.error / std::abs(sum) + 8 * kUnitRoundoff<double>) * f.depth;
    const bool sharp = error <= kDepthError * std::abs(depth);
    const double at = depth / ray.dir_z, slack = kClampSlack * std::abs(at);
    if (at + error + slack < low) return std::nullopt;              // |dir[z]| >= 1, so that error bounds that of t
    if (sharp && at - slack > high) return std::nullopt;            // else t comes from the plane: `high` is not everywhere the same, t must be
    return TriangleCrossing{clamped_to_box(ray, corners, sharp ? at : t_of_plane(ray, corners, exact)), b, c};
}

}  // namespace alidade
