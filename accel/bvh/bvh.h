// SPDX-License-Identifier: Apache-2.0
/// Bounding volume hierarchy.
#pragma once

#include "accel/bvh/build.h"
#include "accel/query.h"

namespace alidade {

template <class Leaf> class Bvh {
  public:
    using R = typename Leaf::Real;

    Bvh(BuildInput<typename Leaf::Source>& input, int, BuildStats& stats) {
        std::vector<BvhReference<R>> references;
        references.reserve(input.ids.size());
        for (const uint32_t id : input.ids) {
            const Bounds box = input.source.bounds(id);
            references.push_back({{Vec3T<R>(box.min), Vec3T<R>(box.max)}, id});   // exact: a leaf's Real holds its bounds
        }
        input.ids = {};
        const std::vector<BvhNode<R>> nodes = build_bvh(std::move(references), {Leaf::kBlock, Leaf::kMostReferences}, input.order, stats);
        if (!nodes.empty()) root_ = child(nodes[0]);
        pairs_.reserve(nodes.size() / 2);
        for (size_t i = 1; i < nodes.size(); i += 2) pairs_.push_back(pair(nodes, uint32_t(i)));
    }

    /// Nearer child first. A box is skipped only if its padded entry is beyond the padded limit: at an equal t there may be a lower id inside.
    template <class Query> void traverse(const LocalRay& ray, Query& query, WorkCounters& work) const {
        Waiting stack[kBvhDepth];
        const PairRay slab(slab_of(ray));
        const R start = SlabRay<R>::start(ray.tmin);
        R limit = SlabRay<R>::limit(query.limit());
        Waiting current{root_, start};
        for (uint32_t waiting = 0;;) {
            if (!current.child.count) {
                const Pair& pair = pairs_[current.child.first];
                const Lanes entry = slab.enter(pair, start, limit);
                work.boxes += 2;
                const int nearer = entry[1] < entry[0];
                const Waiting far{pair.child[1 - nearer], entry[1 - nearer]};
                if (far.entry <= limit) stack[waiting++] = far;
                current = {pair.child[nearer], entry[nearer]};
            } else {
                if (query.visit(current.child.first, current.child.count)) return;
                limit = SlabRay<R>::limit(query.limit());
                current.entry = std::numeric_limits<R>::infinity();
            }
            while (!(current.entry <= limit)) {
                if (waiting == 0) return;
                current = stack[--waiting];
            }
        }
    }
    size_t bytes() const { return pairs_.capacity() * sizeof(Pair); }

  private:
    typedef R Lanes __attribute__((vector_size(2 * sizeof(R))));   // a `using` would lose the attribute in a template

    struct Child {
        uint32_t first = 0;   ///< a leaf's first place in the order, or the pair of its children
        uint32_t count = 0;   ///< of references; 0 for inner nodes
    };
    struct Waiting {
        Child child;
        R entry;
    };
    /// Two children, beside each other: one instruction does the same for both.
    struct Pair {
        Lanes side[2][3];   ///< lower and upper, by axis
        Child child[2];
    };

    /// SlabRay::enter for both boxes of a pair, number by number.
    class PairRay {
      public:
        explicit PairRay(const SlabRay<R>& ray) {
            for (int a = 0; a < 3; ++a) {
                negative_[a] = ray.negative(a);
                near_origin_[a] = both(ray.near_origin(a)), far_origin_[a] = both(ray.far_origin(a)), inverse_[a] = both(ray.inverse(a));
            }
        }
        Lanes enter(const Pair& pair, R start, R limit) const {
            Lanes near = both(start), far = both(limit);
            for (int a = 0; a < 3; ++a) {
                const Lanes enter = (pair.side[negative_[a]][a] - near_origin_[a]) * inverse_[a];
                const Lanes leave = (pair.side[!negative_[a]][a] - far_origin_[a]) * inverse_[a];
                near = enter > near ? enter : near;   // a NaN keeps the old bound
                far = leave < far ? leave : far;
            }
            far += (far < R(0) ? -far : far) * (kSlabPad * kUnitRoundoff<R>);
            return (near <= far) & (near <= limit) ? near : both(std::numeric_limits<R>::infinity());
        }

      private:
        static Lanes both(R x) { return Lanes{x, x}; }

        Lanes near_origin_[3], far_origin_[3], inverse_[3];
        bool negative_[3];
    };

    static SlabRay<R> slab_of(const LocalRay& ray) {
        if constexpr (std::is_same_v<R, double>) return ray.slab;
        else return SlabRay<R>(ray.origin, ray.dir, ray.reach);
    }
    static Child child(const BvhNode<R>& node) {
        return node.leaf() ? Child{node.first, node.count} : Child{node.first / 2, 0};   // children stand at an odd place and the next one
    }
    static Pair pair(const std::vector<BvhNode<R>>& nodes, uint32_t first) {
        Pair pair;
        for (int a = 0; a < 3; ++a) {
            pair.side[0][a] = Lanes{nodes[first].box.min[a], nodes[first + 1].box.min[a]};
            pair.side[1][a] = Lanes{nodes[first].box.max[a], nodes[first + 1].box.max[a]};
        }
        for (uint32_t i : {0u, 1u}) pair.child[i] = child(nodes[first + i]);
        return pair;
    }

    std::vector<Pair> pairs_;
    Child root_;
};

}  // namespace alidade
