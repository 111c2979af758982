// SPDX-License-Identifier: Apache-2.0
/// Axes exchanged and mirrored: nothing in space is preferred.
#include "accel/accelerator.h"
#include "core/draws.h"
#include "eval/shapes/shape_ops.h"
#include "numerics/exact.h"
#include "numerics/rows.h"
#include "numerics/shape_samples.h"
#include "numerics/triangles/rays.h"

#include <fmt/format.h>

#include <array>

namespace alidade::numerics {

namespace {

/// Exchanges axes and turns some of them round: exact, whatever the numbers.
struct Axes {
    std::array<int, 3> from{0, 1, 2};
    Vec3 sign{1};

    explicit Axes(Draws& draws) {
        for (int k = 2; k > 0; --k) std::swap(from[size_t(k)], from[draws.below(size_t(k) + 1)]);
        for (int k = 0; k < 3; ++k) sign[k] = draws.sign();
    }
    template <class V> V vector(const V& v) const {
        V out = v;
        for (int k = 0; k < 3; ++k) out[k] = v[from[size_t(k)]] * typename V::value_type(sign[k]);
        return out;
    }
    Ray ray(const Ray& r) const {
        Ray out = r;
        out.origin = vector(r.origin), out.dir = vector(r.dir);
        return out;
    }
    bool only_mirrors() const { return from == std::array{0, 1, 2}; }
    std::string text() const { return fmt::format("axes {}{}, {}{}, {}{}", sign.x < 0 ? "-" : "", from[0], sign.y < 0 ? "-" : "", from[1], sign.z < 0 ? "-" : "", from[2]); }
};

// ---- Closed forms that can be written with other axes ----

Plane turned(const Plane& p, const Axes& a) { return {a.vector(p.normal), p.distance}; }
Sphere turned(const Sphere& s, const Axes& a) { return {a.vector(s.center), s.radius}; }
Box turned(const Box& b, const Axes& a) { return {a.vector(b.a), a.vector(b.b)}; }
Disc turned(const Disc& d, const Axes& a) { return {a.vector(d.center), a.vector(d.normal), d.radius, d.hole}; }
Cylinder turned(const Cylinder& c, const Axes& a) { return {a.vector(c.a), a.vector(c.b), c.radius, c.open}; }
Cone turned(const Cone& c, const Axes& a) { return {a.vector(c.a), a.vector(c.b), c.radius_a, c.radius_b, c.open}; }
Quadric turned(const Quadric& q, const Axes& a) {
    Quadric out = q;
    for (size_t k = 0; k < 3; ++k) out.squares[int(k)] = q.squares[a.from[k]], out.linear[int(k)] = q.linear[a.from[k]] * a.sign[int(k)];
    constexpr int kProduct[3][3] = {{-1, 0, 1}, {0, -1, 2}, {1, 2, -1}};   // xy, xz, yz
    for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < i; ++k) out.products[kProduct[i][k]] = q.products[kProduct[a.from[i]][a.from[k]]] * a.sign[int(i)] * a.sign[int(k)];
    return out;
}
Polynomial turned(const Polynomial& f, const Axes& a) {
    Polynomial out = f;
    std::array<int, 3> to{};
    for (size_t k = 0; k < 3; ++k) to[size_t(a.from[k])] = int(k);
    size_t at = 0;
    for (int i = f.order; i >= 0; --i)
        for (int j = f.order - i; j >= 0; --j)
            for (int k = f.order - i - j; k >= 0; --k, ++at) {
                std::array<int, 3> powers{};
                powers[size_t(to[0])] = i, powers[size_t(to[1])] = j, powers[size_t(to[2])] = k;
                const double sign = (powers[0] % 2 ? a.sign.x : 1) * (powers[1] % 2 ? a.sign.y : 1) * (powers[2] % 2 ? a.sign.z : 1);
                out.coefficients[power_index(f.order, powers[0], powers[1], powers[2])] = f.coefficients[at] * sign;
            }
    return out;
}
Polygon turned(const Polygon& p, const Axes& a) {
    Polygon out = p;
    for (auto& loop : out.loops)
        for (Vec3& corner : loop) corner = a.vector(corner);
    return out;
}
Torus turned(const Torus& t, const Axes& a) { return {a.vector(t.center), t.major, t.minor}; }
Extrusion turned(const Extrusion& e, const Axes& a) {
    Extrusion out = e;
    for (Outline& outline : out.outlines)
        for (Vec2& p : outline.points) p = Vec2(a.vector(Vec3(p, 0)));
    if (a.sign.z < 0) out.bottom = -e.top, out.top = -e.bottom;
    return out;
}
Mesh turned(const Mesh& m, const Axes&) { return m; }   // not in the table of closed forms

/// A torus lies about y, an extrusion along z.
bool keeps_its_axis(const ShapeGeometry& g, const Axes& a) { return !(std::holds_alternative<Torus>(g) && a.from[1] != 1) && !(std::holds_alternative<Extrusion>(g) && a.from[2] != 2); }

void closed_form(uint64_t number, Draws& draws, NumericsTally& tally) {
    const ShapeOps& ops = shapes()[number % shapes().size()];
    ShapeDraw draw{draws};
    const ShapeGeometry shape = sample_shape(ops, int(draws.below(10)), draw);
    Axes axes(draws);
    while (!keeps_its_axis(shape, axes)) axes = Axes(draws);
    const ShapeGeometry other = std::visit([&](const auto& s) -> ShapeGeometry { return turned(s, axes); }, shape);
    Ray ray;
    const Vec3 aim = draws.in_box(Vec3(-1), Vec3(1));
    ray.origin = aim + draws.direction() * std::pow(10, draws.uniform(0, 3)), ray.dir = normalized(aim - ray.origin);
    const Crossings a = ops.crossings(shape, ray), b = ops.crossings(other, axes.ray(ray));
    const auto what = [&] { return fmt::format("{}, {}; {}: {} and {} crossings", ops.name, axes.text(), describe(ray), a.count, b.count); };
    tally.decide(a.count == b.count, what);
    if (a.count != b.count) return;
    for (size_t i = 0; i < size_t(a.count); ++i) {
        const double cosine = std::abs(dot(ops.normal_at(shape, ray.at(a.at[i].t), a.at[i].part), ray.dir));
        const double error = std::abs(a.at[i].t - b.at[i].t) * cosine / ulp(std::max(std::abs(a.at[i].t), length(ray.origin)));
        if (axes.only_mirrors()) tally.decide(a.at[i].t == b.at[i].t, what);
        tally.falls_short(!axes.only_mirrors() && error <= 16);
        tally.measure(error, 1, what);
        tally.falls_short(false);
    }
}

// ---- Triangles ----

struct Soup {
    std::vector<Vec3f> rounded;
    std::vector<Vec3> positions;
    std::vector<Index3> triangles;

