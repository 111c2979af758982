// SPDX-License-Identifier: Apache-2.0
/// The three questions. A structure asks a query how far it need look (limit, in local t) and shows it ranges of primitives (visit, true to stop); finish() completes what was found, and is true if there was something.
#pragma once

#include "accel/leaf.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace alidade {

template <class Leaf> class ClosestQuery {
  public:
    using Real = typename Leaf::Real;
    static constexpr bool kNearestFirst = true;

    ClosestQuery(const Leaf& leaf, const Ray& ray, const LocalRay& local, WorkCounters& work, Hit& hit, uint32_t instance)
        : leaf_(leaf), probe_(leaf, ray, local, instance), local_(local), hit_(hit), work_(work) {
        shorten();
    }
    double limit() const { return limit_; }
    bool visit(uint32_t first, uint32_t count) {
        if (leaf_.closest(probe_, first, count, hit_, work_)) found_ = true, shorten();
        return false;
    }
    /// As visit, of those of a block, the one of that number, that passed the filter.
    bool decide(const auto& block, uint32_t number, uint32_t lanes) {
        if (leaf_.closest_of(probe_, block, number, lanes, limit_, hit_, work_)) found_ = true, shorten();
        return false;
    }
    /// Before the first visit or decision: what of a probe rays pay for that come to a leaf.
    [[gnu::always_inline]] inline void prepare() { probe_.prepare(); }
    const Leaf& leaf() const { return leaf_; }
    const auto& probe() const { return probe_; }
    bool finish() {
        if constexpr (requires { leaf_.finish(probe_, hit_); }) leaf_.finish(probe_, hit_);
        return found_;
    }

  private:
    void shorten() { limit_ = hit_.valid() ? std::min(local_.tmax, local_.upper(hit_.t)) : local_.tmax; }

    const Leaf& leaf_;
    typename Leaf::Probe probe_;
    const LocalRay& local_;
    Hit& hit_;
    WorkCounters& work_;
    double limit_ = 0;
    bool found_ = false;
};

template <class Leaf> class AnyQuery {
  public:
    using Real = typename Leaf::Real;
    static constexpr bool kNearestFirst = false;

    AnyQuery(const Leaf& leaf, const Ray& ray, const LocalRay& local, WorkCounters& work)
        : leaf_(leaf), probe_(leaf, ray, local, kNoId), limit_(local.tmax), work_(work) {}
    double limit() const { return limit_; }
    bool visit(uint32_t first, uint32_t count) { return found_ = leaf_.any(probe_, first, count, work_); }
    bool decide(const auto& block, uint32_t, uint32_t lanes) { return found_ = leaf_.any_of(probe_, block, lanes, work_); }
    /// Before the first visit or decision: what of a probe rays pay for that come to a leaf.
    [[gnu::always_inline]] inline void prepare() { probe_.prepare(); }
    const Leaf& leaf() const { return leaf_; }
    const auto& probe() const { return probe_; }
    bool finish() const { return found_; }

  private:
    const Leaf& leaf_;
    typename Leaf::Probe probe_;
    double limit_;
    WorkCounters& work_;
    bool found_ = false;
};

/// Sorts the hits from `first` on, and takes out those that are there twice. A flat box is entered at -0 and left at 0: without the sign, chance says which of the two stays.
inline void put_in_order(std::vector<Hit>& hits, size_t first) {
    const auto key = [](const Hit& h) { return std::tuple(h.t, h.instance, h.primitive, h.part); };
    const auto begin = hits.begin() + std::ptrdiff_t(first);
    std::sort(begin, hits.end(), [&](const Hit& a, const Hit& b) { return std::pair(key(a), !std::signbit(a.t)) < std::pair(key(b), !std::signbit(b.t)); });
    hits.erase(std::unique(begin, hits.end(), [&](const Hit& a, const Hit& b) { return key(a) == key(b); }), hits.end());
}

template <class Leaf> class AllQuery {
  public:
    using Real = typename Leaf::Real;
    static constexpr bool kNearestFirst = false;

    AllQuery(const Leaf& leaf, const Ray& ray, const LocalRay& local, WorkCounters& work, std::vector<Hit>& hits, uint32_t instance)
        : leaf_(leaf), probe_(leaf, ray, local, instance), limit_(local.tmax), hits_(hits), old_(hits.size()), work_(work) {}
    double limit() const { return limit_; }
    bool visit(uint32_t first, uint32_t count) {
        leaf_.all(probe_, first, count, hits_, work_);
        return false;
    }
    bool decide(const auto& block, uint32_t, uint32_t lanes) {
        leaf_.all_of(probe_, block, lanes, hits_, work_);
        return false;
    }
    /// Before the first visit or decision: what of a probe rays pay for that come to a leaf.
    [[gnu::always_inline]] inline void prepare() { probe_.prepare(); }
    const Leaf& leaf() const { return leaf_; }
    const auto& probe() const { return probe_; }
    /// Puts the new hits in order. A structure may hold a primitive in several places, so a hit may have been found more than once.
    bool finish() { return put_in_order(hits_, old_), hits_.size() > old_; }

  private:
    const Leaf& leaf_;
    typename Leaf::Probe probe_;
    double limit_;
    std::vector<Hit>& hits_;
    size_t old_;
    WorkCounters& work_;
};

}  // namespace alidade
