// SPDX-License-Identifier: Apache-2.0
/// Patterns of distances and angles.
/// Source   POV-Ray 3.7 user documentation, 3.4.7.1 "General Patterns"; what it leaves open by experiment
#include "eval/patterns/registry.h"

namespace alidade::pattern {

namespace {

double below_one(double v) { return v > 1 ? std::fmod(v, 1.0) : v; }
double fading(double distance) { return distance > 1 ? 0 : 1 - distance; }

/// POV-Ray's floor: a negative integer goes down as well.
double cell_floor(double x) { return x >= 0 ? std::floor(x) : -std::floor(-x) - 1; }

}  // namespace

double gradient(const Vec3& p, const PatternInput& in) { return below_one(dot(p, normalized(in.vector(0)))); }
double onion(const Vec3& p, const PatternInput&) { return std::fmod(length(p), 1.0); }

double leopard(const Vec3& p, const PatternInput&) {
    const double mean = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3;
    return mean * mean;
}

double radial(const Vec3& p, const PatternInput&) {
    if (std::abs(p.x) < 0.001 && std::abs(p.z) < 0.001) return 0.25;
    return 0.25 + (std::atan2(p.x, p.z) + kPi) / (2 * kPi);
}

double planar(const Vec3& p, const PatternInput&) { return fading(std::abs(p.y)); }
double boxed(const Vec3& p, const PatternInput&) { return fading(max_abs(p)); }
double cylindrical(const Vec3& p, const PatternInput&) { return fading(std::hypot(p.x, p.z)); }
double spherical(const Vec3& p, const PatternInput&) { return fading(length(p)); }

Vec3 quilt(const Vec3& p, const PatternInput& in) {
    const Vec3 v(p.x - cell_floor(p.x) - 0.5, p.y - cell_floor(p.y) - 0.5, p.z - cell_floor(p.z) - 0.5);
    const double t = length(v), s = 1 - t;
    const double k = (t * t * t + 3 * t * s * s * in[0] + 3 * t * t * s * in[1]) * 1.154700538;   // a Bezier curve; 2 / sqrt(3)
    return v * k;
}

double quilted(const Vec3& p, const PatternInput& in) {
    const Vec3 v = quilt(p, in);
    return (std::abs(v.x) + std::abs(v.y) + std::abs(v.z)) / 3;
}

}  // namespace alidade::pattern
