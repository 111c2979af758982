// SPDX-License-Identifier: Apache-2.0
/// Does it fit the budgets?
#pragma once

#include "stress/run.h"

namespace alidade {

/// Seconds for people: "0.02 s", "75 s".
std::string seconds_text(double seconds);
/// "512 MB".
std::string bytes_text(double bytes);

class StressBudget {
  public:
    explicit StressBudget(const StressOptions& options) : options_(options) {}

    double left() const { return options_.seconds - (wall_seconds() - start_); }
    /// The same without what is kept for rays.
    double spare() const { return left() - reserved_; }
    /// Why a peer is not built, or "": `bytes` are those of the scene and of what stands beside it. What it takes is kept for its rays.
    std::string admit(const StressPace& pace, double primitives, size_t builds, size_t rays, size_t bytes);
    /// Why a round of so many rays is not traced, or "".
    std::string admit_round(const StressPace& pace, double primitives, size_t rays) const;

  private:
    const StressOptions& options_;
    double start_ = wall_seconds();
    double reserved_ = 0;   ///< seconds for the rays of the peers that were built
};

}  // namespace alidade