    /// How far the farthest corner of a triangle is from a point, or the point itself from zero: the longest of what its t is computed from.
    double farthest(uint32_t triangle, const Vec3& from) const {
        double d = length(from);
        for (int k = 0; k < 3; ++k) d = std::max(d, distance(positions[triangles[triangle][k]], from));
        return d;
    }
    std::unique_ptr<Accelerator> build(const AcceleratorEntry& entry, Precision precision) const {
        AccelOptions options;
        options.precision = precision;
        return entry.over_triangles({rounded, positions, triangles}, options);
    }
};

/// Triangles of any size; their corners on a lattice in half of the cases, so that rays meet edges.
Soup soup(Draws& draws, Precision precision) {
    Soup s;
    const bool lattice = draws.coin();
    const uint32_t count = 1 + draws.below(40);
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 center = draws.in_box(Vec3(-1), Vec3(1));
        const double size = std::pow(10, draws.uniform(-3, 0.3));
        for (int k = 0; k < 3; ++k) {
            Vec3 p = center + draws.in_box(Vec3(-size), Vec3(size));
            if (lattice) p = glm::round(p * 16.0) / 16.0;
            s.rounded.emplace_back(p), s.positions.push_back(precision == Precision::float_ ? Vec3(s.rounded.back()) : p);
        }
        s.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return s;
}

void triangles(uint64_t number, Draws& draws, NumericsTally& tally) {
    const AcceleratorEntry& entry = accelerators()[number % accelerators().size()];
    const Precision precision = draws.coin() ? Precision::float_ : Precision::double_;
    const Soup one = soup(draws, precision);
    const Axes axes(draws);
    Soup other = one;
    for (Vec3f& p : other.rounded) p = axes.vector(p);
    for (Vec3& p : other.positions) p = axes.vector(p);
    const auto a = one.build(entry, precision), b = other.build(entry, precision);
    for (int i = 0; i < 20; ++i) {
        Ray ray;
        const Vec3 aim = draws.coin() ? one.positions[draws.below(one.positions.size())] : draws.in_box(Vec3(-1), Vec3(1));
        ray.origin = draws.in_box(Vec3(-3), Vec3(3));
        if (draws.coin()) ray.origin = glm::round(ray.origin * 16.0) / 16.0;
        ray.dir = aim - ray.origin;
        Hit x, y;
        WorkCounters work;
        a->intersect(ray, x, work), b->intersect(axes.ray(ray), y, work);
        const auto what = [&] { return fmt::format("{}, {}, {}; {}: t {} and {}, triangles {} and {}", entry.name, precision == Precision::float_ ? "float" : "double", axes.text(), describe(ray), x.t, y.t, x.primitive, y.primitive); };
        tally.decide(x.primitive == y.primitive, what);
        if (!x.valid() || !y.valid()) continue;
        const double error = std::abs(x.t - y.t) / std::max(ulp(x.t), ulp(one.farthest(x.primitive, ray.origin)) / length(ray.dir));
        if (axes.only_mirrors()) tally.decide(x.t == y.t, what);
        tally.falls_short(!axes.only_mirrors() && error <= 5);
        tally.measure(error, 1, what);
        tally.falls_short(false);
    }
}

}  // namespace

Check axes_permute() {
    return [](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(14, 0, number));
        if (number % 4 == 0) triangles(number / 4, draws, tally);
        else closed_form(number - number / 4 - 1, draws, tally);
    };
}

}  // namespace alidade::numerics
