// SPDX-License-Identifier: Apache-2.0
/// All accelerators answer as brute force does, bit for bit; and on a lattice, where the answer is known without any.
#include "core/clamp.h"
#include "core/draws.h"
#include "numerics/rows.h"
#include "numerics/toy_scenes.h"
#include "numerics/triangles/rays.h"
#include "numerics/triangles/subjects.h"
#include "tracer/compiled_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace alidade::numerics {

namespace {

Compared compared(uint64_t block) {
    static const std::vector<TriangleMesh> meshes = [] {
        std::vector<TriangleMesh> list = small_meshes();
        list.push_back(geodesic_sphere(10, 0.2)), list.push_back(soup(1500, 0.1, 8));
        return list;
    }();
    Draws draws(RandomKey(15, 1, block));
    const TriangleMesh& mesh = meshes[draws.below(meshes.size())];
    const double scale = draws.below(4) == 0 ? 1 : std::pow(10, draws.uniform(-6, 6));   // a wrong epsilon shows only away from 1
    return {precision_of(draws.coin()), scaled(mesh, scale)};
}

/// Said without the order that all structures share.
std::tuple<double, uint32_t, uint32_t> order(const Hit& hit) { return {hit.t, hit.instance, hit.primitive}; }

/// The nearest of all hits, and of those the one with the lowest id.
Hit least(const Answers& a) {
    return a.all.empty() ? Hit() : *std::min_element(a.all.begin(), a.all.end(), [](const Hit& x, const Hit& y) { return order(x) < order(y); });
}

/// `brought(hit)`: was it the box of an instance that said t? Hits of one instance that are brought to one t so are in the order that they have in its own space, which t does not show.
template <class Brought> bool is_first(const Answers& a, const Brought& brought) {
    if (a.all.empty()) return !a.first.valid() && !a.occluded;
    const Hit nearest = least(a);
    const bool is_hit = std::any_of(a.all.begin(), a.all.end(), [&](const Hit& hit) { return order(hit) == order(a.first); });
    const bool is_least = order(nearest) == order(a.first) || (nearest.t == a.first.t && nearest.instance == a.first.instance && brought(nearest));
    return a.occluded && is_hit && is_least && std::isfinite(a.first.t);
}

/// Instances of boxes, spheres and meshes, or of every kind of shape, on a lattice, faces and whole shapes at one place: most hits are ties. Compiled with each accelerator, with brute force last.
struct Instances {
    TriangleMesh around = cube(2);   ///< what rays are made for
    std::vector<std::shared_ptr<const CompiledScene>> scenes;

