// SPDX-License-Identifier: Apache-2.0
/// The lobes that POV-Ray's finishes get for GGX's highlights, against GGX itself in directions that the fit has not seen.
#include "exporters/pov/highlight.h"

#include "core/image.h"
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

double light_of(const Lobes& l, const Angles& a) {
    double sum = l.lambert.factor * std::pow(a.nl, l.lambert.exponent);
    for (const Lobe& lobe : l.blinn) sum += lobe.factor * std::pow(a.nh, lobe.exponent);
    for (const Lobe& lobe : l.phong) sum += lobe.factor * std::pow(a.rl, lobe.exponent);
    return sum;
}

/// Blinn's lobe with GGX's height and width.
Lobes plain(const Gloss& gloss) {
    const double exponent = std::max(2 / (gloss.alpha * gloss.alpha) - 2, 1.0);
    Lobes out;
    out.blinn[0] = {gloss.f0 * (exponent + 2) / 8, exponent};
    return out;
}

TEST(PovHighlight, IsNearerToGgxThanItsHeightAndWidth) {
    const RandomKey key(7, 0, 0);
    const auto displayed = [](double light) { return std::min(light, 1.0); };
    HighlightFits fits;
    for (const bool metal : {false, true}) {
        double ratios = 0;
        for (const double roughness : {0.15, 0.3, 0.5, 0.7, 0.85, 1.0}) {
            const Gloss gloss{roughness * roughness, metal ? 1 : 0.04, 1, metal, false};
            const Lobes fitted = fits(gloss), simple = plain(gloss);
            double of_fitted = 0, of_simple = 0;
            for (uint64_t i = 0; i < 4000; ++i) {
                const auto a = random_angles(key, i);
                if (!a) continue;
                const double want = displayed(microfacet_light(gloss, a->nh, a->nl, a->nv, a->oh));
                const double counts = a->nv * a->nl;   // of a picture, and of light
                of_fitted += counts * std::abs(displayed(light_of(fitted, *a)) - want), of_simple += counts * std::abs(displayed(light_of(simple, *a)) - want);
            }
            ratios += of_fitted / of_simple;
            EXPECT_LT(of_fitted, (metal ? 1.02 : 0.94) * of_simple) << (metal ? "metal" : "dielectric") << " of roughness " << roughness;
            if (std::getenv("ALIDADE_FIGURES")) std::printf("%s %.2f: %.3f of the plain lobe's difference\n", metal ? "metal" : "dielectric", roughness, of_fitted / of_simple);
        }
        EXPECT_LT(ratios / 6, metal ? 0.46 : 0.75);
    }
}

/// The mean difference of what is displayed, as sRGB, of a dark surface with diffuse light from all directions.
double difference_seen(const Gloss& gloss, const Lobes& fitted) {
    constexpr double kDark = 0.05;
    const RandomKey key(11, 0, 0);
    const auto displayed = [](double light) { return linear_to_srgb(std::clamp(light, 0.0, 1.0)); };
    double sum = 0, count = 0;
    for (uint64_t i = 1; i < 8000; i += 2) {   // those in all directions
        const auto a = random_angles(key, i);
        if (!a) continue;
        const double straight = (gloss.metal ? 0 : kDark) * (1 - gloss.f0) * a->nl;   // the diffuse light, where nothing is mirrored but what is straight on
        const double want = straight * (1 - std::pow(1 - a->oh, 5)) + microfacet_light(gloss, a->nh, a->nl, a->nv, a->oh);
        sum += a->nv * a->nl * std::abs(displayed(straight + light_of(fitted, *a)) - displayed(want)), count += a->nv * a->nl;
    }
    return sum / count;
}

TEST(PovHighlight, LayersAreNearerThanOneFinish) {
    HighlightFits fits;
    for (const bool metal : {false, true}) {
        double ratios = 0;
        for (const double roughness : {0.15, 0.3, 0.5, 0.7, 0.85, 1.0}) {
            Gloss gloss{roughness * roughness, metal ? 1 : 0.04, 1, metal, false};
            const double one = difference_seen(gloss, fits(gloss));
            gloss.layers = true;
            const double all = difference_seen(gloss, fits(gloss));
            ratios += all / one;
            EXPECT_LT(all, 1.01 * one) << (metal ? "metal" : "dielectric") << " of roughness " << roughness;
            if (std::getenv("ALIDADE_FIGURES")) std::printf("%s %.2f: one finish %.4f, layers %.4f\n", metal ? "metal" : "dielectric", roughness, one, all);
        }
        EXPECT_LT(ratios / 6, metal ? 0.92 : 0.85);
    }
}

/// A finish has one lobe of each kind, and diffuse light of its pigment's colour.
TEST(PovHighlight, OneFinishHoldsWhatHasNoLayers) {
    HighlightFits fits;
    for (const bool metal : {false, true})
        for (double alpha = 1e-4; alpha <= 1; alpha *= 4) {
            const Lobes l = fits({alpha, metal ? 1 : 0.04, 1, metal, false});
            EXPECT_EQ(l.blinn[1].factor + l.phong[1].factor, 0) << alpha;
            EXPECT_TRUE(metal || l.lambert.factor == 0) << "a dielectric's highlight is white";
        }
}

TEST(PovHighlight, FactorsAreNotNegative) {
    HighlightFits fits;
    for (const bool layers : {false, true})
        for (const double f0 : {0.0, 0.02, 0.2, 1.0})
            for (double alpha = 1e-4; alpha <= 1; alpha *= 4) {
                const Lobes l = fits({alpha, f0, 1, f0 > 0.5, layers});
                for (const Lobe& lobe : {l.blinn[0], l.blinn[1], l.phong[0], l.phong[1], l.lambert})
                    EXPECT_TRUE(std::isfinite(lobe.factor) && lobe.factor >= 0 && std::isfinite(lobe.exponent) && lobe.exponent > 0) << f0 << " " << alpha;
                EXPECT_TRUE(f0 <= 0.5 || l.lambert.exponent == 1) << "a metal's diffuse light is in the finish of its pigment";
            }
}

}  // namespace
}  // namespace alidade::pov_export
