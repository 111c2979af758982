// SPDX-License-Identifier: Apache-2.0
/// Which crossings need not be found to the last digit (Wanted).
#pragma once

#include "eval/shapes/rows.h"

namespace alidade {

/// The ray with which crossings() asks for all of them.
inline Ray whole_line(const Ray& ray) {
    Ray whole = ray;
    whole.tmin = -kInf, whole.tmax = kInf;
    return whole;
}

/// Adds a crossing that lies between `low` and `high`, as exactly as it is wanted: `find()` is asked for it if need be. False if what comes behind it is not wanted.
template <class Find> bool add_wanted(const Ray& ray, Wanted wanted, double low, double high, const Find& find, Crossings& out) {
    if (high < ray.tmin) return out.add(high, 0), true;
    if (low > ray.tmax) return out.add(low, 0), wanted == Wanted::all;
    if (wanted == Wanted::any && low >= ray.tmin && high <= ray.tmax) return out.add(low, 0), false;
    const double t = find();
    out.add(t, 0);
    return wanted == Wanted::all || t < ray.tmin;
}

/// Where a crossing is known but for the last digits.
class RoughCrossings {
  public:
    /// `reach`: of the shape and of the ray's origin, in t.
    RoughCrossings(const Ray& ray, double reach) : tmin_(ray.tmin), tmax_(ray.tmax), reach_(reach) {}

    /// Far more than those digits.
    double slack(double t) const { return 1e-6 * (std::abs(t) + reach_); }
    bool surely_outside(double t) const { return t < tmin_ - slack(t) || t > tmax_ + slack(t); }
    bool surely_before(double t, double other) const { return t < other - slack(t); }

  private:
    double tmin_, tmax_, reach_;
};

}  // namespace alidade
