// SPDX-License-Identifier: Apache-2.0
#include "topology/weld.h"

#include <numeric>
#include <tuple>

namespace alidade::topology {
namespace {

/// For each position the first one at the same point. A position that is not finite stands for itself.
std::vector<uint32_t> first_at_same_point(const Mesh& mesh) {
    std::vector<uint32_t> order, same(mesh.positions.size());
    std::iota(same.begin(), same.end(), 0);
    for (uint32_t i = 0; i < same.size(); ++i)
        if (is_finite(position(mesh, i))) order.push_back(i);
    const auto key = [&](uint32_t i) {
        const Vec3 p = position(mesh, i);
        return std::tuple(p.x, p.y, p.z);
    };
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        const auto ka = key(a), kb = key(b);
        return ka != kb ? ka < kb : a < b;
    });
    for (size_t i = 1; i < order.size(); ++i)
        if (key(order[i]) == key(order[i - 1])) same[order[i]] = same[order[i - 1]];
    return same;
}

}  // namespace

size_t Welded::sound_count() const { return size_t(std::count(sound.begin(), sound.end(), 1)); }

Welded weld(const Mesh& mesh) {
    const std::vector<uint32_t> same = first_at_same_point(mesh);
    Welded out;
    out.triangles.resize(mesh.triangles.size());
    out.sound.resize(mesh.triangles.size());
    std::vector<uint32_t> number(mesh.positions.size(), kNone);
    const auto point = [&](uint32_t at) {
        if (number[at] == kNone) {
            number[at] = uint32_t(out.points.size());
            out.points.push_back(position(mesh, at));
            out.position_of.push_back(at);
        }
        return number[at];
    };
    for (const bool sound : {true, false})
        for (size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Index3& old = mesh.triangles[t];
            const Index3 at(same[old.x], same[old.y], same[old.z]);
            const bool finite = is_finite(position(mesh, at.x)) && is_finite(position(mesh, at.y)) && is_finite(position(mesh, at.z));
            out.sound[t] = finite && at.x != at.y && at.y != at.z && at.z != at.x;
            if (bool(out.sound[t]) == sound) out.triangles[t] = {point(at.x), point(at.y), point(at.z)};
        }
    return out;
}

}  // namespace alidade::topology