    bool is_at_end(const Hit& hit, const Ray& ray) const {
        const LineInterval inside = inside_bounds(ray, scenes.back()->instances[hit.instance].bounds);
        return hit.t == inside.entry || hit.t == inside.exit;
    }
    std::string text(size_t i, const Ray& ray) const { return fmt::format("instances, {}, {}", i + 1 < scenes.size() ? accelerators()[i + 1].name : accelerators()[0].name, describe(ray)); }
};

Instances instances(uint64_t block) {
    Draws draws(RandomKey(15, 2, block));
    alidade::Mesh mesh;
    const TriangleMesh unit = cube(1);
    mesh.positions = unit.positions, mesh.triangles = unit.triangles;
    const double scale = draws.coin() ? 1 : std::pow(10, draws.uniform(-6, 6));
    std::vector<ShapeGeometry> kinds{Box{}, Sphere{}, mesh};
    if (block / 16 % 2 == 1)
        for (size_t row = 0; row < shapes().size(); ++row) kinds.push_back(toy_shape(row));
    std::vector<PlacedToy> placed;
    for (int i = 0; i < 60; ++i) {
        const double x = draws.below(4), y = draws.below(4), z = draws.below(4);
        placed.push_back({kinds[draws.below(kinds.size())], Transform::scale(Vec3(scale)) * Transform::translate(0.5 * Vec3(x, y, z) - Vec3(0.75)) * Transform::scale(Vec3(0.25))});
    }
    Instances made;
    made.around = scaled(made.around, scale);
    const auto add = [&](const AcceleratorEntry& entry) {
        CompileOptions options;
        options.accel = entry.name, options.threads = 1;
        options.precision = precision_of(block / 8 % 2 == 0), options.intersect = asked().intersect;
        Diagnostics said;
        made.scenes.push_back(compile(toy_shapes(placed), options, said));
    };
    for (const AcceleratorEntry* entry : accelerators_under_test()) add(*entry);
    add(accelerators().front());
    return made;
}

/// A mesh all of whose hits along an axis lie in known planes.
struct Lattice {
    TriangleMesh mesh;               ///< corners at integers, on the planes of these cells
    std::array<int, 3> cells;
    bool walls;              ///< between all cells, or around them alone
};

const std::vector<Lattice>& lattices() {
    static const std::vector<Lattice> all{
        {moved(cube(8), Vec3(4), Vec3(4), "lattice of a cube"), {8, 8, 8}, false},
        {cube_lattice(2, 3, 4), {2, 3, 4}, true},
        {cube_lattice(5, 5, 1), {5, 5, 1}, true}};
    return all;
}

/// Size and place, both exact in float.
struct Placement {
    double size;
    Vec3 offset;
    TriangleMesh of(const TriangleMesh& mesh) const { return moved(mesh, Vec3(size), offset, fmt::format("{} * {:a} + {}", mesh.name, size, offset.x / size)); }
};

struct PlacedMeshes {
    const Lattice* lattice;
    Placement placement;
    std::vector<Built> structures;
};

PlacedMeshes placed_meshes(uint64_t block) {
    Draws draws(RandomKey(16, 1, block));
    const Lattice& lattice = lattices()[block % lattices().size()];
    Placement placement{std::exp2(int(draws.below(81)) - 40), Vec3(0)};
    if (draws.coin()) placement.offset = placement.size * Vec3(draws.below(1u << 20), -double(draws.below(1u << 20)), 1000);
    const Precision precision = precision_of(block / lattices().size() % 2 == 1);
    PlacedMeshes placed{&lattice, placement, built(precision, placement.of(lattice.mesh))};
    placed.structures.emplace_back(Subject{&accelerators().front(), precision, false}, placement.of(lattice.mesh));
    return placed;
}

/// A line along an axis, in units of cells.
struct AxisLine {
    int axis = 0;
    double sign = 1;
    Vec3 at{0};             ///< on lattice planes, halves between them, or anywhere, never outside
    double minor = 0;       ///< of the direction's two other components

    /// Where the planes are hit, counted from the origin in the ray's own lengths.
    std::vector<double> hits(const Lattice& lattice) const {
        std::vector<double> t;
        for (int plane = 0; plane <= lattice.cells[axis]; ++plane) {
            const bool is_wall = lattice.walls || plane == 0 || plane == lattice.cells[axis];
            if (is_wall && sign * (plane - at[axis]) >= 0) t.push_back(sign * (plane - at[axis]));
        }
        std::sort(t.begin(), t.end());
        return t;
    }
};

AxisLine axis_line(const Lattice& lattice, Draws& draws) {
    AxisLine line;
    line.axis = int(draws.below(3)), line.sign = draws.sign();
    for (int k = 0; k < 3; ++k) {
        const int cells = lattice.cells[k];
        line.at[k] = draws.below(4) == 0 ? 0.5 + draws.below(size_t(cells)) : draws.below(size_t(cells) + 1);
    }
    if (draws.coin()) line.at[line.axis] += -line.sign * (1 + draws.below(64));   // from outside, or from further inside
    line.minor = std::array{0.0, 4.9e-324, 1e-310, 1e-200}[draws.below(4)];      // the largest too is far below what the hits can show
    return line;
}

Ray ray_of(const AxisLine& line, const Placement& p, Draws& draws) {
    Ray ray;
    ray.origin = p.size * line.at + p.offset;
    for (int k = 0; k < 3; ++k) ray.dir[k] = draws.coin() ? line.minor : -line.minor;
    ray.dir[line.axis] = line.sign * p.size;
    return ray;
}

/// Every plane is met, nothing else is, and the nearest is first. t carries the roundings of the origin that is moved to the bounds: units of |origin| + |t|.
void check_planes(const Answers& got, const std::vector<double>& want, double origin, NumericsTally& tally, const auto& what) {
    std::vector<bool> met(want.size());
    for (const Hit& hit : got.all) {
        double error = kInf;
        for (size_t i = 0; i < want.size(); ++i) {
            const double off = std::abs(hit.t - want[i]) / (kUnitRoundoff<double> * (origin + want[i]));
            if (hit.t == want[i] || off < 1e3) met[i] = true;
            error = std::min(error, hit.t == want[i] ? 0 : off);
        }
        tally.measure(error, 3, what);
    }
    tally.decide(std::find(met.begin(), met.end(), false) == met.end(), what);
    tally.decide(got.occluded == !want.empty() && is_first(got, [](const Hit&) { return false; }), what);
}

}  // namespace

