// SPDX-License-Identifier: Apache-2.0
#include "numerics/triangles/compare.h"

#include <fmt/format.h>

#include <bit>

namespace alidade::numerics {
namespace {

bool same_bits(const Hit& a, const Hit& b) {
    const auto bits = [](const Hit& hit) {
        return std::tuple(std::bit_cast<uint64_t>(hit.t), hit.instance, hit.primitive, hit.part, std::bit_cast<uint32_t>(hit.u),
                          std::bit_cast<uint32_t>(hit.v), std::bit_cast<uint64_t>(hit.error.along_normal));
    };
    return bits(a) == bits(b);
}

}  // namespace

std::string describe(const Hit& hit) {
    if (!hit.valid()) return "no hit";
    return fmt::format("t {:a} instance {} primitive {} part {} u {:a} v {:a} error {:a}", hit.t, hit.instance, hit.primitive, hit.part, hit.u, hit.v,
                       hit.error.along_normal);
}

std::string difference(const Hit& got, const Hit& want) {
    return same_bits(got, want) ? "" : fmt::format("got  {}\nwant {}\n", describe(got), describe(want));
}

std::string difference(const std::vector<Hit>& got, const std::vector<Hit>& want) {
    std::string text;
    if (got.size() != want.size()) text = fmt::format("got {} hits, want {}\n", got.size(), want.size());
    for (size_t i = 0; i < std::min(got.size(), want.size()); ++i) {
        const std::string one = difference(got[i], want[i]);
        if (!one.empty()) return text + fmt::format("hit {} of all:\n{}", i, one);
    }
    return text;
}

Hit first_hit(const Accelerator& accelerator, const Ray& ray) {
    WorkCounters work;
    Hit hit;
    accelerator.intersect(ray, hit, work);
    return hit;
}

std::vector<Hit> all_hits(const Accelerator& accelerator, const Ray& ray) {
    WorkCounters work;
    std::vector<Hit> hits;
    accelerator.all_hits(ray, hits, work);
    return hits;
}

bool is_occluded(const Accelerator& accelerator, const Ray& ray) {
    WorkCounters work;
    return accelerator.occluded(ray, work);
}

Answers answers(const Accelerator& accelerator, const Ray& ray) {
    return {first_hit(accelerator, ray), is_occluded(accelerator, ray), all_hits(accelerator, ray)};
}

std::string difference(const Answers& got, const Answers& want) {
    std::string text = difference(got.first, want.first);
    if (got.occluded != want.occluded) text += fmt::format("occluded: got {}, want {}\n", got.occluded, want.occluded);
    return text + difference(got.all, want.all);
}

const char* name(Precision precision) { return precision == Precision::float_ ? "float" : "double"; }

std::vector<const AcceleratorEntry*> accelerators_under_test() {
    std::vector<const AcceleratorEntry*> rows;
    for (const AcceleratorEntry& entry : accelerators().subspan(1)) rows.push_back(&entry);
    return rows;
}

std::unique_ptr<Accelerator> brute_force(const TriangleMesh& mesh, Precision precision) {
    AccelOptions options;
    options.precision = precision;
    return build(accelerators().front(), mesh, options);
}

std::unique_ptr<Accelerator> build(const AcceleratorEntry& entry, const TriangleMesh& mesh, const AccelOptions& options) {
    return entry.over_triangles(mesh.view(), options);
}

}  // namespace alidade::numerics
