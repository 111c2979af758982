// SPDX-License-Identifier: Apache-2.0
/// LDR-FLIP once more, as its paper writes it: doubles, 2D filters, no thought of time. The oracle of the fast one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace alidade::test {

using Triple = std::array<double, 3>;
constexpr double kPi = 3.14159265358979323846, kPpd = 3840 * kPi / 180;

inline Triple multiply(const std::array<Triple, 3>& m, const Triple& v) {
    Triple out{};
    for (size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return out;
}

inline constexpr std::array<Triple, 3> kRgbToXyz = {{{0.4123865632529917, 0.35759149092062537, 0.18045049120356368},
                                                     {0.21263682167732384, 0.7151829818412507, 0.07218019648142547},
                                                     {0.019330620152483987, 0.11919716364020845, 0.9503725870054354}}};
inline constexpr Triple kWhite = {0.9504285453771807, 1.0, 1.0889003707981277};

/// Cramer's rule.
inline Triple xyz_to_rgb(const Triple& v) {
    const auto det = [](const std::array<Triple, 3>& m) {
        return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    Triple rgb;
    for (size_t c = 0; c < 3; ++c) {
        auto m = kRgbToXyz;
        for (size_t r = 0; r < 3; ++r) m[r][c] = v[r];
        rgb[c] = det(m) / det(kRgbToXyz);
    }
    return rgb;
}

inline Triple to_ycc(const Triple& rgb) {
    const Triple v = multiply(kRgbToXyz, rgb);
    const double x = v[0] / kWhite[0], y = v[1], z = v[2] / kWhite[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

inline Triple from_ycc(const Triple& c) {
    const double y = (c[0] + 16) / 116, x = y + c[1] / 500, z = y - c[2] / 200;
    return xyz_to_rgb({x * kWhite[0], y, z * kWhite[2]});
}

inline Triple hunt(const Triple& rgb) {
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : t * 841 / 108 + 4.0 / 29; };
    const Triple v = multiply(kRgbToXyz, rgb);
    const double x = f(v[0] / kWhite[0]), y = f(v[1]), z = f(v[2] / kWhite[2]), l = 116 * y - 16;
    return {l, 0.01 * l * 500 * (x - y), 0.01 * l * 200 * (y - z)};
}

/// Error of two colours in places without features.
inline double color_error(const Triple& a, const Triple& b) {
    const auto hyab = [](const Triple& p, const Triple& q) { return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]); };
    const double largest = std::pow(hyab(hunt({0, 1, 0}), hunt({0, 0, 1})), 0.7), error = std::pow(hyab(hunt(a), hunt(b)), 0.7);
    return error < 0.4 * largest ? 0.95 * error / (0.4 * largest) : 0.95 + 0.05 * (error - 0.4 * largest) / (0.6 * largest);
}

/// Linear pictures of any size.
class FlipOracle {
public:
    FlipOracle(int width, int height, const std::vector<float>& a, const std::vector<float>& b) : width_(width), height_(height) {
        for (const auto* picture : {&a, &b}) {
            auto& planes = ycc_[picture == &b];
            for (size_t i = 0; i < picture->size(); i += 3) {
                planes.push_back(to_ycc({double((*picture)[i]), double((*picture)[i + 1]), double((*picture)[i + 2])}));
            }
        }
    }

    double at(int x, int y) const {
        const double color = color_error(seen(0, x, y), seen(1, x, y));
        double feature = 0;
        for (const auto kind : {edge, point}) feature = std::max(feature, std::abs(strength(0, kind, x, y) - strength(1, kind, x, y)));
        return std::pow(color, 1 - std::sqrt(feature / std::sqrt(2.0)));
    }

private:
    using Weight = std::function<double(int dx, int dy)>;

    const Triple& pixel(size_t which, int x, int y) const {
        return ycc_[which][size_t(std::clamp(y, 0, height_ - 1)) * size_t(width_) + size_t(std::clamp(x, 0, width_ - 1))];
    }
    template <class Each>
    static void window(int radius, Each each) {
        for (int dy = -radius; dy <= radius; ++dy) {
            for (int dx = -radius; dx <= radius; ++dx) each(dx, dy);
        }
    }
    /// Through the eye's contrast sensitivity, in the display's gamut.
    Triple seen(size_t which, int x, int y) const {
        constexpr double a[3][2] = {{1, 0}, {1, 0}, {34.1, 13.5}}, b[3][2] = {{0.0047, 1e-5}, {0.0053, 1e-5}, {0.04, 0.025}};
        const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * kPpd));
        Triple sum{}, total{};
        window(radius, [&](int dx, int dy) {
            const double square = (dx * dx + dy * dy) / (kPpd * kPpd);
            for (size_t c = 0; c < 3; ++c) {
                double weight = 0;
                for (size_t i = 0; i < 2; ++i) weight += a[c][i] * std::sqrt(kPi / b[c][i]) * std::exp(-kPi * kPi * square / b[c][i]);
                total[c] += weight;
                sum[c] += weight * pixel(which, x + dx, y + dy)[c];
            }
        });
        Triple rgb = from_ycc({sum[0] / total[0], sum[1] / total[1], sum[2] / total[2]});
        for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
        return rgb;
    }

    enum Kind { edge, point };
    double strength(size_t which, Kind kind, int x, int y) const {
        const double deviation = 0.5 * 0.082 * kPpd;
        const auto weight = [&](int along, int across) {
            const double g = std::exp(-(along * along + across * across) / (2 * deviation * deviation));
            return kind == edge ? -along * g : (along * along / (deviation * deviation) - 1) * g;
        };
        double response[2] = {0, 0}, positive = 0, negative = 0;
        const int radius = int(std::ceil(3 * deviation));
        window(radius, [&](int dx, int dy) { (weight(dx, dy) > 0 ? positive : negative) += std::abs(weight(dx, dy)); });
        window(radius, [&](int dx, int dy) {
            const double value = (pixel(which, x + dx, y + dy)[0] + 16) / 116, h = weight(dx, dy), v = weight(dy, dx);
            response[0] += value * h / (h > 0 ? positive : negative);
            response[1] += value * v / (v > 0 ? positive : negative);
        });
        return std::hypot(response[0], response[1]);
    }

    int width_, height_;
    std::vector<Triple> ycc_[2];
};

}  // namespace alidade::test
