// SPDX-License-Identifier: Apache-2.0
/// Light never leaks out of a closed surface: a ray from inside, at an edge, a vertex or anything, hits.
#include "core/draws.h"
#include "numerics/rows.h"
#include "numerics/triangles/rays.h"
#include "numerics/triangles/subjects.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace alidade::numerics {

namespace {

constexpr uint64_t kBlock = 256;   // rays one after the other for the same subject and mesh

/// Of ten and as many as there are others, ten blocks are for what renders take: the goal is stated for ten times as many rays there.
const Subject& subject_of(uint64_t block) {
    static const std::vector<const Subject*> turns = [] {
        std::vector<const Subject*> list;
        for (const Subject& subject : subjects()) list.insert(list.end(), subject.usual ? 10 : 1, &subject);
        return list;
    }();
    return *turns[block % turns.size()];
}

void check(const Built& built, const Ray& ray, NumericsTally& tally) {
    tally.decide(first_hit(*built.accelerator, ray).valid(), [&] { return built.text(ray); });
}

using Aim = Ray (*)(const Mesh&, const RandomKey&);

/// Structures over the meshes that are always the same are kept, all of them.
Check leak(Aim aim, uint64_t row) {
    std::vector<std::shared_ptr<Built>> kept(subjects().size() * closed_meshes().size());
    return [aim, row, kept](uint64_t number, NumericsTally& tally) mutable {
        const uint64_t block = number / kBlock;
        const Subject& subject = subject_of(block);
        const size_t mesh = RandomKey(row, 1, block).bits(0) % closed_meshes().size();
        auto& built = kept[size_t(&subject - subjects().data()) * closed_meshes().size() + mesh];
        if (!built) built = std::make_shared<Built>(subject, closed_meshes()[mesh]);
        check(*built, aim(built->mesh, RandomKey(row, 0, number)), tally);
    };
}

/// Of any size, flat, a needle, a blade or far from the origin.
Mesh any_closed_mesh(Draws& draws) {
    const uint32_t form = draws.below(3), shape = draws.below(5);
    const Mesh mesh = form == 0 ? geodesic_sphere(5) : form == 1 ? cube(6) : torus(20, 12);
    const double size = std::pow(10, draws.uniform(-15, 15)), extreme = std::pow(10, draws.uniform(0, 1));
    const std::string name = fmt::format("{} * {}, ", mesh.name, size);
    if (shape == 0) return moved(mesh, Vec3(size), Vec3(0), name + "as it is");
    if (shape == 1) return moved(mesh, size * Vec3(1, 1, 1e-6 * extreme), Vec3(0), name + "flat");
    if (shape == 2) return moved(mesh, size * Vec3(1e3 * extreme, 1, 1), Vec3(0), name + "a needle");
    if (shape == 3 && form != 2) return scaled(turned(moved(mesh, Vec3(1e2, 1, 1e-2), Vec3(0), ""), name + "a blade askew"), size);
    return moved(mesh, Vec3(size), draws.direction() * (size * std::pow(10, draws.uniform(0, form == 2 ? 4 : 6))), name + "far from the origin");
}

Built of_any_size(uint64_t block) {
    Draws draws(RandomKey(3, 1, block));
    return {subjects()[block % subjects().size()], any_closed_mesh(draws)};
}

}  // namespace

Check leak_edge() { return leak(edge_aimed_from_inside, 1); }
Check leak_vertex() { return leak(vertex_aimed_from_inside, 2); }

Check leak_scale() {
    return [kept = std::make_shared<Shared<Built>>()](uint64_t number, NumericsTally& tally) {
        const Built& built = kept->at(number / kBlock, of_any_size);
        check(built, (number % 2 ? edge_aimed_from_inside : vertex_aimed_from_inside)(built.mesh, RandomKey(3, 0, number)), tally);
    };
}

}  // namespace alidade::numerics
