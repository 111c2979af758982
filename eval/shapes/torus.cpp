// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"
#include "eval/shapes/bracketed_root.h"
#include "eval/shapes/wanted.h"

namespace alidade {

namespace {

Bounds torus_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }

/// What ranges are widened by, in parts of the size of the torus: far more than any rounding of theirs.
constexpr double kTorusSlack = 1e-9;
/// Extremes are found to this part of the mean of the size and the minor radius: with that as the radius of curvature at the least, the distance from the
/// surface changes by its square there, which is less than its rounding.
constexpr double kNearExtreme = 0x1p-28;

/// Points of a line in order, between which a function has at most one root.
struct Brackets {
    double at[5];
    int count = 0;
    void add(double x) { at[count++] = x; }

    /// Calls found(low, high, find) for the brackets that hold a root, until it returns false; find() is the root. `f` and the last step as bracketed_root() has them.
    template <class F, class Found> void roots(const F& f, double least_step, double precision, const Found& found) const {
        bool positive = f(at[0]).first > 0;
        for (int i = 1; i < count; ++i) {
            const bool before = positive;
            positive = f(at[i]).first > 0;
            if (before != positive && !found(at[i - 1], at[i], [&] { return bracketed_root(f, at[i - 1], at[i], before, least_step, precision); })) return;
        }
    }
};

/// With a minor radius larger than the major one the tube overlaps itself around the axis, and its surface goes on within: a spindle. Without a major radius it
/// is a sphere.
bool is_spindle(double major, double minor) { return minor > major && major > 0; }
bool is_spindle(const Torus& torus) { return is_spindle(std::abs(torus.major), std::abs(torus.minor)); }

/// A line relative to the centre: p + s u with |u| = 1, p being near the centre.
struct TorusLine {
    Vec3 p, u;
    double major, minor;

    /// The distance from the surface, negative in the tube but for where that overlaps itself, and its derivative by s.
    std::pair<double, double> distance(double s) const {
        const Vec3 at = p + s * u;
        const double around = planar_length(at.x, at.z);
        const auto from_tube = [&](double off) {   // `off` outwards from the tube's middle, here and across the axis
            const double from_circle = planar_length(off, at.y);
            return std::pair(from_circle - minor, (off * (at.x * u.x + at.z * u.z) / around + at.y * u.y) / from_circle);
        };
        const std::pair<double, double> here = from_tube(around - major);
        if (!is_spindle(major, minor) || here.first >= 0) return here;
        const std::pair<double, double> across = from_tube(around + major);
        return across.first >= 0 && here.first >= -across.first ? here : std::pair(-across.first, -across.second);
    }

    double size() const { return major + minor; }

    /// Where the line can be in the torus: between the planes that touch it from above and below, and in the ball around it. Nowhere if all of that is in
    /// the hole, which is convex.
    LineInterval range() const {
        const double slack = kTorusSlack * size(), ball = size() * size() - dot(p, p) + slack * size();
        if (!(ball >= 0)) return {kInf, -kInf};
        const double half = std::sqrt(ball) + slack, height = minor + slack;
        LineInterval in{-half, half};
        if (std::abs(p.y) > height || std::abs(u.y) * half > height - std::abs(p.y)) {   // else the planes are not reached
            const double a = (-height - p.y) / u.y, b = (height - p.y) / u.y;
            in = {std::max(in.entry, std::min(a, b) - slack), std::min(in.exit, std::max(a, b) + slack)};
        }
        const double hole = major - minor - slack;
        return hole > 0 && from_axis(in.entry) < hole * hole && from_axis(in.exit) < hole * hole ? LineInterval{kInf, -kInf} : in;
    }

    /// The square of the distance from the axis.
    double from_axis(double s) const {
        const double x = p.x + s * u.x, z = p.z + s * u.z;
        return x * x + z * z;
    }

    /// Is the line outside of the torus all along `range`? True only if it surely is: the quartic that is negative inside is not less than the least of its
    /// Bernstein coefficients, of each half of the range. Source   G. Farin, "Curves and Surfaces for CAGD", 5th ed. (2002), section 6.
    bool surely_outside(const LineInterval& range) const {
        if (!(size() > 1e-70 && size() < 1e70)) return false;   // its fourth power is no number
        const double w = 0.5 * (range.exit - range.entry), middle = range.entry + w, most = kTorusSlack * size() * size() * size() * size();
        return least_coefficient(range.entry, w) > most && least_coefficient(middle, w) > most;
    }

