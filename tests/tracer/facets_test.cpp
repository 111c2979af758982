// SPDX-License-Identifier: Apache-2.0
/// What facets send back of light from everywhere, against the bound by which diffuse light is cut.
#include "tracer/shade.h"

#include <gtest/gtest.h>

#include <cmath>

namespace alidade {
namespace {

/// The integral of Trowbridge and Reitz's facets with Schlick's term from 0 to 1, by a substitution that spreads facets evenly: `n` squared points, the halves of which are alike.
double facets(double alpha, double cosine, int n) {
    const auto hidden = [&](double z) { return (std::sqrt(1 + alpha * alpha * (1 - z * z) / (z * z)) - 1) / 2; };
    const double sine = std::sqrt(1 - cosine * cosine);
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double u = (i + 0.5) / n, nh = 1 / std::sqrt(1 + alpha * alpha * u / (1 - u)), tilt = std::sqrt(1 - nh * nh);
        for (int j = 0; j < n; ++j) {
            const double vh = sine * tilt * std::cos(kPi * (j + 0.5) / n) + cosine * nh, nl = 2 * vh * nh - cosine;
            if (vh <= 0 || nl <= 0) continue;
            sum += std::pow(1 - std::min(vh, 1.0), 5) * vh / (cosine * nh * (1 + hidden(std::min(nl, 1.0)) + hidden(cosine)));
        }
    }
    return sum / (double(n) * n);
}

TEST(Facets, BoundIsAboveTheIntegralAndNear) {
    for (int r = 1; r <= 40; ++r) {
        for (int k = 1; k <= 60; ++k) {
            const double alpha = std::pow(r / 40.0, 2), cosine = std::pow(k / 60.0, 2), integral = facets(alpha, cosine, 150), bound = reflected_bound(0, 1, alpha, cosine);
            EXPECT_GE(bound, integral - 1e-4) << "roughness " << r / 40.0 << ", cosine " << cosine;
            EXPECT_LE(bound, integral + 0.15) << "roughness " << r / 40.0 << ", cosine " << cosine;
        }
    }
}

TEST(Facets, DiffuseLightGetsWhatIsLeft) {
    EXPECT_EQ(diffuse_share(0.8, 0.5), 0.5 / 0.8);
    EXPECT_EQ(diffuse_share(0.8, 0.1), 1);
    EXPECT_EQ(diffuse_share(0, 1), 1);
    EXPECT_EQ(diffuse_share(0, 1.5), 1) << "a metal of such a colour";
    EXPECT_EQ(diffuse_share(3, 1.5), 0) << "colours may be above 1, and light is never negative";
}

}  // namespace
}  // namespace alidade
