// SPDX-License-Identifier: Apache-2.0
/// Patterns made of noise.
/// Source   POV-Ray 3.7 user documentation, 3.4.7.1 "General Patterns"; what it leaves open by experiment
#include "eval/noise/noises.h"
#include "eval/patterns/registry.h"

namespace alidade::pattern {

namespace {

bool is_turbulent(const PatternInput& in) { return in.turbulence.amount != Vec3(0); }

/// How far around the z axis a point is, in turns.
double turns(const Vec3& p, double radius) {
    if (radius == 0) return 0;
    const double angle = p.x < 0 ? 1.5 * kPi - std::asin(p.y / radius) : 0.5 * kPi + std::asin(p.y / radius);
    return angle / (2 * kPi);
}

double wound(const Vec3& p, double radius, const PatternInput& in) {
    const double moved = is_turbulent(in) ? in.turbulence.amount.x * turbulence(p, in.turbulence, in.noise) : 0;
    return p.z + radius + in[0] * turns(p, radius) + moved;
}

/// The noises of a point, and of that times 2, 4, 8, ...
template <int kCount> void doubled(const Vec3& p, NoiseGenerator generator, double (&out)[kCount]) {
    for (int first = 0; first < kCount; first += 4) {
        const int count = std::min(4, kCount - first);
        Vec3 places[4];
        for (int i = 0; i < count; ++i) places[i] = p * double(1 << (first + i));
        noises(places, count, generator, out + first);
    }
}

constexpr int kGraniteOctaves = 6;

/// What granite makes of its octaves.
double granite_of(const double* n, NoiseGenerator generator) {
    double sum = 0, frequency = 1;
    for (int k = 0; k < kGraniteOctaves; ++k, frequency *= 2) {
        const double folded = generator == NoiseGenerator::original ? std::abs(0.5 - n[k]) : std::min(0.5, std::abs(1 - 2 * n[k]));
        sum += folded / frequency;
    }
    return sum;
}

}  // namespace

double plain_noise(const Vec3& p, const PatternInput& in) { return noise(p, in.noise); }

double dents(const Vec3& p, const PatternInput& in) {
    const double n = noise(p, in.noise);
    return n * n * n;
}

void four_noises(const Vec3* p, const PatternInput& in, double* out) { noises(p, 4, in.noise, out); }

double granite(const Vec3& p, const PatternInput& in) {
    double n[kGraniteOctaves];
    doubled(p * 4.0, in.noise, n);
    return granite_of(n, in.noise);
}

void four_granites(const Vec3* p, const PatternInput& in, double* out) {
    double n[4][kGraniteOctaves];
    for (int k = 0; k < kGraniteOctaves; ++k) {
        Vec3 places[4];
        double octave[4];
        for (int i = 0; i < 4; ++i) places[i] = p[i] * 4.0 * double(1 << k);
        noises(places, 4, in.noise, octave);
        for (int i = 0; i < 4; ++i) n[i][k] = octave[i];
    }
    for (int i = 0; i < 4; ++i) out[i] = granite_of(n[i], in.noise);
}

double wrinkles(const Vec3& p, const PatternInput& in) {
    double n[10], sum = 0, frequency = 1;
    doubled(p, in.noise, n);
    for (int k = 0; k < 10; ++k, frequency *= 2) sum += (in.noise == NoiseGenerator::original ? n[k] : std::clamp(2 * n[k] - 0.5, 0.0, 1.0)) / frequency;
    return sum / 2;
}

double agate(const Vec3& p, const PatternInput& in) {
    const double band = 0.5 * (cycle(1.3 * in[0] * turbulence(p, in.turbulence, in.noise) + 1.1 * p.z) + 1);
    return std::pow(std::clamp(band, 0.0, 1.0), 0.77);
}

double marble(const Vec3& p, const PatternInput& in) {
    return is_turbulent(in) ? p.x + in.turbulence.amount.x * turbulence(p, in.turbulence, in.noise) : p.x;
}

double wood(const Vec3& p, const PatternInput& in) {
    if (!is_turbulent(in)) return std::hypot(p.x, p.y);
    const Vec3 t = vector_turbulence(p, in.turbulence), amount = in.turbulence.amount;
    return std::hypot(p.x + cycle((p.x + t.x) * amount.x), p.y + cycle((p.y + t.y) * amount.y));
}

double spiral1(const Vec3& p, const PatternInput& in) { return wound(p, std::hypot(p.x, p.y), in); }

double spiral2(const Vec3& p, const PatternInput& in) {
    const double radius = std::hypot(p.x, p.y);
    return triangle(radius) + triangle(wound(p, radius, in));
}

}  // namespace alidade::pattern