    /// The least Bernstein coefficient of (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2) from `from` to `from` + `width`.
    double least_coefficient(double from, double width) const {
        const Vec3 at = p + from * u;
        const double slope = width * dot(at, u), around_slope = width * (at.x * u.x + at.z * u.z);
        const double a0 = dot(at, at) + (major - minor) * (major + minor), a1 = a0 + slope, a2 = a1 + slope + width * width;
        const double r0 = at.x * at.x + at.z * at.z, r1 = r0 + around_slope, r2 = r1 + around_slope + width * width * (u.x * u.x + u.z * u.z);
        const double k = 4 * major * major;
        const double ends = std::min(a0 * a0 - k * r0, a2 * a2 - k * r2), inner = std::min(a0 * a1 - k * 0.5 * (r0 + r1), a1 * a2 - k * 0.5 * (r1 + r2));
        return std::min({ends, inner, (a0 * a2 + 2 * a1 * a1 - k * 0.5 * (r0 + 4 * r1 + r2)) / 3});
    }

    /// The points of the line in `range`, cut where the quartic (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2) has its extremes. These are roots of a cubic, and
    /// that one's extremes are roots of a quadratic.
    Brackets extremes(const LineInterval& range) const {
        const double b = dot(p, u), k = dot(p, p) + (major - minor) * (major + minor), square = major * major;
        const double c2 = 3 * b, c1 = 2 * b * b + k - 2 * square * (u.x * u.x + u.z * u.z), c0 = b * k - 2 * square * (p.x * u.x + p.z * u.z);
        const auto cubic = [&](double s) { return std::pair(((s + c2) * s + c1) * s + c0, (3 * s + 2 * c2) * s + c1); };
        Brackets of_cubic, out;
        of_cubic.add(range.entry);
        if (const double quarter = b * b - c1 / 3; quarter > 0)
            for (const double s : {-b - std::sqrt(quarter), -b + std::sqrt(quarter)})
                if (s > range.entry && s < range.exit) of_cubic.add(s);
        of_cubic.add(range.exit);
        out.add(range.entry);
        of_cubic.roots(cubic, kNearExtreme * std::sqrt(minor * size()), 0, [&](double, double, const auto& find) { return out.add(find()), true; });
        out.add(range.exit);
        return out;
    }
};

/// The distance found by evaluating it at ray.at(t), and the roundings of that evaluation and of ray.at(t).
ErrorBound torus_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t) {
    const Torus& torus = std::get<Torus>(geometry);
    const Vec3 p = ray.at(t) - torus.center;
    const double major = std::abs(torus.major), minor = std::abs(torus.minor);
    const double around = planar_length(p.x, p.z);
    double off = std::abs(planar_length(around - major, p.y) - minor);
    if (is_spindle(torus)) off = std::min(off, std::abs(planar_length(around + major, p.y) - minor));
    return {off + gamma_bound(10) * (length(p) + major + minor) + at_rounding(ray, t)};
}

/// Units    the shape's space; `t` counts multiples of |ray.dir|.
/// Method   the ray is moved to its point nearest to the centre. No quartic is solved: its extremes only cut the line into parts with at most one crossing,
///          and the crossing is found by bracketed Newton steps on the distance from the surface itself, which carries no fourth powers and cannot lose a
///          root to cancellation. (A quartic whose coefficients are formed at the ray's origin fails for every ray from 1e4 radii away.)
/// Error    of t: <= 4 units of 2^-52 (|t| + (R + r) / |d|) / cosine of the angle to the normal. Held by tests/eval/torus_test.cpp against 113-bit arithmetic.
/// Spindles are crossed where they are in POV-Ray 3.7, up to four times; inside, to it, is all of the tube. So they are no solids.
/// Crossings pair, since both ends of the range that is looked at are outside; a tangent is none or two.
[[gnu::always_inline]] inline Crossings crossings_inline(const Torus& torus, const Bounds& own, const Ray& ray, Wanted wanted) {
    Crossings out;
    const Approach nearest = approach_inline(torus.center, ray);
    const double speed = std::sqrt(dot(ray.dir, ray.dir));
    const TorusLine line{nearest.nearest, ray.dir / speed, std::abs(torus.major), std::abs(torus.minor)};
    if (!is_finite(ray) || !std::isfinite(nearest.shift) || !(line.minor > 0)) return out;
    const LineInterval range = line.range();
    if (range.empty() || line.surely_outside(range)) return out;
    const LineInterval inside = inside_bounds(ray, own);
    if (inside.empty()) return out;
    const auto distance = [&](double s) { return line.distance(s); };
    const auto t_at = [&](double s) { return std::clamp(nearest.shift + (nearest.rest + s / speed), inside.entry, inside.exit); };   // of a later s not less, as rounded
    line.extremes(range).roots(distance, kUnitRoundoff<double> * line.size(), kUnitRoundoff<double>, [&](double low, double high, const auto& find) {
        return add_wanted(ray, wanted, t_at(low), t_at(high), [&] { return t_at(find()); }, out);
    });
    return out;
}