Check accel_equal() {
    constexpr uint64_t kBlock = 2048;   // rays at the same mesh; each eighth block has instances
    return [meshes = std::make_shared<Shared<Compared>>(), placed = std::make_shared<Shared<Instances>>()](uint64_t number, NumericsTally& tally) {
        const RayClass& rays = ray_classes()[number % ray_classes().size()];
        const RandomKey key(15, 0, number);
        const auto compare = [&](size_t count, const Ray& ray, const auto& accelerator, const auto& text, const auto& brought) {
            const Answers want = answers(accelerator(count - 1), ray);
            tally.decide(is_first(want, brought), [&] { return fmt::format("{}: the first hit is {}, the first of all {}", text(count - 1), describe(want.first), describe(least(want))); });
            for (size_t i = 0; i + 1 < count; ++i) {
                const std::string what = difference(answers(accelerator(i), ray), want);
                tally.decide(what.empty(), [&] { return fmt::format("{}, {}\n{}", rays.name, text(i), what); });
            }
        };
        if (number / kBlock % 8 == 7) {
            const Instances& c = placed->at(number / kBlock, instances);
            const Ray ray = rays.make(c.around, key);
            compare(c.scenes.size(), ray, [&](size_t i) -> const Accelerator& { return *c.scenes[i]->top; }, [&](size_t i) { return c.text(i, ray); }, [&](const Hit& hit) { return c.is_at_end(hit, ray); });
        } else {
            const Compared& c = meshes->at(number / kBlock, compared);
            const Ray ray = rays.make(c.mesh, key);
            compare(c.structures.size(), ray, [&](size_t i) -> const Accelerator& { return *c.structures[i].accelerator; }, [&](size_t i) { return c.structures[i].text(ray); }, [](const Hit&) { return false; });
        }
    };
}

Check axis_parallel() {
    return [kept = std::make_shared<Shared<PlacedMeshes>>()](uint64_t number, NumericsTally& tally) {
        constexpr uint64_t kBlock = 512;
        const PlacedMeshes& p = kept->at(number / kBlock, placed_meshes);
        Draws draws(RandomKey(16, 0, number));
        const AxisLine line = axis_line(*p.lattice, draws);
        const Ray ray = ray_of(line, p.placement, draws);
        const std::vector<double> want = line.hits(*p.lattice);
        for (const Built& built : p.structures) {
            const Answers got = answers(*built.accelerator, ray);
            check_planes(got, want, max_abs(ray.origin) / p.placement.size, tally, [&] {
                return fmt::format("{}: {} hits, first at {}, want {} planes, first at {}", built.text(ray), got.all.size(), got.first.t, want.size(), want.empty() ? kInf : want.front());
            });
        }
    };
}

}  // namespace alidade::numerics
