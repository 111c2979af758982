// SPDX-License-Identifier: Apache-2.0
#include "stress/growth.h"

#include <cmath>
#include <vector>

namespace alidade {

namespace {

bool has_logarithm(double value) { return value > 0 && std::isfinite(value); }

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const double> n, std::span<const double> cost) {
    std::vector<double> x, y;
    for (size_t i = 0; i < n.size(); ++i)
        if (has_logarithm(n[i]) && has_logarithm(cost[i])) x.push_back(std::log(n[i])), y.push_back(std::log(cost[i]));
    const auto count = double(x.size());
    double mx = 0, my = 0, xx = 0, xy = 0, rest = 0;
    for (size_t i = 0; i < x.size(); ++i) mx += x[i] / count, my += y[i] / count;
    for (size_t i = 0; i < x.size(); ++i) xx += (x[i] - mx) * (x[i] - mx), xy += (x[i] - mx) * (y[i] - my);
    if (x.size() < 2 || !(xx > 1e-12)) return std::nullopt;
    PowerLaw law;
    law.exponent = xy / xx, law.factor = std::exp(my - law.exponent * mx), law.points = x.size();
    for (size_t i = 0; i < x.size(); ++i) rest += std::pow(y[i] - my - law.exponent * (x[i] - mx), 2);
    if (x.size() > 2) law.error = std::sqrt(rest / (count - 2) / xx);
    return law;
}

}  // namespace alidade
