// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/highlight.h"

#include "core/vec.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace alidade::pov_export {

namespace {

constexpr double kPerceived = 0.1;   ///< brightness below which errors count alike
constexpr double kDiffuse = 0.5;     ///< what usual surfaces reflect

struct Sample {
    double nv = 0, nl = 0, nh = 0, oh = 0, rl = 0;   ///< cosines between the normal, the eye, the light, the half vector, the mirrored eye
    double weight = 0;
};

/// Eyes uniform in their cosine; half vectors at angles from the normal that grow by equal factors, each counting by its solid angle as seen from the light.
std::vector<Sample> directions() {
    constexpr int kEyes = 14, kTilts = 20, kTurns = 16;
    constexpr double kLeast = 0.004, kMost = 1.5;
    std::vector<Sample> out;
    for (int i = 0; i < kEyes; ++i)
        for (int j = 0; j < kTilts; ++j)
            for (int k = 0; k < kTurns; ++k) {
                const double nv = (i + 0.5) / kEyes, tilt = kLeast * std::pow(kMost / kLeast, j / (kTilts - 1.0)), turn = (k + 0.5) / kTurns * kPi;
                const Vec3 eye(std::sqrt(1 - nv * nv), 0, nv), half(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
                const double oh = dot(eye, half);
                const Vec3 light = half * (2 * oh) - eye;
                if (oh <= 0 || light.z <= 0.02) continue;
                out.push_back({nv, light.z, half.z, oh, std::max(0.0, 2 * nv * light.z - dot(eye, light)), tilt * std::sin(tilt) * 4 * oh});
            }
    return out;
}

const std::vector<Sample>& all_directions() {
    static const std::vector<Sample> all = directions();
    return all;
}

/// A lobe at all directions, weighted.
using Column = std::vector<double>;

double product(const Column& a, const Column& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

using Factors = std::array<double, 3>;
constexpr size_t kLobes = std::tuple_size_v<Factors>;

/// Normal equations of up to three lobes and the target.
struct Equations {
    double gram[kLobes][kLobes] = {}, right[kLobes] = {};

    /// Of the lobes that `set` marks; the others are 0. By Gauss's elimination; nothing if a factor would be negative.
    std::optional<Factors> solve(unsigned set) const {
        double m[kLobes][kLobes + 1] = {};
        for (size_t i = 0; i < kLobes; ++i) {
            const bool in = (set >> i & 1) != 0;
            for (size_t j = 0; j < kLobes; ++j) m[i][j] = in && (set >> j & 1) != 0 ? gram[i][j] : double(i == j);
            m[i][kLobes] = in ? right[i] : 0;
        }
        for (size_t p = 0; p < kLobes; ++p)   // symmetric and positive: needs no pivots
            for (size_t i = 0; i < kLobes; ++i) {
                if (i == p || !(m[p][p] > 0)) continue;
                const double f = m[i][p] / m[p][p];
                for (size_t j = p; j <= kLobes; ++j) m[i][j] -= f * m[p][j];
            }
        Factors out{};
        for (size_t i = 0; i < kLobes; ++i) {
            out[i] = m[i][kLobes] / m[i][i];
            if (!(out[i] >= 0) || !std::isfinite(out[i])) return std::nullopt;
        }
        return out;
    }
    /// The square error but for a constant.
    double error(const Factors& x) const {
        double sum = 0;
        for (size_t i = 0; i < kLobes; ++i) {
            sum -= 2 * x[i] * right[i];
            for (size_t j = 0; j < kLobes; ++j) sum += x[i] * x[j] * gram[i][j];
        }
        return sum;
    }
};

class Fit {
  public:
    explicit Fit(const Gloss& gloss) : gloss_(gloss) {
        const double exponent = std::max(2 / (gloss.alpha * gloss.alpha) - 2, 1.0);   // of Blinn's lobe as wide as GGX's
        for (int k = -5; k <= 3; ++k) add(blinn_, std::max(0.5, exponent * std::exp2(k)));
        for (int k = -7; k <= 4; ++k) add(phong_, std::max(0.5, exponent / 4 * std::exp2(k)));
        for (const Sample& s : all_directions()) {
            const double light = microfacet_light(gloss, s.nh, s.nl, s.nv, s.oh), mirrored = (gloss.f90 - gloss.f0) * std::pow(1 - s.oh, 5);
            const double diffuse = gloss.metal ? 0 : kDiffuse * s.nl;
            weights_.push_back(std::sqrt(s.weight) * s.nv * s.nl / (light + kPerceived));
            target_.push_back((light - mirrored * diffuse) * weights_.back());
        }
        lambert_ = column([](const Sample& s) { return s.nl; });
    }

    Lobes best() const {
        std::vector<Column> blinn, phong;
        for (const double p : blinn_) blinn.push_back(column([p](const Sample& s) { return std::pow(s.nh, p); }));
        for (const double p : phong_) phong.push_back(column([p](const Sample& s) { return std::pow(s.rl, p); }));
        Lobes out;
        double least = 0;
        for (size_t i = 0; i < blinn.size(); ++i)
            for (size_t j = 0; j < phong.size(); ++j) {
                const Equations e = equations({&blinn[i], &phong[j], &lambert_});
                for (unsigned set = 1; set < (gloss_.metal ? 8u : 4u); ++set) {
                    const auto x = e.solve(set);
                    if (!x || e.error(*x) >= least) continue;
                    least = e.error(*x);
                    out = {(*x)[0], 1 / blinn_[i], (*x)[1], phong_[j], (*x)[2]};
                }
            }
        return out;
    }

  private:
    static void add(std::vector<double>& exponents, double p) {
        if (exponents.empty() || exponents.back() != p) exponents.push_back(p);
    }
    template <class F> Column column(const F& f) const {
        Column out;
        for (const Sample& s : all_directions()) out.push_back(f(s) * weights_[out.size()]);
        return out;
    }
    Equations equations(const std::array<const Column*, kLobes>& lobes) const {
        Equations e;
        for (size_t i = 0; i < kLobes; ++i) {
            e.right[i] = product(*lobes[i], target_);
            for (size_t j = 0; j <= i; ++j) e.gram[i][j] = e.gram[j][i] = product(*lobes[i], *lobes[j]);
        }
        return e;
    }

    Gloss gloss_;
    std::vector<double> blinn_, phong_;
    Column weights_, target_, lambert_;
};

}  // namespace

double microfacet_light(const Gloss& g, double nh, double nl, double nv, double oh) {
    const double a2 = g.alpha * g.alpha, d = nh * nh * (a2 - 1) + 1;
    const double visibility = 0.5 / (nl * std::sqrt(a2 + (1 - a2) * nv * nv) + nv * std::sqrt(a2 + (1 - a2) * nl * nl));
    return (g.f0 + (g.f90 - g.f0) * std::pow(1 - oh, 5)) * a2 / (d * d) * visibility * nl;
}

const Lobes& HighlightFits::operator()(const Gloss& gloss) {
    const auto [at, added] = known_.try_emplace({gloss.alpha, gloss.f0, gloss.f90, gloss.metal});
    if (added) at->second = Fit(gloss).best();
    return at->second;
}

}  // namespace alidade::pov_export
