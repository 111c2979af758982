// SPDX-License-Identifier: Apache-2.0
#include "topology/wedges.h"

namespace alidade::topology {
namespace {

/// What corners have besides a point: a row of numbers each.
class Rows {
  public:
    Rows(const Mesh& mesh, const Welded& surface) : surface_(surface), width_(1 + 2 * mesh.uvs.size() + 4 * mesh.colors.size()) {
        values_.reserve(width_ * 3 * mesh.triangles.size());
        for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (int k = 0; k < 3; ++k) append(mesh, t, k);
    }
    uint32_t point(uint32_t corner) const { return surface_.triangles[corner / 3][int(corner % 3)]; }

    /// -1, 0 or 1, by point, then by values. NaN is equal to NaN and comes last.
    int compare(uint32_t a, uint32_t b) const {
        if (point(a) != point(b)) return point(a) < point(b) ? -1 : 1;
        for (size_t i = 0; i < width_; ++i) {
            const float x = values_[a * width_ + i], y = values_[b * width_ + i];
            if (x < y || (std::isnan(y) && !std::isnan(x))) return -1;
            if (y < x || (std::isnan(x) && !std::isnan(y))) return 1;
        }
        return 0;
    }

  private:
    void append(const Mesh& mesh, uint32_t t, int k) {
        values_.push_back(mesh.slots.empty() ? 0.f : float(mesh.slots[t]));   // slots are below 2^24: exact
        for (const auto& uv : mesh.uvs) {
            const Vec2f& v = uv.values[uv.index(t, k, mesh.triangles[t])];
            values_.insert(values_.end(), {v.x, v.y});
        }
        for (const auto& color : mesh.colors) {
            const Vec4f& v = color.values[color.index(t, k, mesh.triangles[t])];
            values_.insert(values_.end(), {v.x, v.y, v.z, v.w});
        }
    }

    const Welded& surface_;
    size_t width_;
    std::vector<float> values_;
};

}  // namespace

Wedges wedges_of(const Mesh& mesh, const Welded& surface) {
    const Rows rows(mesh, surface);
    std::vector<uint32_t> order;
    for (uint32_t c = 0; c < 3 * mesh.triangles.size(); ++c)
        if (surface.sound[c / 3]) order.push_back(c);
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        const int way = rows.compare(a, b);
        return way != 0 ? way < 0 : a < b;
    });
    Wedges out;
    out.of_corner.assign(3 * mesh.triangles.size(), kNone);
    for (size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || rows.compare(order[i - 1], order[i]) != 0) {
            out.corner.push_back(order[i]);
            out.point.push_back(rows.point(order[i]));
        }
        out.of_corner[order[i]] = uint32_t(out.corner.size() - 1);
    }
    return out;
}

}  // namespace alidade::topology
