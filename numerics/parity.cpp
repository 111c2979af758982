// SPDX-License-Identifier: Apache-2.0
/// A line goes into a closed surface as often as it goes out: what solids made of meshes rest on.
///
/// Method   an edge or a corner that is met exactly belongs to several triangles, all of which are hits. Which of them is the crossing is said by the line moved aside by less than any number
///          (simulation of simplicity, Edelsbrunner and Mücke 1990): an edge function that is exactly 0 has the sign of its derivative. The moved line meets no edge, so it crosses a closed surface an even
///          number of times.
#include "accel/triangles/kernel.h"
#include "core/draws.h"
#include "numerics/rows.h"
#include "numerics/triangles/rational.h"
#include "numerics/triangles/rays.h"
#include "numerics/triangles/subjects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace alidade::numerics {

namespace {

/// d.((a - o) x (b - o)), exactly.
Rational edge(const RationalVec& d, const RationalVec& o, const RationalVec& a, const RationalVec& b) { return dot(d, cross(a - o, b - o)); }

/// The sign of the same where double is sure of it, else 0.
int sure_sign(const Vec3& d, const Vec3& o, const Vec3& p, const Vec3& q) {
    const Vec3 a = p - o, b = q - o;
    const double value = dot(d, cross(a, b));
    const Vec3 x = glm::abs(a), y = glm::abs(b);
    const double magnitude = dot(glm::abs(d), Vec3(x.y * y.z + x.z * y.y, x.z * y.x + x.x * y.z, x.x * y.y + x.y * y.x));
    return value > 1e-14 * magnitude ? 1 : value < -1e-14 * magnitude ? -1 : 0;   // gamma_10 is 1.2e-15
}

/// The line through o along d, and where it is moved to.
struct MovedLine {
    Vec3 o, d, aside;

    /// On which side of the edge (p, q) it passes, and whether it meets the edge before it is moved. 0: the edge is parallel to the plane in which it moves.
    struct Side {
        int sign;
        bool met;
    };
    Side side(const Vec3& p, const Vec3& q) const {
        if (const int sign = sure_sign(d, o, p, q)) return {sign, false};
        const RationalVec D = rational(d), O = rational(o), a = rational(p), b = rational(q);
        if (const int sign = sgn(edge(D, O, a, b))) return {sign, false};
        return {sgn(dot(D, cross(b - a, rational(aside)))), true};   // the derivative of the edge function by o
    }
};

/// How the line passes a triangle.
struct Passing {
    bool crosses;   ///< once it is moved
    bool touches;   ///< it meets the closed triangle as it is, not edge-on
};

Passing passing(const MovedLine& line, const TriangleMesh& mesh, size_t triangle) {
    const Vec3& a = mesh.corner(triangle, 0), & b = mesh.corner(triangle, 1), & c = mesh.corner(triangle, 2);
    const MovedLine::Side sides[] = {line.side(a, b), line.side(b, c), line.side(c, a)};
    int most = -1, least = 1, met = 0;
    bool crosses = true;
    for (const auto& side : sides) {
        crosses = crosses && side.sign == sides[0].sign && side.sign != 0;
        if (side.met) ++met;
        else most = std::max(most, side.sign), least = std::min(least, side.sign);
    }
    return {crosses, met < 3 && most == least};
}

Compared solid(uint64_t block) {
    static const std::vector<TriangleMesh> meshes = [] {
        std::vector<TriangleMesh> closed;
        for (const TriangleMesh& mesh : small_meshes())
            if (is_closed(mesh)) closed.push_back(mesh);
        return closed;
    }();
    Draws draws(RandomKey(4, 1, block));
    return {precision_of(block / meshes.size() % 2 == 1), scaled(meshes[block % meshes.size()], std::pow(10, draws.uniform(-6, 6)))};
}

/// Each triangle at most once, all that the moved line crosses, and none that the line does not touch.
bool is_right(const std::vector<Hit>& hits, const std::vector<Passing>& want) {
    std::vector<bool> hit(want.size());
    for (const Hit& h : hits) {
        if (h.primitive >= want.size() || hit[h.primitive] || !want[h.primitive].touches) return false;
        hit[h.primitive] = true;
    }
    for (size_t i = 0; i < want.size(); ++i)
        if (want[i].touches != hit[i]) return false;
    return true;
}

/// The ray's whole line: at an edge or a corner, along a plane of the mesh, or at anything.
Ray whole_line(const TriangleMesh& mesh, const RandomKey& key) {
    constexpr std::array kClasses{"random", "lattice", "axis-parallel, others 0 or -0", "edge-aimed", "vertex-aimed", "edge-aimed", "vertex-aimed"};
    const std::string_view name = kClasses[key.child(2).bits(0) % kClasses.size()];
    Ray ray;
    for (const RayClass& rays : ray_classes())
        if (name == rays.name) ray = rays.make(mesh, key);
    Draws draws(key.child(4));
    if (draws.below(4) == 0) ray.origin -= draws.uniform(100, 1000) * max_component(mesh.bounds().extent()) * normalized(ray.dir);   // from so far it is moved to the mesh
    ray.tmin = -kInf;
    return ray;
}

}  // namespace

Check parity() {
    return [kept = std::make_shared<Shared<Compared>>()](uint64_t number, NumericsTally& tally) {
        constexpr uint64_t kBlock = 512;   // lines through the same mesh
        const Compared& s = kept->at(number / kBlock, solid);
        const RandomKey key(4, 0, number);
        const Ray ray = whole_line(s.mesh, key);
        const LocalRay local = local_ray(ray, s.structures.front().accelerator->bounds(), TriangleKernel<float, TriangleTest::exact>::kEntry);
        Draws draws(key.child(3));
        const MovedLine line{local.origin, local.dir, draws.direction()};
        std::vector<Passing> want;
        for (size_t i = 0; i < s.mesh.triangles.size(); ++i) want.push_back(passing(line, s.mesh, i));
        const auto crossed = std::count_if(want.begin(), want.end(), [](const Passing& p) { return p.crosses; });
        for (const Built& built : s.structures) {
            const std::vector<Hit> hits = all_hits(*built.accelerator, ray);
            tally.decide(crossed % 2 == 0 && is_right(hits, want), [&] { return fmt::format("{}: {} hits, {} crossings once it is moved aside", built.text(ray), hits.size(), crossed); });
        }
    };
}

}  // namespace alidade::numerics