#ifdef __x86_64__
[[gnu::target("fma"), gnu::flatten]] Crossings crossings_with_fma(const Torus& torus, const Bounds& own, const Ray& ray, Wanted wanted) { return crossings_inline(torus, own, ray, wanted); }
#endif

Crossings torus_wanted(const ShapeGeometry& geometry, const Bounds& own, const Ray& ray, Wanted wanted) {
    const Torus& torus = std::get<Torus>(geometry);
#ifdef __x86_64__
    if (kHasFma) return crossings_with_fma(torus, own, ray, wanted);
#endif
    return crossings_inline(torus, own, ray, wanted);
}

Crossings torus_crossings(const ShapeGeometry& geometry, const Ray& ray) { return torus_wanted(geometry, torus_bounds(geometry), whole_line(ray), Wanted::all); }

/// A point relative to the centre, as it lies around the axis and around the tube.
struct AroundTube {
    double around, off, tube;   ///< the distances from the axis, outwards from the tube's middle, and from that middle
    Vec3 outwards;              ///< from the axis
    double cosine, sine;        ///< of the angle around the tube, from `outwards`

    AroundTube(const Torus& torus, const Vec3& p) : around(planar_length(p.x, p.z)), off(around - std::abs(torus.major)), tube(planar_length(off, p.y)) {
        outwards = around > 0 ? Vec3(p.x / around, 0, p.z / around) : Vec3(1, 0, 0);
        cosine = tube > 0 ? off / tube : 1, sine = tube > 0 ? p.y / tube : 0;
    }
    Vec3 normal() const { return normalized(cosine * outwards + Vec3(0, sine, 0)); }
};

/// Of the sheet of a spindle that is nearer.
Vec3 torus_normal(const ShapeGeometry& geometry, const Vec3& point, uint32_t) {
    const Torus& torus = std::get<Torus>(geometry);
    const Vec3 p = point - torus.center;
    const AroundTube at(torus, p);
    const double across = at.around + std::abs(torus.major), minor = std::abs(torus.minor);
    if (!is_spindle(torus) || std::abs(planar_length(across, p.y) - minor) >= std::abs(at.tube - minor)) return at.normal();
    return normalized(across * at.outwards + Vec3(0, p.y, 0));
}

/// POV-Ray 3.7 shades the inner sheets of a spindle as if they were of the tube's near side.
Vec3 torus_shading_normal(const ShapeGeometry& geometry, const Vec3& point) {
    const Torus& torus = std::get<Torus>(geometry);
    return AroundTube(torus, point - torus.center).normal();
}

/// u = 1 - (atan2(z, x) + pi) / 2 pi around the axis, v = (atan2(y, rho - R) + pi) / 2 pi around the tube, 0 and 1 on its inner side.
/// Source   POV-Ray 3.7, measured from renders with uv_mapping.
SurfacePoint torus_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t) {
    const Torus& torus = std::get<Torus>(geometry);
    const Vec3 p = point - torus.center;
    const AroundTube at(torus, p);
    SurfacePoint out;
    out.normal = torus_normal(geometry, point, 0);
    out.uv = {1 - (std::atan2(p.z, p.x) + kPi) / (2 * kPi), (std::atan2(p.y, at.off) + kPi) / (2 * kPi)};
    out.dpdu = (2 * kPi * (at.around > 0 ? at.around : at.tube)) * Vec3(at.outwards.z, 0, -at.outwards.x);
    out.dpdv = (2 * kPi * at.tube) * (Vec3(0, at.cosine, 0) - at.sine * at.outwards);
    return out;
}

bool torus_solid(const ShapeGeometry& geometry) { return !is_spindle(std::get<Torus>(geometry)); }

bool torus_inside(const ShapeGeometry& geometry, const Vec3& point) {
    const Torus& torus = std::get<Torus>(geometry);
    const Vec3 p = point - torus.center;
    return planar_length(planar_length(p.x, p.z) - std::abs(torus.major), p.y) <= std::abs(torus.minor);
}

}  // namespace

const ShapeOps kTorusOps = {"torus", "all points near a circle", kind_of<Torus>(), torus_bounds, torus_crossings, torus_error, torus_surface, torus_inside, torus_solid, nullptr, true, torus_normal, torus_wanted, false, false, torus_shading_normal};

}  // namespace alidade
