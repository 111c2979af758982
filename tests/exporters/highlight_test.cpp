// SPDX-License-Identifier: Apache-2.0
/// The lobes that POV-Ray's finishes get for GGX's highlights, against GGX itself in directions that the fit has not seen.
#include "exporters/pov/highlight.h"

#include "core/random.h"
#include "core/vec.h"

#include <gtest/gtest.h>

namespace alidade::pov_export {
namespace {

struct Angles {
    double nh, nl, nv, oh, rl;
};

/// Half of them near the highlight, where the half vector is near the normal.
std::optional<Angles> random_angles(const RandomKey& key, uint64_t i) {
    const auto number = [&](uint64_t k) { return key.child(i).uniform(k); };
    const double nv = 0.1 + 0.9 * number(0), nl = 0.1 + 0.9 * number(1), turn = 2 * kPi * number(2);
    const Vec3 eye(std::sqrt(1 - nv * nv), 0, nv), at(std::sqrt(1 - nl * nl) * std::cos(turn), std::sqrt(1 - nl * nl) * std::sin(turn), nl);
    const Vec3 mirrored(-eye.x, -eye.y, eye.z), light = i % 2 ? at : normalized(mirrored + at * 0.2), half = normalized(eye + light);
    if (light.z < 0.1) return std::nullopt;
    return Angles{half.z, light.z, nv, dot(eye, half), std::max(0.0, dot(mirrored, light))};
}

double displayed(double light) { return std::min(light, 1.0); }

double shown_by(const Lobes& l, const Angles& a) {
    return displayed(l.specular * std::pow(a.nh, 1 / l.roughness) + l.phong * std::pow(a.rl, l.phong_size) + l.diffuse * a.nl);
}

/// Blinn's lobe with GGX's height and width.
Lobes plain(const Gloss& gloss) {
    const double exponent = std::max(2 / (gloss.alpha * gloss.alpha) - 2, 1.0);
    return {gloss.f0 * (exponent + 2) / 8, 1 / exponent};
}

TEST(PovHighlight, IsNearerToGgxThanItsHeightAndWidth) {
    const RandomKey key(7, 0, 0);
    HighlightFits fits;
    for (const bool metal : {false, true}) {
        double ratios = 0;
        for (const double roughness : {0.15, 0.3, 0.5, 0.7, 0.85, 1.0}) {
            const Gloss gloss{roughness * roughness, metal ? 1 : 0.04, 1, metal};
            const Lobes fitted = fits(gloss), simple = plain(gloss);
            double of_fitted = 0, of_simple = 0;
            for (uint64_t i = 0; i < 4000; ++i) {
                const auto a = random_angles(key, i);
                if (!a) continue;
                const double want = displayed(microfacet_light(gloss, a->nh, a->nl, a->nv, a->oh));
                const double counts = a->nv * a->nl;   // of a picture, and of light
                of_fitted += counts * std::abs(shown_by(fitted, *a) - want), of_simple += counts * std::abs(shown_by(simple, *a) - want);
            }
            ratios += of_fitted / of_simple;
            EXPECT_LT(of_fitted, (metal ? 1.02 : 0.94) * of_simple) << (metal ? "metal" : "dielectric") << " of roughness " << roughness;
            if (std::getenv("ALIDADE_FIGURES")) std::printf("%s %.2f: %.3f of the plain lobe's difference\n", metal ? "metal" : "dielectric", roughness, of_fitted / of_simple);
        }
        EXPECT_LT(ratios / 6, metal ? 0.46 : 0.75);
    }
}

TEST(PovHighlight, FactorsAreNotNegative) {
    HighlightFits fits;
    for (const double f0 : {0.0, 0.02, 0.2, 1.0})
        for (double alpha = 1e-4; alpha <= 1; alpha *= 4) {
            const Lobes l = fits({alpha, f0, 1, f0 > 0.5});
            for (const double x : {l.specular, l.phong, l.diffuse, l.roughness, l.phong_size}) EXPECT_TRUE(std::isfinite(x) && x >= 0) << f0 << " " << alpha;
            EXPECT_EQ(f0 > 0.5 || l.diffuse == 0, true) << "a dielectric's highlight is white";
        }
}

}  // namespace
}  // namespace alidade::pov_export
