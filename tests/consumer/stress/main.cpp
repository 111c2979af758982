// SPDX-License-Identifier: Apache-2.0
/// An accelerator of one's own in the tables of `alidade stress`: a list of triangles behind one box, each tested by Moeller and Trumbore's method.
#include "stress/run.h"
#include "stress/table.h"

#include <cstdio>

using namespace alidade;

class List : public Accelerator {
  public:
    explicit List(const TriangleView& mesh) : positions_(mesh.positions.begin(), mesh.positions.end()), triangles_(mesh.triangles.begin(), mesh.triangles.end()) {
        for (const Vec3f& p : positions_) box_.extend(Vec3(p));
        stats_.primitives = triangles_.size();
        stats_.bytes = sizeof(*this) + positions_.size() * sizeof(Vec3f) + triangles_.size() * sizeof(Index3);
    }
    bool intersect(const Ray& ray, Hit& hit, WorkCounters& work, uint32_t instance) const override {
        bool found = false;
        work.filtered += triangles_.size();
        for (uint32_t i = 0; i < triangles_.size(); ++i) {
            const Vec3 a = corner(i, 0), e1 = corner(i, 1) - a, e2 = corner(i, 2) - a, p = cross(ray.dir, e2), s = ray.origin - a, q = cross(s, e1);
            const double det = dot(e1, p), u = dot(s, p) / det, v = dot(ray.dir, q) / det, t = dot(e2, q) / det;
            if (!(u >= 0 && v >= 0 && u + v <= 1 && t >= ray.tmin && t <= ray.tmax) || !comes_before(t, instance, i, hit)) continue;
            hit.t = t, hit.instance = instance, hit.primitive = i, hit.u = float(u), hit.v = float(v), found = true;
        }
        return found;
    }
    bool occluded(const Ray& ray, WorkCounters& work) const override {
        Hit unused;
        return intersect(ray, unused, work, 0);
    }
    void all_hits(const Ray&, std::vector<Hit>&, WorkCounters&, uint32_t) const override {}                  // is not measured
    bool candidates(const Shaft&, size_t, std::vector<uint32_t>&) const override { return false; }          // nor is this
    Bounds bounds() const override { return box_; }
    const BuildStats& stats() const override { return stats_; }

  private:
    Vec3 corner(uint32_t i, int k) const { return Vec3(positions_[triangles_[i][k]]); }

    std::vector<Vec3f> positions_;
    std::vector<Index3> triangles_;
    Bounds box_;
    BuildStats stats_;
};

std::unique_ptr<Accelerator> over_triangles(const TriangleView& mesh, const AccelOptions&) { return std::make_unique<List>(mesh); }

int main() {
    const AcceleratorEntry& bvh = *find_accelerator("bvh");
    const std::vector<AcceleratorEntry> entries{bvh, {"list", "every triangle", over_triangles, bvh.over_set}};
    const StressFigures figures = stress_entries(find_stress_kind("scan")->make(2000, 1), entries, 32);
    std::fputs(stress_table(figures).c_str(), stdout);
    return figures.disagreements.empty() && figures.peers.size() == 4 ? 0 : 1;
}
