// SPDX-License-Identifier: Apache-2.0
#include "eval/tangents.h"

#include <array>
#include <cstring>
#include <numeric>
#include <span>
#include <tuple>

namespace alidade {

namespace {

constexpr uint32_t kNone = ~uint32_t(0);

/// Position, normal and texture coordinates, as bits that are equal where the numbers are.
using CornerKey = std::array<uint32_t, 8>;

uint32_t bits(float x) {
    x += 0.0f;   // -0 becomes 0
    uint32_t out;
    std::memcpy(&out, &x, sizeof out);
    return out;
}

/// Which corners belong together, as a forest.
class Groups {
  public:
    explicit Groups(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    /// The representative of i's group: its least member.
    uint32_t find(uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(uint32_t a, uint32_t b) {
        a = find(a), b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<uint32_t> parent_;
};

/// A triangle's side between two welded vertices, a < b; the corners of the triangle that are there.
struct Side {
    uint32_t a = 0, b = 0, corner_a = 0, corner_b = 0;
    bool forward = false;   ///< the triangle goes from a to b
};

/// How a triangle lies in the texture. `flat` has no area there: it goes with any neighbour.
enum Turn : uint8_t { unmirrored, mirrored, flat };

class TangentMaker {
  public:
    TangentMaker(const Mesh& mesh, uint32_t uv_set)
        : mesh_(mesh), uvs_(mesh.uvs[uv_set]), corners_(uint32_t(3 * mesh.triangles.size())), groups_(corners_) {}

    Attribute<Vec4f> make() {
        examine_triangles();
        weld();
        join_neighbours();
        lend_to_degenerate();
        return average();
    }

  private:
    uint32_t vertex(uint32_t corner) const { return mesh_.triangles[corner / 3][int(corner % 3)]; }
    uint32_t other(uint32_t corner, uint32_t by) const { return corner / 3 * 3 + (corner % 3 + by) % 3; }
    Vec3 position(uint32_t corner) const {
        const uint32_t v = vertex(corner);
        return mesh_.exact_positions.empty() ? Vec3(mesh_.positions[v]) : mesh_.exact_positions[v];
    }
    Vec2f uv(uint32_t corner) const { return uvs_.values[uvs_.index(corner / 3, int(corner % 3), mesh_.triangles[corner / 3])]; }
    Vec3f normal(uint32_t corner) const {
        if (!mesh_.normals.present()) return face_normals_[corner / 3];
        return mesh_.normals.values[mesh_.normals.index(corner / 3, int(corner % 3), mesh_.triangles[corner / 3])];
    }

    /// Of each triangle: the direction of u, how it is turned, and whether it is one at all.
    void examine_triangles() {
        for (uint32_t c = 0; c < corners_; c += 3) {
            const Vec3 p = position(c), e1 = position(c + 1) - p, e2 = position(c + 2) - p;
            const Vec2 t = Vec2(uv(c)), d1 = Vec2(uv(c + 1)) - t, d2 = Vec2(uv(c + 2)) - t;
            const double area = d1.x * d2.y - d2.x * d1.y;
            along_u_.push_back(normalized(e1 * d2.y - e2 * d1.y) * (area < 0 ? -1.0 : 1.0));
            turns_.push_back(area < 0 ? unmirrored : area > 0 ? mirrored : flat);   // v grows downwards: a map that is not mirrored has a negative area
            degenerate_.push_back(e1 == Vec3(0) || e2 == Vec3(0) || e1 == e2);
            if (!mesh_.normals.present()) face_normals_.emplace_back(normalized(cross(normalized(e1), normalized(e2))));
        }
    }

    CornerKey key(uint32_t corner) const {
        const Vec3f p(position(corner)), n = normal(corner);
        const Vec2f t = uv(corner);
        return {bits(p.x), bits(p.y), bits(p.z), bits(n.x), bits(n.y), bits(n.z), bits(t.x), bits(t.y)};
    }

    /// Corners with equal keys are one welded vertex.
    void weld() {
        std::vector<std::pair<CornerKey, uint32_t>> sorted;
        sorted.reserve(corners_);
        for (uint32_t c = 0; c < corners_; ++c) sorted.emplace_back(key(c), c);
        std::sort(sorted.begin(), sorted.end());
        welded_.resize(corners_);
        for (size_t i = 0; i < sorted.size(); ++i)
            welded_[sorted[i].second] = i > 0 && sorted[i].first == sorted[i - 1].first ? welded_[sorted[i - 1].second] : sorted[i].second;
    }

    std::vector<Side> sides() const {
        std::vector<Side> out;
        out.reserve(corners_);
        for (uint32_t c = 0; c < corners_; ++c) {
            if (degenerate_[c / 3]) continue;
            const uint32_t next = other(c, 1);
            if (welded_[c] < welded_[next]) out.push_back({welded_[c], welded_[next], c, next, true});
            else out.push_back({welded_[next], welded_[c], next, c, false});
        }
        std::sort(out.begin(), out.end(), [](const Side& x, const Side& y) { return std::tie(x.a, x.b, x.corner_a) < std::tie(y.a, y.b, y.corner_a); });
        return out;
    }

    /// Triangles that meet in an edge, go along it in opposite directions and are turned alike share their tangents at its ends.
    void join_neighbours() {
        const std::vector<Side> all = sides();
        std::vector<std::pair<uint32_t, uint32_t>> flat_beside;   // a corner of a flat triangle, a corner beside it that has a turn
        for (size_t first = 0, end = 0; first < all.size(); first = end) {
            while (end < all.size() && all[end].a == all[first].a && all[end].b == all[first].b) ++end;
            join_at_edge({all.data() + first, end - first}, flat_beside);
        }
        join_flat(flat_beside);
    }

    void join_at_edge(std::span<const Side> edge, std::vector<std::pair<uint32_t, uint32_t>>& flat_beside) {
        const Side* some[3][2] = {};   // by turn and direction
        for (const Side& s : edge)
            if (auto& at = some[turns_[s.corner_a / 3]][s.forward]; !at) at = &s;
        for (const Side& s : edge) {
            const Turn turn = turns_[s.corner_a / 3];
            if (const Side* opposite = some[turn][!s.forward]) {
                groups_.join(s.corner_a, opposite->corner_a);
                groups_.join(s.corner_b, opposite->corner_b);
            }
            if (turn != flat) continue;
            for (const Turn of : {unmirrored, mirrored}) {
                const Side* beside = some[of][!s.forward];
                if (!beside) continue;
                flat_beside.emplace_back(s.corner_a, beside->corner_a);
                flat_beside.emplace_back(s.corner_b, beside->corner_b);
            }
        }
    }

    /// A connected set of flat corners goes with the neighbours that are turned as the first of them is.
    void join_flat(std::vector<std::pair<uint32_t, uint32_t>>& flat_beside) {
        for (auto& [flat_corner, beside] : flat_beside) flat_corner = groups_.find(flat_corner);
        std::sort(flat_beside.begin(), flat_beside.end());
        for (size_t first = 0, i = 0; i < flat_beside.size(); ++i) {
            if (flat_beside[i].first != flat_beside[first].first) first = i;
            if (turns_[flat_beside[i].second / 3] == turns_[flat_beside[first].second / 3]) groups_.join(flat_beside[i].first, flat_beside[i].second);
        }
    }

    /// A triangle with two equal corners has no direction: its corners take the tangent of another triangle at the same welded vertex.
    void lend_to_degenerate() {
        std::vector<uint32_t> good(corners_, kNone);
        for (uint32_t c = 0; c < corners_; ++c)
            if (!degenerate_[c / 3] && good[welded_[c]] == kNone) good[welded_[c]] = c;
        for (uint32_t c = 0; c < corners_; ++c)
            if (degenerate_[c / 3] && good[welded_[c]] != kNone) groups_.join(c, good[welded_[c]]);
    }

    /// The part of `v` in the plane of `n`, as a unit vector; 0 where there is none.
    static Vec3 flattened(const Vec3& v, const Vec3& n) { return normalized(v - n * dot(n, v)); }

    /// What the triangle of `corner` adds to the average there.
    Vec3 contribution(uint32_t corner) const {
        if (degenerate_[corner / 3] || turns_[corner / 3] == flat) return Vec3(0);
        const Vec3 n(normal(corner)), p = position(corner);
        const Vec3 next = flattened(position(other(corner, 1)) - p, n), previous = flattened(position(other(corner, 2)) - p, n);
        const double angle = std::atan2(length(cross(next, previous)), dot(next, previous));
        return flattened(along_u_[corner / 3], n) * angle;
    }

    Attribute<Vec4f> average() {
        std::vector<Vec3> sums(corners_, Vec3(0));
        std::vector<uint8_t> turn(corners_, flat);
        for (uint32_t c = 0; c < corners_; ++c) {
            const uint32_t group = groups_.find(c);
            const Vec3 added = contribution(c);
            if (is_finite(added)) sums[group] += added;
            if (turn[group] == flat && !degenerate_[c / 3]) turn[group] = turns_[c / 3];
        }
        Attribute<Vec4f> out;
        std::vector<uint32_t> index(corners_, kNone);
        for (uint32_t c = 0; c < corners_; ++c) {
            const uint32_t group = groups_.find(c);
            if (index[group] == kNone) {
                index[group] = uint32_t(out.values.size());
                out.values.push_back(tangent(sums[group], Vec3(normal(c)), turn[group] == mirrored));
            }
            out.corners.push_back(index[group]);
        }
        return out;
    }

    static Vec4f tangent(const Vec3& sum, const Vec3& n, bool mirrored) {
        Vec3 t = normalized(sum), unused;
        if (!(std::abs(dot(t, t) - 1) < 1e-6)) orthonormal_basis(is_finite(n) ? n : Vec3(0, 0, 1), t, unused);
        return Vec4f(Vec3f(t), mirrored ? -1.0f : 1.0f);
    }

    const Mesh& mesh_;
    const Attribute<Vec2f>& uvs_;
    uint32_t corners_;
    Groups groups_;
    std::vector<Vec3> along_u_;          ///< by triangle, as the next three
    std::vector<Turn> turns_;
    std::vector<bool> degenerate_;
    std::vector<Vec3f> face_normals_;    ///< only of meshes without normals
    std::vector<uint32_t> welded_;       ///< by corner: the first corner that is equal
};

}  // namespace

Attribute<Vec4f> make_tangents(const Mesh& mesh, uint32_t uv_set) { return TangentMaker(mesh, uv_set).make(); }

}  // namespace alidade
