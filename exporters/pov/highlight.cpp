// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/highlight.h"

#include "core/vec.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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

enum class Kind { blinn, phong, lambert };

/// A lobe of factor 1 at all directions, weighted.
struct Column {
    Kind kind;
    double exponent;
    std::vector<double> values;
};

double product(const std::vector<double>& a, const std::vector<double>& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

/// Columns with their factors, and how much of the square error they take away.
struct Choice {
    std::vector<size_t> columns;
    std::vector<double> factors;
    double gain = 0;
};

class Fit {
  public:
    explicit Fit(const Gloss& gloss) : gloss_(gloss) {
        std::vector<double> weights;
        for (const Sample& s : all_directions()) {
            const double light = microfacet_light(gloss, s.nh, s.nl, s.nv, s.oh), mirrored = (gloss.f90 - gloss.f0) * std::pow(1 - s.oh, 5);
            const double diffuse = gloss.metal ? 0 : kDiffuse * s.nl;
            weights.push_back(std::sqrt(s.weight) * s.nv * s.nl / (light + kPerceived));
            target_.push_back((light - mirrored * diffuse) * weights.back());
        }
        add_columns(weights);
        for (const Column& c : columns_) {
            right_.push_back(product(c.values, target_));
            for (const Column& d : columns_) gram_.push_back(&d > &c ? 0 : product(c.values, d.values));
        }
    }

    Lobes best() const {
        constexpr double kWorth = 0.9;
        const Choice few = best_of_each();
        if (!gloss_.layers) return lobes(few);
        const Choice more = with_seconds(few);
        const double all = product(target_, target_);
        return lobes(all - more.gain < kWorth * kWorth * (all - few.gain) ? more : few);
    }

  private:
    void add_columns(const std::vector<double>& weights) {
        const double exponent = std::max(2 / (gloss_.alpha * gloss_.alpha) - 2, 1.0);   // of Blinn's lobe as wide as GGX's
        for (int k = -12; k <= 6; ++k) add(Kind::blinn, exponent * std::exp2(0.5 * k), weights, &Sample::nh);
        for (int k = -14; k <= 8; ++k) add(Kind::phong, exponent / 4 * std::exp2(0.5 * k), weights, &Sample::rl);
        for (const double p : {1.0, 0.5, 2.0, 4.0})
            if (p == 1 || !gloss_.metal) add(Kind::lambert, p, weights, &Sample::nl);   // a metal's is in the finish of its pigment
    }

    void add(Kind kind, double exponent, const std::vector<double>& weights, double Sample::*cosine) {
        exponent = std::max(exponent, 0.5);
        if (!columns_.empty() && columns_.back().kind == kind && columns_.back().exponent == exponent) return;
        Column out{kind, exponent, {}};
        for (const Sample& s : all_directions()) out.values.push_back(std::pow(s.*cosine, exponent) * weights[out.values.size()]);
        columns_.push_back(std::move(out));
    }

    double gram(size_t i, size_t j) const { return gram_[std::max(i, j) * columns_.size() + std::min(i, j)]; }

    /// Least squares of these columns, by Gauss's elimination; nothing if a factor would be negative.
    std::optional<Choice> solve(const std::vector<size_t>& columns) const {
        const size_t n = columns.size();
        std::vector<double> m(n * n), x(n);
        for (size_t i = 0; i < n; ++i) {
            x[i] = right_[columns[i]];
            for (size_t j = 0; j < n; ++j) m[i * n + j] = gram(columns[i], columns[j]);
        }
        for (size_t p = 0; p < n; ++p)   // symmetric and positive: needs no pivots
            for (size_t i = 0; i < n; ++i) {
                if (i == p) continue;
                const double f = m[i * n + p] / m[p * n + p];
                for (size_t j = p; j < n; ++j) m[i * n + j] -= f * m[p * n + j];
                x[i] -= f * x[p];
            }
        Choice out{columns, {}, 0};
        for (size_t i = 0; i < n; ++i) {
            out.factors.push_back(x[i] / m[i * n + i]);
            if (!(out.factors[i] >= 0) || !std::isfinite(out.factors[i])) return std::nullopt;
            out.gain += out.factors[i] * right_[columns[i]];
        }
        return out;
    }

    /// The best of all subsets whose factors are not negative.
    Choice solve_any(const std::vector<size_t>& columns) const {
        Choice best;
        for (unsigned set = 1; set < 1u << columns.size(); ++set) {
            std::vector<size_t> part;
            for (size_t i = 0; i < columns.size(); ++i)
                if ((set >> i & 1) != 0) part.push_back(columns[i]);
            if (auto choice = solve(part); choice && choice->gain > best.gain) best = std::move(*choice);
        }
        return best;
    }

    std::vector<size_t> of_kind(Kind kind) const {
        std::vector<size_t> out;
        for (size_t i = 0; i < columns_.size(); ++i)
            if (columns_[i].kind == kind) out.push_back(i);
        return out;
    }

    /// Up to one lobe of each kind, by trying all.
    Choice best_of_each() const {
        Choice best;
        const auto take = [&](const std::vector<size_t>& columns) {
            if (Choice choice = solve_any(columns); choice.gain > best.gain) best = std::move(choice);
        };
        const bool with_lambert = gloss_.metal || gloss_.layers;
        const std::vector<size_t> lambert = of_kind(Kind::lambert), phong = of_kind(Kind::phong);
        for (const size_t i : of_kind(Kind::blinn))
            for (const size_t j : phong) {
                if (!with_lambert) take({i, j});
                for (size_t k = 0; with_lambert && k < lambert.size(); ++k) take({i, j, lambert[k]});
            }
        return best;
    }

    /// Exchanges one lobe after the other, beginning with those of `few`, until nothing is gained.
    Choice with_seconds(const Choice& few) const {
        constexpr double kProgress = 1e-6;
        constexpr Kind kinds[] = {Kind::blinn, Kind::phong, Kind::blinn, Kind::phong, Kind::lambert};
        std::vector<std::optional<size_t>> slots(std::size(kinds));
        for (const size_t column : few.columns)
            slots[columns_[column].kind == Kind::lambert ? 4 : size_t(columns_[column].kind)] = column;
        Choice best = few;
        for (double before = -1; best.gain > before * (1 + kProgress);) {
            before = best.gain;
            for (const size_t slot : {2, 3, 0, 1, 4}) exchange(kinds[slot], slot, slots, best);
        }
        return best;
    }

    void exchange(Kind kind, size_t slot, std::vector<std::optional<size_t>>& slots, Choice& best) const {
        std::vector<size_t> others;
        for (size_t i = 0; i < slots.size(); ++i)
            if (i != slot && slots[i]) others.push_back(*slots[i]);
        for (const size_t i : of_kind(kind)) {
            if (std::count(others.begin(), others.end(), i) > 0) continue;
            others.push_back(i);
            if (Choice choice = solve_any(others); choice.gain > best.gain) best = std::move(choice), slots[slot] = i;
            others.pop_back();
        }
    }

    Lobes lobes(const Choice& choice) const {
        Lobes out;
        for (size_t i = 0; i < choice.columns.size(); ++i) {
            const Column& c = columns_[choice.columns[i]];
            auto& pair = c.kind == Kind::blinn ? out.blinn : out.phong;
            Lobe& lobe = c.kind == Kind::lambert ? out.lambert : pair[0].factor > 0 ? pair[1] : pair[0];
            lobe = {choice.factors[i], c.exponent};
        }
        return out;
    }

    Gloss gloss_;
    std::vector<Column> columns_;
    std::vector<double> target_, right_, gram_;
};

}  // namespace

double microfacet_light(const Gloss& g, double nh, double nl, double nv, double oh) {
    const double a2 = g.alpha * g.alpha, d = nh * nh * (a2 - 1) + 1;
    const double visibility = 0.5 / (nl * std::sqrt(a2 + (1 - a2) * nv * nv) + nv * std::sqrt(a2 + (1 - a2) * nl * nl));
    return (g.f0 + (g.f90 - g.f0) * std::pow(1 - oh, 5)) * a2 / (d * d) * visibility * nl;
}

const Lobes& HighlightFits::operator()(const Gloss& gloss) {
    const auto [at, added] = known_.try_emplace({gloss.alpha, gloss.f0, gloss.f90, gloss.metal, gloss.layers});
    if (added) at->second = Fit(gloss).best();
    return at->second;
}

}  // namespace alidade::pov_export
