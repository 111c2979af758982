// SPDX-License-Identifier: Apache-2.0
#include "exporters/meshing/triangle_list.h"

#include <algorithm>
#include <unordered_map>

namespace alidade::meshing {

void TriangleList::triangle(const Index3& p, const Index3& n, uint32_t slot) {
    if (p.x == p.y || p.y == p.z || p.z == p.x) return;
    triangles_.push_back(p), slots_.push_back(slot);
    corners_.insert(corners_.end(), {n.x, n.y, n.z});
}

/// The shorter diagonal divides it.
void TriangleList::quad(const std::array<uint32_t, 4>& p, const std::array<uint32_t, 4>& n, uint32_t slot) {
    const size_t first = length(at(p[0]) - at(p[2])) <= length(at(p[1]) - at(p[3])) ? 0 : 1, second = first + 1, third = first + 2, last = (first + 3) % 4;
    triangle({p[first], p[second], p[third]}, {n[first], n[second], n[third]}, slot);
    triangle({p[first], p[third], p[last]}, {n[first], n[third], n[last]}, slot);
}

namespace {

/// Makes what is kept of a list.
class Cutter {
  public:
    Cutter(const TriangleList& from, const std::vector<Vec3f>& normals, const std::function<bool(const Vec3&)>& keep) : from_(from), normals_(normals), keep_(keep) {}

    void add(const Index3& positions, const Index3& normals, uint32_t slot) {
        std::vector<uint32_t> p, n;
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3;
            const bool here = is_kept(positions[i]);
            if (here) p.push_back(moved(positions[i])), n.push_back(out.normal(Vec3(normals_[normals[i]])));
            if (here == is_kept(positions[next])) continue;
            const Rim& rim = rim_between(positions[i], positions[next]);
            const double share = positions[i] < positions[next] ? rim.share : 1 - rim.share;
            p.push_back(rim.position);
            n.push_back(out.normal(normalized((1 - share) * Vec3(normals_[normals[i]]) + share * Vec3(normals_[normals[next]]))));
        }
        if (p.size() == 3) out.triangle({p[0], p[1], p[2]}, {n[0], n[1], n[2]}, slot);
        if (p.size() == 4) out.quad({p[0], p[1], p[2], p[3]}, {n[0], n[1], n[2], n[3]}, slot);
    }

    TriangleList out;

  private:
    struct Rim {
        uint32_t position;
        double share;       ///< of the way from the lower of the two positions
    };

    bool is_kept(uint32_t position) {
        const auto [known, added] = kept_.try_emplace(position, false);
        if (added) known->second = keep_(from_.at(position));
        return known->second;
    }
    uint32_t moved(uint32_t position) {
        const auto [known, added] = moved_.try_emplace(position, 0);
        if (added) known->second = out.position(from_.at(position));
        return known->second;
    }
    const Rim& rim_between(uint32_t a, uint32_t b) {
        if (b < a) std::swap(a, b);
        const auto [known, added] = rims_.try_emplace(uint64_t(a) << 32 | b);
        if (!added) return known->second;
        const bool first = is_kept(a);
        double low = 0, high = 1;
        for (int step = 0; step < 40; ++step) {
            const double middle = (low + high) / 2;
            (keep_(between(a, b, middle)) == first ? low : high) = middle;
        }
        known->second = {out.position(between(a, b, low)), low};
        return known->second;
    }
    Vec3 between(uint32_t a, uint32_t b, double share) const { return from_.at(a) + share * (from_.at(b) - from_.at(a)); }

    const TriangleList& from_;
    const std::vector<Vec3f>& normals_;
    const std::function<bool(const Vec3&)>& keep_;
    std::unordered_map<uint32_t, bool> kept_;
    std::unordered_map<uint32_t, uint32_t> moved_;
    std::unordered_map<uint64_t, Rim> rims_;
};

}  // namespace

TriangleList TriangleList::cut(const std::function<bool(const Vec3&)>& keep) const {
    Cutter cutter(*this, normals_, keep);
    for (size_t t = 0; t < triangles_.size(); ++t)
        cutter.add(triangles_[t], {corners_[3 * t], corners_[3 * t + 1], corners_[3 * t + 2]}, slots_[t]);
    return std::move(cutter.out);
}

Mesh TriangleList::mesh() const {
    constexpr double kFar = 16;   // of its own sizes: from there on floats lose digits that the shape needs
    Bounds box;
    for (const Vec3& p : positions_) box.extend(p);
    Mesh out;
    if (!box.empty() && max_abs(box.center()) > kFar * max_component(box.extent())) out.origin = box.center();
    for (const Vec3& p : positions_) out.positions.emplace_back(p - out.origin);
    out.triangles = triangles_;
    if (std::any_of(slots_.begin(), slots_.end(), [](uint32_t slot) { return slot > 0; })) out.slots = slots_;
    out.normals = {normals_, corners_};
    return out;
}

}  // namespace alidade::meshing
