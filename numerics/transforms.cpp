// SPDX-License-Identifier: Apache-2.0
/// A sphere under transforms that stretch, shear and turn it as far as numbers go: where it is hit, and its normal there.
#include "core/draws.h"
#include "numerics/exact.h"
#include "numerics/rows.h"
#include "numerics/scene_maker.h"
#include "scene/queries.h"
#include "tracer/compiled_scene.h"
#include "tracer/shade_point.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace alidade::numerics {

namespace {

/// An affine map, of the numbers as they are.
struct ExactMap {
    std::array<ExactVec, 3> columns;
    ExactVec shift;

    explicit ExactMap(const Transform& t) : columns{ExactVec(t.linear[0]), ExactVec(t.linear[1]), ExactVec(t.linear[2])}, shift(t.translation) {}
    ExactVec vector(const ExactVec& v) const { return columns[0] * v.x + columns[1] * v.y + columns[2] * v.z; }
    ExactMap then(const ExactMap& outer) const {
        ExactMap both = *this;
        for (ExactVec& c : both.columns) c = outer.vector(c);
        both.shift = outer.vector(shift) + outer.shift;
        return both;
    }
    Exact determinant() const { return dot(columns[0], cross(columns[1], columns[2])); }
    /// Of the outward normal there, up to its length: by the cofactors, which are the inverse transpose times the determinant.
    ExactVec normal(const ExactVec& n) const {
        const ExactVec mapped = cross(columns[1], columns[2]) * n.x + cross(columns[2], columns[0]) * n.y + cross(columns[0], columns[1]) * n.z;
        return determinant() < 0 ? mapped * Exact(-1) : mapped;
    }
    /// The vector that is mapped to `v`.
    ExactVec back(const ExactVec& v) const {
        const Exact d = determinant();
        return {dot(cross(columns[1], columns[2]), v) / d, dot(cross(columns[2], columns[0]), v) / d, dot(cross(columns[0], columns[1]), v) / d};
    }
};

Transform turn(Draws& draws) { return Transform::rotate(draws.direction(), draws.uniform(0, 2 * kPi)); }

/// By 10^-range to 10^range, an axis by itself, and mirrored in half of them.
Transform stretch(Draws& draws, double range) {
    Vec3 s(0);
    for (int k = 0; k < 3; ++k) s[k] = draws.sign() * std::pow(10, draws.uniform(-range, range));
    return Transform::scale(s);
}

Transform shear(Draws& draws) {
    Transform t;
    const int to = int(draws.below(3));
    t.linear[(to + 1 + int(draws.below(2))) % 3][to] = draws.sign() * std::pow(10, draws.uniform(0, 6));
    return t;
}

/// From the outermost to the innermost.
std::vector<Transform> chain(Draws& draws, uint64_t kind) {
    switch (kind) {
        case 0: return {Transform::translate(draws.in_box(Vec3(-1), Vec3(1))), stretch(draws, 12), turn(draws)};
        // One matrix each: a product of two is rounded, and that alone turns normals by the condition times 1e-16.
        case 1: return {turn(draws) * stretch(draws, 6)};
        case 2: return {shear(draws) * turn(draws)};
        case 3: return {Transform::translate(draws.in_box(Vec3(-10), Vec3(10))), turn(draws) * shear(draws)};
        default: break;
    }
    std::vector<Transform> steps;
    for (int i = 0; i < 10; ++i) {
        const Transform there = Transform::translate(draws.in_box(Vec3(-10), Vec3(10))) * turn(draws);
        steps.insert(steps.end(), {there, stretch(draws, 0.3), alidade::inverse(there).value_or(Transform())});   // about some place, along some axes
    }
    return steps;
}

ExactMap product(const std::vector<Transform>& steps) {
    ExactMap all((Transform()));
    for (size_t i = steps.size(); i-- > 0;) all = all.then(ExactMap(steps[i]));
    return all;
}

struct PlacedBySteps {
    std::shared_ptr<const CompiledScene> scene;
    Transform rounded;
    std::string said;
};

PlacedBySteps placed_by(const std::vector<Transform>& steps, Draws& draws) {
    PlacedBySteps p;
    SceneMaker maker;
    uint32_t parent = kNoId;
    for (size_t i = 0; i < steps.size(); ++i) {
        p.rounded = p.rounded * steps[i];
        Node n;
        n.to_parent = steps[i];
        parent = maker.node(std::move(n), parent);
    }
    maker.object(Sphere{}, maker.unlit(Color(1)), {}, parent);
    CompileOptions options;
    options.accel = accelerators()[draws.below(accelerators().size())].name, options.threads = 1;
    Diagnostics said = validate(maker.scene);   // as importers do
    p.scene = compile(maker.scene, options, said), p.said = said.text();
    return p;
}

/// From a few radii away, to a point of it.
Ray aimed(const Transform& place, Draws& draws) {
    const Vec3 at = draws.direction(), from = normalized(at + 0.8 * draws.direction()) * draws.uniform(1.5, 4);
    Ray ray;
    ray.origin = place.point(from), ray.dir = place.vector(at - from);
    return ray;
}

void hit_and_normal(uint64_t kind, Draws& draws, NumericsTally& tally) {
    const std::vector<Transform> steps = chain(draws, kind);
    const PlacedBySteps p = placed_by(steps, draws);
    const ExactMap exact = product(steps);
    const Ray ray = aimed(p.rounded, draws);
    const auto what = [&] { return fmt::format("transform of kind {}; ray <{}, {}, {}> + t <{}, {}, {}>", kind, ray.origin.x, ray.origin.y, ray.origin.z, ray.dir.x, ray.dir.y, ray.dir.z); };
    const ExactVec o = exact.back(ExactVec(ray.origin) - exact.shift), d = exact.back(ExactVec(ray.dir));
    const std::vector<Exact> t = quadratic_roots(dot(d, d), dot(o, d), dot(o, o) - 1);
    if (t.empty()) return;
    const ExactVec at = o + d * t[0];
    if (-dot(at, d) < length(d) / 10) return;   // nearly a tangent
    Hit hit;
    WorkCounters work;
    const bool found = p.scene && p.scene->top->intersect(ray, hit, work);
    tally.decide(found, what);
    if (!found) return;
    const ShadePoint point = shade_point(*p.scene, ray, hit);
    const ExactVec n = exact.normal(at), got(point.geometric_normal);
    tally.measure(to_double(length(n * (1 / length(n)) - got * (1 / length(got)))), 1e-6, what);
    // How far the sphere is from the point, to the first order, against what the point knows of that.
    const ExactVec q = exact.back(ExactVec(point.position) - exact.shift);
    tally.decide(to_double(abs(dot(q, q) - 1) / 2 * abs(exact.determinant()) / length(exact.normal(q))) <= point.error, what);
}

/// What has no inverse is told; nothing is NaN.
void singular(Draws& draws, NumericsTally& tally) {
    Transform flat;
    switch (draws.below(4)) {
        case 0: flat.linear[int(draws.below(3))] = Vec3(0); break;
        case 1: flat.linear[2] = flat.linear[0] * draws.uniform(-1, 1) + flat.linear[1] * draws.uniform(-1, 1); break;
        case 2: flat.linear[int(draws.below(3))][int(draws.below(3))] = draws.coin() ? kInf : std::numeric_limits<double>::quiet_NaN(); break;
        default: flat = turn(draws) * Transform::scale({1, draws.coin() ? 0 : 1e-320, 1}); break;
    }
    const PlacedBySteps p = placed_by({turn(draws), flat, turn(draws)}, draws);
    Hit hit;
    WorkCounters work;
    const bool found = p.scene && p.scene->top->intersect(aimed(turn(draws), draws), hit, work);
    tally.decide((!found || std::isfinite(hit.t)) && p.said.find("transform") != std::string::npos, [&] { return "a singular transform is used, or left out without a word: " + p.said; });
}

}  // namespace

Check transform_extreme() {
    return [](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(20, 0, number));
        constexpr uint64_t kKinds = 6;
        if (number % kKinds == 5) singular(draws, tally);
        else hit_and_normal(number % kKinds, draws, tally);
    };
}

}  // namespace alidade::numerics
