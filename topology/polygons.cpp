// SPDX-License-Identifier: Apache-2.0
#include "topology/polygons.h"

#include <type_traits>

namespace alidade::topology {
namespace {

/// Joins triangles to the polygons of the file.
class Outliner {
  public:
    Outliner(const Mesh& mesh, const Welded& surface) : mesh_(mesh), surface_(surface) {}

    /// The corners of all polygons, as corners of triangles; `first` as in Polygons.
    std::vector<uint32_t> run(std::vector<uint32_t>& first) {
        for (uint32_t begin = 0, end; begin < surface_.triangles.size(); begin = end) {
            end = begin + 1;
            while (!mesh_.faces.empty() && end < surface_.triangles.size() && mesh_.faces[end] == mesh_.faces[begin]) ++end;
            if (end == begin + 1 || !outline(begin, end)) triangles(begin, end);
            else corners_.insert(corners_.end(), loop_.begin(), loop_.end()), firsts_.push_back(uint32_t(corners_.size()));
        }
        first = std::move(firsts_);
        return std::move(corners_);
    }

  private:
    uint32_t vertex(uint32_t corner) const { return surface_.triangles[corner / 3][int(corner % 3)]; }

    void triangles(uint32_t begin, uint32_t end) {
        for (uint32_t t = begin; t < end; ++t) {
            if (!surface_.sound[t]) continue;
            for (uint32_t k = 0; k < 3; ++k) corners_.push_back(3 * t + k);
            firsts_.push_back(uint32_t(corners_.size()));
        }
    }

    /// The sides of the triangles [begin, end) that have no opposite, as one loop; false if they make none.
    bool outline(uint32_t begin, uint32_t end) {
        sides_.clear(), loop_.clear();
        for (uint32_t c = 3 * begin; c < 3 * end; ++c) {
            if (!surface_.sound[c / 3]) return false;
            sides_.push_back({vertex(c), vertex(next_corner(c)), c});
        }
        std::sort(sides_.begin(), sides_.end());
        outer_.clear();
        for (const auto& [from, to, corner] : sides_) {
            const auto opposite = std::lower_bound(sides_.begin(), sides_.end(), std::array{to, from, 0u});
            if (opposite == sides_.end() || (*opposite)[0] != to || (*opposite)[1] != from) outer_.push_back({from, to, corner});
        }
        for (size_t i = 1; i < outer_.size(); ++i)
            if (outer_[i][0] == outer_[i - 1][0]) return false;   // a vertex that the outline passes twice
        if (outer_.size() != size_t(end - begin) + 2) return false;
        return follow();
    }

    /// Begins at the lowest corner, so that the polygon begins as its first triangle does.
    bool follow() {
        auto at = std::min_element(outer_.begin(), outer_.end(), [](const auto& a, const auto& b) { return a[2] < b[2]; });
        const uint32_t start = (*at)[0];
        do {
            loop_.push_back((*at)[2]);
            if (loop_.size() > outer_.size()) return false;
            const uint32_t to = (*at)[1];
            at = std::lower_bound(outer_.begin(), outer_.end(), std::array{to, 0u, 0u});
            if (at == outer_.end() || (*at)[0] != to) return false;
        } while ((*at)[0] != start);
        return loop_.size() == outer_.size();
    }

    const Mesh& mesh_;
    const Welded& surface_;
    std::vector<uint32_t> corners_, firsts_{0}, loop_;
    std::vector<std::array<uint32_t, 3>> sides_, outer_;   ///< from, to, corner
};

template <class T> Channel channel_of(const Attribute<T>& attribute, const Mesh& mesh, const std::vector<uint32_t>& corners) {
    Channel out;
    for (const T& v : attribute.values) {
        if constexpr (std::is_same_v<T, Vec2f>) out.values.emplace_back(v.x, v.y, 0.f, 0.f);
        else out.values.push_back(v);
    }
    for (const uint32_t c : corners) out.corners.push_back(attribute.index(c / 3, int(c % 3), mesh.triangles[c / 3]));
    return out;
}

/// The other way: the corners of a fan around each polygon's first corner.
std::vector<uint32_t> fan_corners(const Polygons& polygons) {
    std::vector<uint32_t> fan;
    for (size_t p = 0; p < polygons.count(); ++p)
        for (uint32_t c = polygons.first[p] + 2; c < polygons.first[p + 1]; ++c)
            for (const uint32_t corner : {polygons.first[p], c - 1, c}) fan.push_back(corner);
    return fan;
}

template <class T> Attribute<T> attribute_of(const Channel& channel, const std::vector<uint32_t>& fan) {
    Attribute<T> out;
    for (const Vec4f& v : channel.values) {
        if constexpr (std::is_same_v<T, Vec2f>) out.values.emplace_back(v.x, v.y);
        else out.values.push_back(v);
    }
    for (const uint32_t c : fan) out.corners.push_back(channel.corners[c]);
    return out;
}

}  // namespace

Polygons polygons_of(const Mesh& mesh, const Welded& surface) {
    Polygons out;
    const std::vector<uint32_t> corners = Outliner(mesh, surface).run(out.first);
    std::vector<uint32_t> number(surface.points.size(), kNone);
    for (const uint32_t c : corners) {
        const uint32_t vertex = surface.triangles[c / 3][int(c % 3)];
        if (number[vertex] == kNone) number[vertex] = uint32_t(out.points.size()), out.points.push_back(surface.points[vertex]);
        out.corners.push_back(number[vertex]);
    }
    if (!mesh.slots.empty())
        for (size_t p = 0; p < out.count(); ++p) out.slots.push_back(mesh.slots[corners[out.first[p]] / 3]);
    for (const auto& uv : mesh.uvs) out.channels.push_back(channel_of(uv, mesh, corners));
    for (const auto& color : mesh.colors) out.channels.push_back(channel_of(color, mesh, corners));
    return out;
}

Mesh mesh_of(const Polygons& polygons, const Mesh& like) {
    Mesh out;
    out.origin = like.origin;
    for (const Vec3& p : polygons.points) out.positions.emplace_back(p);
    if (!like.exact_positions.empty()) out.exact_positions = polygons.points;
    const std::vector<uint32_t> fan = fan_corners(polygons);
    for (size_t i = 0; i < fan.size(); i += 3) out.triangles.emplace_back(polygons.corners[fan[i]], polygons.corners[fan[i + 1]], polygons.corners[fan[i + 2]]);
    for (size_t p = 0; p < polygons.count(); ++p) {
        const size_t triangles = polygons.first[p + 1] - polygons.first[p] - 2;
        if (!polygons.slots.empty()) out.slots.insert(out.slots.end(), triangles, polygons.slots[p]);
        if (!polygons.all_triangles()) out.faces.insert(out.faces.end(), triangles, uint32_t(p));
    }
    for (size_t i = 0; i < polygons.channels.size(); ++i) {
        if (i < like.uvs.size()) out.uvs.push_back(attribute_of<Vec2f>(polygons.channels[i], fan));
        else out.colors.push_back(attribute_of<Vec4f>(polygons.channels[i], fan));
    }
    return out;
}

}  // namespace alidade::topology
