// SPDX-License-Identifier: Apache-2.0
#include "tools/metrics/flip_filters.h"

#include <cmath>

namespace alidade {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// A weight below this share of the centre's is lost in float sums.
constexpr double kNothing = 1e-9;

/// Contrast sensitivity as a sum of Gaussians, in degrees of the visual field: sum of a * sqrt(pi / b) * exp(-(pi x)^2 / b) (equation 3, table 1).
struct Sensitivity {
    double a, b;
};
constexpr Sensitivity kAchromatic{1, 0.0047}, kRedGreen{1, 0.0053}, kBlueYellow[2] = {{34.1, 0.04}, {13.5, 0.025}};
/// Width of the edge and point detectors, in degrees; a standard deviation is half of it (section 4.2).
constexpr double kDetectorWidth = 0.082;

std::vector<double> gaussian(double b, size_t radius, double pixels_per_degree) {
    std::vector<double> half;
    for (size_t i = 0; i <= radius; ++i) half.push_back(std::exp(-kPi * kPi / b * std::pow(double(i) / pixels_per_degree, 2)));
    return half;
}

double both_sides(const std::vector<double>& half) {
    double sum = half[0];
    for (size_t i = 1; i < half.size(); ++i) sum += 2 * half[i];
    return sum;
}

HalfKernel scaled(const std::vector<double>& half, double factor) {
    HalfKernel kernel;
    for (const double weight : half) {
        if (std::abs(weight) < kNothing * std::abs(half[0])) break;
        kernel.push_back(float(weight * factor));
    }
    return kernel;
}

HalfKernel normalized_gaussian(const Sensitivity& s, size_t radius, double pixels_per_degree) {
    const auto half = gaussian(s.b, radius, pixels_per_degree);
    return scaled(half, 1 / both_sides(half));
}

void add_color_filters(FlipFilters& filters, double pixels_per_degree) {
    // Three standard deviations of the widest Gaussian, for all of them.
    filters.radius = size_t(std::ceil(3 * std::sqrt(kBlueYellow[0].b / (2 * kPi * kPi)) * pixels_per_degree));
    filters.achromatic = normalized_gaussian(kAchromatic, filters.radius, pixels_per_degree);
    filters.red_green = normalized_gaussian(kRedGreen, filters.radius, pixels_per_degree);
    std::vector<double> half[2];
    double height[2], total = 0;
    for (size_t i = 0; i < 2; ++i) {
        half[i] = gaussian(kBlueYellow[i].b, filters.radius, pixels_per_degree);
        height[i] = kBlueYellow[i].a * std::sqrt(kPi / kBlueYellow[i].b);
        total += height[i] * std::pow(both_sides(half[i]), 2);
    }
    // A 2D Gaussian is the product of two 1D ones: each of them takes the square root of its share of the height.
    for (size_t i = 0; i < 2; ++i) filters.blue_yellow[i] = scaled(half[i], std::sqrt(height[i] / total));
}

/// Each side of zero sums to 1. The 2D detector is a product with `smooth`, which is positive: so its sides do too.
HalfKernel point_kernel(const std::vector<double>& smooth, double deviation) {
    double positive = 0, negative = 0;
    std::vector<double> weights;
    for (size_t i = 0; i < smooth.size(); ++i) {
        weights.push_back((std::pow(double(i) / deviation, 2) - 1) * smooth[i]);
        (weights[i] > 0 ? positive : negative) += (i ? 2 : 1) * std::abs(weights[i]);
    }
    HalfKernel kernel;
    for (const double weight : weights) {
        const double side = weight > 0 ? positive : negative;
        kernel.push_back(side > 0 ? float(weight / side) : 0.0f);
    }
    return kernel;
}

HalfKernel edge_kernel(const std::vector<double>& smooth) {
    double sum = 0;
    for (size_t i = 0; i < smooth.size(); ++i) sum += double(i) * smooth[i];
    HalfKernel kernel;
    for (size_t i = 0; i < smooth.size(); ++i) kernel.push_back(sum > 0 ? float(double(i) * smooth[i] / sum) : 0.0f);
    return kernel;
}

void add_detectors(FlipFilters& filters, double pixels_per_degree) {
    const double deviation = 0.5 * kDetectorWidth * pixels_per_degree;
    std::vector<double> smooth;
    for (size_t i = 0; i <= size_t(std::ceil(3 * deviation)); ++i) smooth.push_back(std::exp(-0.5 * std::pow(double(i) / deviation, 2)));
    filters.smooth = scaled(smooth, 1 / both_sides(smooth));
    filters.edge = edge_kernel(smooth);
    filters.point = point_kernel(smooth, deviation);
    filters.radius = std::max(filters.radius, smooth.size() - 1);
}

}  // namespace

FlipFilters flip_filters() {
    FlipFilters filters;
    add_color_filters(filters, kPixelsPerDegree);
    add_detectors(filters, kPixelsPerDegree);
    return filters;
}

}  // namespace alidade
