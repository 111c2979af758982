// SPDX-License-Identifier: Apache-2.0
#include "core/draws.h"
#include "eval/shapes/shape_ops.h"
#include "numerics/polynomial.h"
#include "numerics/rows.h"

#include <fmt/format.h>

namespace alidade::numerics {

namespace {

constexpr double kMinor = 0.25;   // of a major radius of 1: the coefficients of its quartic are doubles

/// x^4, x^3 y, ... as Polynomial has them; (x^2 + y^2 + z^2 + 1 - r^2)^2 - 4 (x^2 + z^2).
Polynomial torus_quartic() {
    const double k = 1 - kMinor * kMinor;
    Polynomial p;
    p.order = 4, p.coefficients.assign(Polynomial::terms(4), 0.0);
    size_t at = 0;
    for (int x = 4; x >= 0; --x) {
        for (int y = 4 - x; y >= 0; --y) {
            for (int z = 4 - x - y; z >= 0; --z, ++at) {
                double& c = p.coefficients[at];
                const int squares = (x % 2 == 0) + (y % 2 == 0) + (z % 2 == 0);
                if (squares < 3) continue;
                if (x + y + z == 4) c = std::max({x, y, z}) == 4 ? 1 : 2;
                if (x + y + z == 2) c = 2 * k - (y == 2 ? 0 : 4);
                if (x + y + z == 0) c = k * k;
            }
        }
    }
    return p;
}

/// The line's polynomial in s, t = shift + s, for a tube of radius `minor`.
ExactPolynomial along(const Ray& ray, const Exact& shift, const Exact& minor) {
    const ExactVec d(ray.dir), o = ExactVec(ray.origin) + d * shift;
    const auto squared = [](const Exact& from, const Exact& step) { return ExactPolynomial{from * from, 2 * from * step, step * step}; };
    const ExactPolynomial flat = squared(o.x, d.x) + squared(o.z, d.z);
    ExactPolynomial whole = flat + squared(o.y, d.y);
    whole[0] += 1 - minor * minor;
    return whole * whole + ExactPolynomial{exact(-4)} * flat;
}

std::vector<Exact> exact_crossings(const Ray& ray, const Exact& minor) {
    const ExactVec d(ray.dir);
    const Exact shift = -dot(ExactVec(ray.origin), d) / dot(d, d);
    std::vector<Exact> t = real_roots(along(ray, shift, minor));
    for (Exact& x : t) x += shift;
    return t;
}

/// From a distance of 1 to 1e8, to a place in the torus, or past its tube by 1e-3 to 1e-9.
Ray aimed(Draws& draws, NumericsTally& tally) {
    const double distance = std::pow(10, draws.uniform(0.3, 8)), phi = draws.uniform(0, 2 * kPi);
    const Vec3 out(std::cos(phi), 0, std::sin(phi)), from = draws.direction();
    Vec3 side = cross(from, Vec3(-out.z, 0, out.x));
    if (!(length(side) > 1e-3)) side = Vec3(0, 1, 0);
    const bool grazing = draws.coin();
    const double sign = grazing ? draws.sign() : 0, beside = grazing ? std::pow(10, draws.uniform(-9, -3)) : 0;
    const double past = grazing ? kMinor * (1 - sign * beside) : draws.uniform(0, 1.2 * kMinor);
    tally.at(NumericsScale::distance, distance), tally.at(NumericsScale::silhouette, beside);
    const Vec3 aim = out + normalized(side) * past;
    Ray ray;
    ray.origin = aim + from * distance, ray.dir = normalized(aim - ray.origin), ray.tmin = -kInf;
    return ray;
}

}  // namespace

Check quartic_far() {
    const auto solids = std::make_shared<std::vector<ShapeGeometry>>(std::vector<ShapeGeometry>{Torus{Vec3(0), 1, kMinor}, torus_quartic()});
    return [solids](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(10, 0, number));
        const Ray ray = aimed(draws, tally);
        const double unit = ulp(std::max(1.0, length(ray.origin)));
        const Exact minor = exact(kMinor), band = exact(4 * unit);
        const std::vector<Exact> t = exact_crossings(ray, minor);
        const bool undecided = exact_crossings(ray, minor + band).size() != t.size() || exact_crossings(ray, minor - band).size() != t.size();
        if (undecided) return;
        for (const ShapeGeometry& solid : *solids) {
            const ShapeOps& ops = *find_shape(solid);
            const Crossings got = ops.crossings(solid, ray);
            const auto what = [&] {
                return fmt::format("{} 1, {}; ray <{}, {}, {}> + t <{}, {}, {}>: {} crossings of {}", ops.name, kMinor, ray.origin.x, ray.origin.y, ray.origin.z, ray.dir.x, ray.dir.y, ray.dir.z, got.count, t.size());
            };
            tally.decide(size_t(got.count) == t.size(), what);
            if (size_t(got.count) != t.size()) continue;
            for (size_t i = 0; i < t.size(); ++i) {
                const double t_error = to_double(abs(exact(got.at[i].t) - t[i])), cosine = std::abs(dot(ops.normal_at(solid, ray.at(got.at[i].t), got.at[i].part), ray.dir));
                tally.measure(t_error * cosine / unit, 4, what);
            }
        }
    };
}

}  // namespace alidade::numerics
