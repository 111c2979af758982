// SPDX-License-Identifier: Apache-2.0
/// Light never leaks out of a closed surface: a ray from inside, at an edge, a vertex or anything, hits.
#include "core/draws.h"
#include "numerics/rows.h"
#include "numerics/triangles/rays.h"
#include "numerics/triangles/subjects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace alidade::numerics {

namespace {

constexpr uint64_t kBlock = 4096;   // rays one after the other for the same subject and mesh: so many that its memory is read once for all of them

/// Numbers of subjects: 100 times the usual structure, with each test of triangles, 10 times each of the others with the test that is asked about, and once with the robust one beside it.
/// The goal is stated for ten times as many rays of the usual structure as of others.
std::vector<size_t> turns() {
    std::vector<std::pair<double, size_t>> places;   // those of each subject are spread evenly: a short run asks all
    for (size_t i = 0; i < watertight_subjects().size(); ++i) {
        const Subject& subject = watertight_subjects()[i];
        const int count = subject.usual ? 100 : subject.intersect == asked().intersect ? 10 : 1;
        for (int k = 0; k < count; ++k) places.emplace_back((k + double(i + 1) / double(watertight_subjects().size() + 1)) / count, i);
    }
    std::sort(places.begin(), places.end());
    std::vector<size_t> list;
    for (const auto& [place, subject] : places) list.push_back(subject);
    return list;
}

/// Every eighth ray is asked as one of a shadow, too: structures have a search of their own for those.
void check(const Built& built, const Ray& ray, uint64_t number, NumericsTally& tally) {
    WorkCounters work;
    bool hits = first_hit(*built.accelerator, ray).valid();
    if (number / 2 % 8 == 0) hits = hits && built.accelerator->occluded(ray, work);
    tally.decide(hits, [&] { return built.text(ray); });
}

using Aim = Ray (*)(const TriangleMesh&, const RandomKey&);

/// Structures over the meshes that are always the same are kept, all of them.
Check leak(Aim aim, uint64_t row) {
    std::vector<std::shared_ptr<Built>> kept(watertight_subjects().size() * closed_meshes().size());
    return [aim, row, kept, turns = turns()](uint64_t number, NumericsTally& tally) mutable {
        const uint64_t block = number / kBlock;
        const size_t subject = turns[block % turns.size()];
        const size_t mesh = RandomKey(row, 1, block).bits(0) % closed_meshes().size();
        auto& built = kept[subject * closed_meshes().size() + mesh];
        if (!built) built = std::make_shared<Built>(watertight_subjects()[subject], closed_meshes()[mesh]);
        check(*built, aim(built->mesh, RandomKey(row, 0, number)), number, tally);
    };
}

/// Of any size, flat, a needle, a blade or far from the origin.
struct AnyClosed {
    TriangleMesh mesh;
    double size, offset = 0;   ///< in sizes
};

AnyClosed any_closed_mesh(Draws& draws) {
    const uint32_t form = draws.below(3), shape = draws.below(5);
    const TriangleMesh mesh = form == 0 ? geodesic_sphere(5) : form == 1 ? cube(6) : torus(20, 12);
    const double size = std::pow(10, draws.uniform(-15, 15)), extreme = std::pow(10, draws.uniform(0, 1));
    const std::string name = fmt::format("{} * {}, ", mesh.name, size);
    if (shape == 0) return {moved(mesh, Vec3(size), Vec3(0), name + "as it is"), size};
    if (shape == 1) return {moved(mesh, size * Vec3(1, 1, 1e-6 * extreme), Vec3(0), name + "flat"), size};
    if (shape == 2) return {moved(mesh, size * Vec3(1e3 * extreme, 1, 1), Vec3(0), name + "a needle"), size};
    if (shape == 3 && form != 2) return {scaled(turned(moved(mesh, Vec3(1e2, 1, 1e-2), Vec3(0), ""), name + "a blade askew"), size), size};
    const Vec3 direction = draws.direction();
    const double offset = std::pow(10, draws.uniform(0, form == 2 ? 4 : 6));
    return {moved(mesh, Vec3(size), direction * (size * offset), name + "far from the origin"), size, offset};
}

struct OfAnySize {
    Built built;
    double size, offset;
};

OfAnySize of_any_size(uint64_t block) {
    Draws draws(RandomKey(3, 1, block));
    const AnyClosed any = any_closed_mesh(draws);
    return {Built(watertight_subjects()[block % watertight_subjects().size()], any.mesh), any.size, any.offset};
}

}  // namespace

Check leak_edge() { return leak(edge_aimed_from_inside, 1); }
Check leak_vertex() { return leak(vertex_aimed_from_inside, 2); }

Check leak_scale() {
    return [kept = std::make_shared<Shared<OfAnySize>>()](uint64_t number, NumericsTally& tally) {
        const auto& [built, size, offset] = kept->at(number / kBlock, of_any_size);
        tally.at(NumericsScale::size, size), tally.at(NumericsScale::offset, offset);
        check(built, (number % 2 ? edge_aimed_from_inside : vertex_aimed_from_inside)(built.mesh, RandomKey(3, 0, number)), number, tally);
    };
}

}  // namespace alidade::numerics
