// SPDX-License-Identifier: Apache-2.0
/// Makes an Accelerator of a structure and a leaf: everything that all structures share stands here.
#pragma once

#include "accel/accelerator.h"
#include "accel/custom_leaf.h"
#include "accel/query.h"
#include "accel/shaft.h"
#include "accel/triangles/triangle_leaf.h"
#include "core/parallel.h"

#include <chrono>
#include <optional>

namespace alidade {

/// A structure has a constructor (BuildInput&, AccelOptions, BuildStats&), `traverse(local ray, query, work)`, and `bytes()`.
template <template <class> class Structure, class Leaf> class StructureAccelerator final : public Accelerator {
  public:
    StructureAccelerator(const typename Leaf::Source& source, const AccelOptions& options) {
        const auto start = std::chrono::steady_clock::now();
        std::vector<uint32_t> order, ids = sort_out(source, options.threads, order);
        unbounded_ = uint32_t(order.size());
        stats_.primitives = ids.size() + order.size();
        BuildInput<typename Leaf::Source> input{source, std::move(ids), bounds_, order};
        structure_.emplace(input, options, stats_);
        stats_.references = order.size() - size_t(std::count(order.begin(), order.end(), kPadding));
        leaf_.emplace(source, order, options);
        stats_.bytes = sizeof(*this) + structure_->bytes() + leaf_->bytes();
        stats_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    bool intersect(const Ray& ray, Hit& hit, WorkCounters& work, uint32_t instance) const override {
        if (!can_hit(ray, kLargestCoordinate<typename Leaf::Real>)) return false;
        const LocalRay local = local_ray(ray, bounds_, Leaf::kMovesRay);
        ClosestQuery<Leaf> query(*leaf_, ray, local, hit, work, instance);
        ask(local, query, work);
        return query.found();
    }

    bool occluded(const Ray& ray, WorkCounters& work) const override {
        if (!can_hit(ray, kLargestCoordinate<typename Leaf::Real>)) return false;
        const LocalRay local = local_ray(ray, bounds_, Leaf::kMovesRay);
        AnyQuery<Leaf> query(*leaf_, ray, local, work);
        ask(local, query, work);
        return query.found();
    }

    void all_hits(const Ray& ray, std::vector<Hit>& hits, WorkCounters& work, uint32_t instance) const override {
        if (!can_hit(ray, kLargestCoordinate<typename Leaf::Real>)) return;
        const LocalRay local = local_ray(ray, bounds_, Leaf::kMovesRay);
        AllQuery<Leaf> query(*leaf_, ray, local, hits, work, instance);
        ask(local, query, work);
        query.finish();
    }

    bool candidates(const Shaft& shaft, size_t most, std::vector<uint32_t>& ids) const override {
        ids.clear();
        if constexpr (requires(const Leaf& leaf) { leaf.candidates(shaft, 0, 0, most, ids); } && requires(const Structure<Leaf>& s) { s.visit_shaft(shaft, [](uint32_t, uint32_t) { return true; }); }) {
            if (!leaf_->candidates(shaft, 0, unbounded_, most, ids)) return false;
            return !shaft.meets(bounds_) || structure_->visit_shaft(shaft, [&](uint32_t first, uint32_t count) { return leaf_->candidates(shaft, first, count, most, ids); });
        }
        return false;
    }

    Bounds bounds() const override { return bounds_; }
    const BuildStats& stats() const override { return stats_; }

  private:
    template <class Query> void ask(const LocalRay& local, Query& query, WorkCounters& work) const {
        if (unbounded_ && query.visit(0, unbounded_)) return;
        if (!local.enters_box()) return;
        ++work.rays;
        structure_->traverse(local, query, work);
    }

    struct Sorted {
        std::vector<uint32_t> bounded, unbounded, removed;
        Bounds bounds;   ///< of the bounded ones
    };

    /// Returns the bounded primitives; puts the unbounded ones into `order`, the hopeless ones into stats_.removed; empty ones are dropped.
    std::vector<uint32_t> sort_out(const typename Leaf::Source& source, int threads, std::vector<uint32_t>& order) {
        std::vector<Sorted> ranges((source.size() + kRange - 1) / kRange);
        for_ranges(source.size(), threads, [&](size_t first, size_t end) { ranges[first / kRange] = sorted(source, uint32_t(first), uint32_t(end)); });
        std::vector<uint32_t> ids;
        ids.reserve(source.size());
        for (const Sorted& range : ranges) {
            ids.insert(ids.end(), range.bounded.begin(), range.bounded.end());
            order.insert(order.end(), range.unbounded.begin(), range.unbounded.end());
            stats_.removed.insert(stats_.removed.end(), range.removed.begin(), range.removed.end());
            bounds_.extend(range.bounds);
        }
        return ids;
    }

    static Sorted sorted(const typename Leaf::Source& source, uint32_t first, uint32_t end) {
        Sorted out;
        BoundsT<typename Leaf::Real> bounds;
        size_t bounded = 0;
        out.bounded.resize(end - first);
        for (uint32_t id = first; id < end; ++id) {
            switch (source.kind(id)) {
                case PrimitiveKind::bounded: out.bounded[bounded++] = id, bounds.extend(box_of<typename Leaf::Real>(source, id)); break;
                case PrimitiveKind::unbounded: out.unbounded.push_back(id); break;
                case PrimitiveKind::removed: out.removed.push_back(id); break;
                case PrimitiveKind::empty: break;
            }
        }
        out.bounded.resize(bounded);
        out.bounds = {Vec3(bounds.min), Vec3(bounds.max)};
        return out;
    }

    Bounds bounds_;
    BuildStats stats_;
    uint32_t unbounded_ = 0;
    std::optional<Structure<Leaf>> structure_;
    std::optional<Leaf> leaf_;
};

/// The two columns of the registry. Each structure's .cpp instantiates them.
template <template <class> class Structure> std::unique_ptr<Accelerator> over_triangles(const TriangleView& mesh, const AccelOptions& options) {
    if (options.precision == Precision::double_) {
        return std::make_unique<StructureAccelerator<Structure, TriangleLeaf<double>>>(TriangleSource<double>(mesh), options);
    }
    return std::make_unique<StructureAccelerator<Structure, TriangleLeaf<float>>>(TriangleSource<float>(mesh), options);
}

template <template <class> class Structure>
std::unique_ptr<Accelerator> over_set(std::shared_ptr<const PrimitiveSet> set, const AccelOptions& options) {
    return std::make_unique<StructureAccelerator<Structure, CustomLeaf>>(PrimitiveSetSource(std::move(set)), options);
}

}  // namespace alidade
