// SPDX-License-Identifier: Apache-2.0
/// Leaves that hold ids of a PrimitiveSet: instances, analytic shapes. Their rays stay the caller's, their boxes are double.
#pragma once

#include "accel/accelerator.h"
#include "accel/leaf.h"
#include "accel/shaft.h"

#include <algorithm>
#include <array>

namespace alidade {

class PrimitiveSetSource {
  public:
    explicit PrimitiveSetSource(std::shared_ptr<const PrimitiveSet> set) : set_(std::move(set)) {}

    size_t size() const { return set_->size(); }
    Bounds bounds(uint32_t id) const { return set_->bounds(id); }
    Bounds clipped_bounds(uint32_t id, const Bounds& box) const { return set_->clipped_bounds(id, box); }
    PrimitiveKind kind(uint32_t id) const {
        const Bounds box = bounds(id);
        for (int a = 0; a < 3; ++a) {
            if (std::isnan(box.min[a]) || std::isnan(box.max[a])) return PrimitiveKind::removed;
        }
        if (box.empty()) return PrimitiveKind::empty;
        return max_abs(box.min) <= kLargestCoordinate<double> && max_abs(box.max) <= kLargestCoordinate<double> ? PrimitiveKind::bounded : PrimitiveKind::unbounded;
    }
    const std::shared_ptr<const PrimitiveSet>& set() const { return set_; }

  private:
    std::shared_ptr<const PrimitiveSet> set_;
};

class CustomLeaf {
  public:
    using Real = double;
    using Source = PrimitiveSetSource;
    static constexpr uint32_t kBlock = 1;
    static constexpr RayEntry kEntry{false, kFar};

    struct Probe {
        Probe(const CustomLeaf& leaf, const Ray& r, const LocalRay&, uint32_t) : ray(r) {   // the instance of a hit is the set's own affair
            if (leaf.shared_) asked.fill(kNoId);
        }
        void prepare() {}
        const Ray& ray;
        mutable std::array<uint32_t, 32> asked;   ///< where primitives are shared: at its number's place, the last id that was. To ask one again changes nothing
    };

    CustomLeaf(const Source& source, const std::vector<uint32_t>& order, const AccelOptions&) : set_(source.set()), ids_(order), shared_(has_repeats(order)) {}

    bool closest(const Probe& probe, uint32_t first, uint32_t count, Hit& hit, WorkCounters& work) const {
        bool found = false;
        for_each_new(probe, first, count, work, [&](std::span<const uint32_t> ids) {
            found |= set_->intersect(ids, probe.ray, hit, work);
            return false;
        });
        return found;
    }
    bool any(const Probe& probe, uint32_t first, uint32_t count, WorkCounters& work) const {
        return for_each_new(probe, first, count, work, [&](std::span<const uint32_t> ids) { return set_->occluded(ids, probe.ray, work); });
    }
    void all(const Probe& probe, uint32_t first, uint32_t count, std::vector<Hit>& hits, WorkCounters& work) const {
        for_each_new(probe, first, count, work, [&](std::span<const uint32_t> ids) {
            set_->all_hits(ids, probe.ray, hits, work);
            return false;
        });
    }
    /// Appends those in the range whose bounds the shaft meets; false if there are then more than `most`.
    bool candidates(const Shaft& shaft, uint32_t first, uint32_t count, size_t most, std::vector<uint32_t>& out) const {
        for (const uint32_t id : ids(first, count))
            if (shaft.meets(set_->bounds(id))) out.push_back(id);
        return out.size() <= most;
    }
    uint32_t id(uint32_t place) const { return ids_[place]; }
    size_t bytes() const { return ids_.capacity() * sizeof(uint32_t); }

  private:
    static bool has_repeats(std::vector<uint32_t> ids) {
        std::sort(ids.begin(), ids.end());
        return std::adjacent_find(ids.begin(), ids.end()) != ids.end();
    }

    /// Shows `ask` the ids of the range that were not asked lately, as many at once as follow each other, until it returns true; then returns true.
    template <class F> bool for_each_new(const Probe& probe, uint32_t first, uint32_t count, WorkCounters& work, F&& ask) const {
        if (!shared_) return work.filtered += count, count > 0 && ask(ids(first, count));
        const uint32_t end = first + count;
        for (uint32_t place = first; place < end;) {
            const uint32_t start = place;
            for (; place < end; ++place) {
                uint32_t& last = probe.asked[ids_[place] % probe.asked.size()];
                if (last == ids_[place]) break;
                last = ids_[place];
            }
            work.filtered += place - start;
            if (place > start && ask(ids(start, place - start))) return true;
            while (place < end && probe.asked[ids_[place] % probe.asked.size()] == ids_[place]) ++place;
        }
        return false;
    }

    std::span<const uint32_t> ids(uint32_t first, uint32_t count) const { return std::span(ids_).subspan(first, count); }

    std::shared_ptr<const PrimitiveSet> set_;
    std::vector<uint32_t> ids_;
    bool shared_;   ///< do cells of a grid or an octree share primitives?
};

}  // namespace alidade
