// SPDX-License-Identifier: Apache-2.0
/// Makes an Accelerator of a structure and a leaf: everything that all structures share stands here.
#pragma once

#include "accel/accelerator.h"
#include "accel/custom_leaf.h"
#include "accel/groups.h"
#include "accel/query.h"
#include "accel/shaft.h"
#include "accel/sort_out.h"
#include "accel/triangles/triangle_leaf.h"
#include "core/parallel.h"

#include <chrono>
#include <optional>

namespace alidade {

/// A structure has a constructor (BuildInput&, AccelOptions, BuildStats&), `traverse(local ray, query, work)` or else `tree(leaf, bounds, unbounded)` and `traversals()` of it, and `bytes()`; a tree has `visit_nodes(visit)`: visit(TreeNode, first place of a leaf, count), the
/// primitives left to the caller.
template <template <class> class Structure, class Leaf> class StructureAccelerator final : public Accelerator {
  public:
    StructureAccelerator(const typename Leaf::Source& source, const AccelOptions& options) {
        const auto start = std::chrono::steady_clock::now();
        PhaseClock clock(stats_);
        auto [ids, order, removed, box] = sort_out<typename Leaf::Real>(source, options.threads);
        bounds_ = box;
        unbounded_ = uint32_t(order.size());
        stats_.primitives = ids.size() + order.size();
        stats_.removed = std::move(removed);
        clock.ended("sort out");
        BuildInput<typename Leaf::Source> input{source, std::move(ids), box, order};
        structure_.emplace(input, options, stats_);   // has phases of its own
        clock.restart();
        stats_.references = order.size() - size_t(std::count(order.begin(), order.end(), kPadding));
        leaf_.emplace(source, order, options);
        if constexpr (requires(Structure<Leaf>& s, Leaf& leaf) { s.settle(leaf.blocks()); }) structure_->settle(leaf_->blocks());
        clock.ended("pack");
        stats_.bytes = sizeof(*this) + structure_->bytes() + leaf_->bytes();
        stats_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    /// Of parts that are there already.
    StructureAccelerator(Structure<Leaf> structure, Leaf leaf, const Bounds& bounds, BuildStats stats) : bounds_(bounds), stats_(std::move(stats)), structure_(std::move(structure)), leaf_(std::move(leaf)) {
        stats_.bytes = sizeof(*this) + structure_->bytes() + leaf_->bytes();
    }

    bool intersect(const Ray& ray, Hit& hit, WorkCounters& work, uint32_t instance) const override {
        if constexpr (kWalksItself) return structure_->traversals().closest(tree(), ray, work, hit, instance);
        else return ask<ClosestQuery<Leaf>>(ray, work, hit, instance);
    }

    void intersect_many(std::span<const Ray> rays, std::span<Hit> hits, WorkCounters& work, uint32_t instance) const override {
        if constexpr (requires(const Structure<Leaf>& s) { s.group(); }) {
            if (const auto group = structure_->group())
                return in_groups(rays, hits, [&](std::span<const Ray> some, std::span<Hit> found) { return group(tree(), some, found, work, instance); },
                                 [&](const Ray& ray, Hit& hit) { intersect(ray, hit, work, instance); });
        }
        Accelerator::intersect_many(rays, hits, work, instance);
    }

    bool occluded(const Ray& ray, WorkCounters& work) const override {
        if constexpr (kWalksItself) return structure_->traversals().any(tree(), ray, work);
        else return ask<AnyQuery<Leaf>>(ray, work);
    }

    void all_hits(const Ray& ray, std::vector<Hit>& hits, WorkCounters& work, uint32_t instance) const override {
        if constexpr (kWalksItself) structure_->traversals().all(tree(), ray, work, hits, instance);
        else ask<AllQuery<Leaf>>(ray, work, hits, instance);
    }

    bool candidates(const Shaft& shaft, size_t most, std::vector<uint32_t>& ids) const override {
        ids.clear();
        if constexpr (requires(const Leaf& leaf) { leaf.candidates(shaft, 0, 0, most, ids); } && requires(const Structure<Leaf>& s) { s.visit_shaft(shaft, [](uint32_t, uint32_t) { return true; }); }) {
            if (!leaf_->candidates(shaft, 0, unbounded_, most, ids)) return false;
            return !shaft.meets(bounds()) || structure_->visit_shaft(shaft, [&](uint32_t first, uint32_t count) { return leaf_->candidates(shaft, first, count, most, ids); });
        }
        return false;
    }

    Bounds bounds() const override { return bounds_.bounds(); }
    const BuildStats& stats() const override { return stats_; }

    bool visit_nodes(const std::function<void(const TreeNode&)>& visit) const override {
        if constexpr (requires(const Structure<Leaf>& s) { s.visit_nodes([](TreeNode&, uint32_t, uint32_t) {}); }) {
            std::vector<uint32_t> ids;
            structure_->visit_nodes([&](TreeNode& node, uint32_t first, uint32_t count) {
                ids.clear();
                for (uint32_t place = first; place < first + count; ++place) ids.push_back(leaf_->id(place));
                node.primitives = ids;
                visit(node);
            });
            return true;
        }
        return false;
    }

    bool refit(const TriangleView& mesh, int threads) override {
        if constexpr (requires(Structure<Leaf>& s) { s.refit(*leaf_, typename Leaf::Source(mesh), threads); }) {
            const auto start = std::chrono::steady_clock::now();
            BuildStats clocked;
            PhaseClock clock(clocked);
            const typename Leaf::Source source(mesh);
            const SortedOut found = sort_out<typename Leaf::Real>(source, threads);
            if (found.bounded.size() != stats_.primitives || found.removed != stats_.removed) return false;
            clock.ended("sort out");
            bounds_ = found.bounds;
            stats_.sah_cost = structure_->refit(*leaf_, source, threads);
            clock.ended("refit");
            stats_.phases = std::move(clocked.phases);
            stats_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            return true;
        }
        return Accelerator::refit(mesh, threads);
    }

    tl::expected<void, std::string> save(const std::string& path, const TriangleView& mesh) const override {
        if constexpr (requires(const Structure<Leaf>& s) { s.save(path, mesh, *leaf_, bounds(), stats_); }) return structure_->save(path, mesh, *leaf_, bounds(), stats_);
        else return Accelerator::save(path, mesh);
    }

  private:
    /// Are its questions compiled whole, from the caller's ray on?
    static constexpr bool kWalksItself = requires(const Structure<Leaf>& s) { s.traversals(); };
    auto tree() const { return structure_->tree(*leaf_, bounds_, unbounded_); }

    template <class Query, class... Results> bool ask(const Ray& ray, WorkCounters& work, Results&&... results) const {
        if (!can_hit(ray, kLargestCoordinate<typename Leaf::Real>)) return false;
        const LocalRay local = local_ray(ray, bounds_, Leaf::kEntry);
        if (unbounded_ == 0 && !local.enters_box()) return false;
        Query query(*leaf_, ray, local, work, std::forward<Results>(results)...);
        query.prepare();
        if (unbounded_ && query.visit(0, unbounded_)) return query.finish();
        if (local.enters_box()) ++work.rays, structure_->traverse(local, query, work);
        return query.finish();
    }

    RayBounds bounds_;
    BuildStats stats_;
    uint32_t unbounded_ = 0;
    std::optional<Structure<Leaf>> structure_;
    std::optional<Leaf> leaf_;
};

template <template <class> class Structure, class R> std::unique_ptr<Accelerator> over_triangles_of(const TriangleView& mesh, const AccelOptions& options) {
    const TriangleSource<R> source(mesh);
    using Blocks = typename BlocksOf<Structure, R>::Type;
    constexpr TriangleTest robust = requires { Structure<TriangleLeaf<R, TriangleTest::exact, Blocks>>::kWidensBoxes; } ? TriangleTest::watertight : TriangleTest::watertight_in_double;
    switch (options.intersect) {
        case Intersect::exact: break;
        case Intersect::robust: return std::make_unique<StructureAccelerator<Structure, TriangleLeaf<R, robust, Blocks>>>(source, options);
        case Intersect::fast: return std::make_unique<StructureAccelerator<Structure, TriangleLeaf<R, TriangleTest::fast, Blocks>>>(source, options);
    }
    return std::make_unique<StructureAccelerator<Structure, TriangleLeaf<R, TriangleTest::exact, Blocks>>>(source, options);
}

/// The two columns of the registry. Each structure's .cpp instantiates them.
template <template <class> class Structure> std::unique_ptr<Accelerator> over_triangles(const TriangleView& mesh, const AccelOptions& options) {
    return options.precision == Precision::double_ ? over_triangles_of<Structure, double>(mesh, options) : over_triangles_of<Structure, float>(mesh, options);
}

template <template <class> class Structure>
std::unique_ptr<Accelerator> over_set(std::shared_ptr<const PrimitiveSet> set, const AccelOptions& options) {
    return std::make_unique<StructureAccelerator<Structure, CustomLeaf>>(PrimitiveSetSource(std::move(set)), options);
}

}  // namespace alidade
