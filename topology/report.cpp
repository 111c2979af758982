// SPDX-License-Identifier: Apache-2.0
#include "topology/report.h"

#include "topology/edges.h"
#include "topology/half_edges.h"

namespace alidade::topology {
namespace {

class Examination {
  public:
    explicit Examination(const Welded& surface)
        : surface_(surface), edges_(surface), fans_(fans(surface, edges_, [](const Side&, const Side&) { return true; })) {}

    SurfaceReport run() {
        report_.triangles = surface_.triangles.size();
        report_.degenerate = report_.triangles - surface_.sound_count();
        report_.edges = edges_.count();
        count_edges();
        count_vertices();
        count_holes();
        count_components();
        count_without_area();
        report_.refused = half_edges(surface_).refused.size();
        return report_;
    }

  private:
    /// Calls body(corner, its vertex) for each corner of a sound triangle.
    template <class Body> void for_each_corner(Body body) const {
        for (uint32_t t = 0; t < surface_.triangles.size(); ++t)
            for (uint32_t k = 0; surface_.sound[t] && k < 3; ++k) body(3 * t + k, surface_.triangles[t][int(k)]);
    }

    void count_edges() {
        for (size_t e = 0; e < edges_.count(); ++e) {
            const auto sides = edges_.sides(e);
            report_.non_manifold_edges += sides.size() > 2;
            report_.inconsistent_edges += sides.size() == 2 && sides[0].from == sides[1].from;
            if (sides.size() == 1) {
                ++report_.hole_edges;
                report_.hole_length += length(surface_.points[sides[0].to] - surface_.points[sides[0].from]);
            } else {
                count_duplicates(sides);
            }
        }
    }

    /// A triangle is counted at the edge between its two lowest vertices: there its copies have the same third one.
    void count_duplicates(std::span<const Side> sides) {
        apexes_.clear();
        for (const Side& side : sides) {
            const uint32_t before = previous_corner(side.corner), apex = surface_.triangles[before / 3][int(before % 3)];
            if (apex > std::max(side.from, side.to)) apexes_.push_back(apex);
        }
        std::sort(apexes_.begin(), apexes_.end());
        report_.duplicates += size_t(apexes_.end() - std::unique(apexes_.begin(), apexes_.end()));
    }

    /// A vertex is manifold if what lies around it is one fan, with no edge too full.
    void count_vertices() {
        std::vector<uint32_t> fans_at(surface_.points.size(), 0);
        for_each_corner([&](uint32_t corner, uint32_t vertex) { fans_at[vertex] += fans_.find(corner) == corner; });
        for (const uint32_t n : fans_at) report_.vertices += n > 0;
        for (size_t e = 0; e < edges_.count(); ++e)
            if (const auto sides = edges_.sides(e); sides.size() > 2) fans_at[sides[0].from] = fans_at[sides[0].to] = 2;
        for (const uint32_t n : fans_at) report_.non_manifold_vertices += n > 1;
    }

    /// A fan that is not closed has two ends; hole edges at both ends of a fan follow each other along the same hole.
    void count_holes() {
        std::vector<uint32_t> edge_at(3 * surface_.triangles.size(), kNone);   // by fan: the number of a hole edge at its end
        std::vector<Side> hole_sides;
        for (size_t e = 0; e < edges_.count(); ++e)
            if (edges_.sides(e).size() == 1) hole_sides.push_back(edges_.sides(e)[0]);
        Sets holes(hole_sides.size());
        for (uint32_t i = 0; i < hole_sides.size(); ++i)
            for (const uint32_t corner : {hole_sides[i].corner, next_corner(hole_sides[i].corner)}) {
                uint32_t& other = edge_at[fans_.find(corner)];
                if (other == kNone) other = i;
                else holes.unite(i, other);
            }
        for (uint32_t i = 0; i < hole_sides.size(); ++i) report_.holes += holes.find(i) == i;
    }

    void count_components() {
        Sets pieces(surface_.points.size());
        std::vector<uint8_t> used(surface_.points.size(), 0);
        for_each_corner([&](uint32_t corner, uint32_t vertex) {
            used[vertex] = 1;
            pieces.unite(vertex, surface_.triangles[corner / 3].x);
        });
        for (uint32_t v = 0; v < used.size(); ++v) report_.components += used[v] && pieces.find(v) == v;
    }

    void count_without_area() {
        for (size_t t = 0; t < surface_.triangles.size(); ++t) {
            if (!surface_.sound[t]) continue;
            const Index3& v = surface_.triangles[t];
            const Vec3 &a = surface_.points[v.x], &b = surface_.points[v.y], &c = surface_.points[v.z];
            report_.without_area += cross(normalized(b - a), normalized(c - a)) == Vec3(0);
        }
    }

    const Welded& surface_;
    Edges edges_;
    Sets fans_;
    SurfaceReport report_;
    std::vector<uint32_t> apexes_;
};

}  // namespace

std::optional<int64_t> SurfaceReport::genus() const {
    if (!closed() || non_manifold_vertices || inconsistent_edges || duplicates) return std::nullopt;
    return int64_t(components) - euler() / 2;   // euler = 2 components - 2 genus
}

SurfaceReport examine(const Mesh& mesh) {
    const Welded surface = weld(mesh);
    return Examination(surface).run();
}

}  // namespace alidade::topology
