// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/spot_rim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace alidade::pov_export {

namespace {

/// A part whose rim is 3u^2 - 2u^3 of the ramp from x = `begin` to x = `end`.
struct FittedPart {
    double share, begin, end;
};
/// Together they are nearest to KHR_lights_punctual's rim, which is x^2 and ends with a kink at x = 1: no more than 0.027 of the light is too much or too little.
/// (The best of one part is off by 0.061, that of three by 0.017.)
constexpr std::array<FittedPart, 2> kRim{{{0.65445, 0.1088, 1.0480}, {0.34555, 0.6530, 1.0623}}};
/// No cosine is above 1: where the ramp ends at the axis, or nearly, the parts end with it, and it takes three. Off by 0.031.
/// (The best of two is off by 0.037, but dark where the rim begins: three times the FLIP.)
constexpr std::array<FittedPart, 3> kRimToAxis{{{0.4509, 0.00575, 1}, {0.33878, 0.42365, 1}, {0.21032, 0.86088, 1}}};
constexpr std::array<FittedPart, 1> kNarrowRim{{{1, 0.2045, 1.1407}}};

/// Of the cosines: glTF's least ramp.
constexpr double kNarrowest = 1e-3;

/// The most by which the parts together differ from x^2.
double most_off(std::span<const FittedPart> parts) {
    constexpr int kSteps = 500;
    double most = 0;
    for (int i = 0; i <= kSteps; ++i) {
        const double x = double(i) / kSteps;
        double sum = 0;
        for (const FittedPart& part : parts) {
            const double u = std::clamp((x - part.begin) / (part.end - part.begin), 0.0, 1.0);
            sum += part.share * u * u * (3 - 2 * u);
        }
        most = std::max(most, std::abs(sum - x * x));
    }
    return most;
}

SpotRim fitted(std::span<const FittedPart> parts, double outer, double ramp, double light) {
    SpotRim rim;
    const auto angle = [&](double x) { return std::acos(std::clamp(outer + x * ramp, -1.0, 1.0)); };
    for (const FittedPart& part : parts) rim.parts.push_back({part.share * light, angle(part.end), angle(part.begin)});
    rim.off = most_off(parts) * light;
    return rim;
}

SpotRim fitted(double outer, double width) {
    const double ramp = std::max(kNarrowest, width), axis = (1 - outer) / ramp;   // where the ramp is cut off
    if (width <= kNarrowest && axis >= kNarrowRim[0].end) return fitted(kNarrowRim, outer, ramp, 1);
    if (axis >= kRim[1].end) return fitted(kRim, outer, ramp, 1);
    const double reached = std::min(axis, 1.0);
    return fitted(kRimToAxis, outer, ramp * reached, reached * reached);   // a part of a parabola is one
}

/// Six floats, each as great as the coefficients, are rounded, scaled and added: 4e-7 of them is twice what probing POV-Ray finds.
SpotRim exact(const SpotLight& spot, double outer, double ramp) {
    SpotRim rim;
    const double a = 1 / (ramp * ramp), b = -2 * outer * a, c = outer * outer * a;
    const double angle = spot.outer_angle, inner = spot.inner_angle;
    rim.parts = {{a, angle, angle, 2}, {b, angle, angle, 1}, {c, angle, angle, 0}};
    if (inner > 0) rim.parts.insert(rim.parts.end(), {{-a, inner, inner, 2}, {-b, inner, inner, 1}, {1 - c, inner, inner, 0}});
    rim.off = 4e-7 * a;
    return rim;
}

}  // namespace

SpotRim spot_rim(const SpotLight& spot) {
    const double outer = std::cos(spot.outer_angle), width = std::cos(spot.inner_angle) - outer;
    SpotRim fit = fitted(outer, width);
    if (width <= kNarrowest || spot.outer_angle > kPi / 2) return fit;   // a cone of POV-Ray's ends at a half space
    SpotRim sum = exact(spot, outer, width);
    return sum.off < fit.off ? sum : fit;
}

}  // namespace alidade::pov_export
