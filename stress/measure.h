// SPDX-License-Identifier: Apache-2.0
/// Time, memory, medians.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace alidade {

/// CPU time of this thread: what other programs take is not in it.
double thread_seconds();
/// Since some fixed point.
double wall_seconds();

/// The mean of the middle two of an even number; NaN of none.
double median(std::vector<double> values);

struct Spread {
    double median = 0, low = 0, high = 0;   ///< low and high: the least and the greatest
};
Spread spread_of(const std::vector<double>& values);

/// seconds[peer][round] of `body(peer, i)`: in each round every peer in turn, so that a busy machine slows all of them.
template <class Peer, class F> std::vector<std::vector<double>> interleaved(std::span<const std::unique_ptr<Peer>> peers, int rounds, F&& body) {
    std::vector<std::vector<double>> seconds(peers.size());
    for (int round = 0; round < rounds; ++round) {
        for (size_t i = 0; i < peers.size(); ++i) {
            const double start = thread_seconds();
            body(*peers[i], i);
            seconds[i].push_back(thread_seconds() - start);
        }
    }
    return seconds;
}

/// How much the process' resident memory rose above what it was at construction, at its highest. Pages that were free then are given back first, so
/// that they count again. Linux' high-water mark: in steps of pages, and of huge pages where there are some.
class PeakMemory {
  public:
    PeakMemory();
    /// Nothing where the system does not let the mark be reset.
    std::optional<size_t> bytes() const;

  private:
    std::optional<size_t> before_;
};

/// What the system could give now without swapping; 0 if it does not say.
size_t available_memory();

}  // namespace alidade
