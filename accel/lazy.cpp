// SPDX-License-Identifier: Apache-2.0
#include "accel/lazy.h"

#include "accel/leaf.h"
#include "accel/local_ray.h"
#include "accel/sort_out.h"
#include "accel/triangles/triangle_source.h"

#include <atomic>
#include <mutex>

namespace alidade {
namespace {

class LazyTriangles final : public Accelerator {
  public:
    LazyTriangles(const AcceleratorEntry& entry, const TriangleView& mesh, const AccelOptions& options) : entry_(entry), mesh_(mesh), options_(options) {
        if (options.precision == Precision::double_) look<double>();
        else look<float>();
        waiting_.bytes = sizeof(*this);
    }

    bool intersect(const Ray& ray, Hit& hit, WorkCounters& work, uint32_t instance) const override {
        const Accelerator* structure = needed_by(ray);
        return structure && structure->intersect(ray, hit, work, instance);
    }
    void intersect_many(std::span<const Ray> rays, std::span<Hit> hits, WorkCounters& work, uint32_t instance) const override {
        size_t asked = 0;   // until one needs it, and it is built
        for (; asked < rays.size() && !known(); ++asked) hits[asked] = Hit(), intersect(rays[asked], hits[asked], work, instance);
        if (asked < rays.size()) known()->intersect_many(rays.subspan(asked), hits.subspan(asked), work, instance);
    }
    bool occluded(const Ray& ray, WorkCounters& work) const override {
        const Accelerator* structure = needed_by(ray);
        return structure && structure->occluded(ray, work);
    }
    void all_hits(const Ray& ray, std::vector<Hit>& hits, WorkCounters& work, uint32_t instance) const override {
        if (const Accelerator* structure = needed_by(ray)) structure->all_hits(ray, hits, work, instance);
    }
    /// As structures of triangles do: they have none to tell.
    bool candidates(const Shaft&, size_t, std::vector<uint32_t>& ids) const override { return ids.clear(), false; }
    Bounds bounds() const override { return bounds_; }
    const BuildStats& stats() const override {
        const Accelerator* structure = known();
        return structure ? structure->stats() : waiting_;
    }
    const Accelerator* known() const { return known_.load(std::memory_order_acquire); }

  private:
    /// The bounds of what can be hit, and what cannot: as every structure finds them before it is built.
    template <class R> void look() {
        SortedOut found = sort_out<R>(TriangleSource<R>(mesh_), options_.threads);
        bounds_ = found.bounds;
        waiting_.primitives = found.bounded.size() + found.unbounded.size();
        waiting_.removed = std::move(found.removed);
        largest_ = kLargestCoordinate<R>;
    }

    /// The structure, if there is one already or the ray enters its bounds; else null, and the ray hits nothing. Where structures leave some rays where they are, the interval of such a ray is asked: it is the wider one.
    const Accelerator* needed_by(const Ray& ray) const {
        if (const Accelerator* structure = known()) return structure;
        if (!can_hit(ray, largest_) || !local_ray(ray, bounds_, {options_.intersect == Intersect::exact, kFar}).enters_box()) return nullptr;
        return &structure();
    }

    [[gnu::noinline]] const Accelerator& structure() const {
        std::call_once(once_, [this] {
            built_ = entry_.over_triangles(mesh_, options_);
            known_.store(built_.get(), std::memory_order_release);
        });
        return *built_;
    }

    AcceleratorEntry entry_;
    TriangleView mesh_;
    AccelOptions options_;
    Bounds bounds_;
    double largest_ = 0;
    BuildStats waiting_;
    mutable std::once_flag once_;
    mutable std::unique_ptr<const Accelerator> built_;
    mutable std::atomic<const Accelerator*> known_ = nullptr;
};

}  // namespace

std::unique_ptr<Accelerator> over_triangles_lazily(const AcceleratorEntry& entry, const TriangleView& mesh, const AccelOptions& options) {
    return std::make_unique<LazyTriangles>(entry, mesh, options);
}

const Accelerator* built(const Accelerator& accelerator) {
    const auto* lazy = dynamic_cast<const LazyTriangles*>(&accelerator);
    return lazy ? lazy->known() : &accelerator;
}

}  // namespace alidade
