// SPDX-License-Identifier: Apache-2.0
/// Patterns that bend a normal by a formula of their own.
/// Source   POV-Ray 3.7 user documentation, 3.4.6.4 "Normal"; what it leaves open by experiment
#include "eval/noise/noise.h"
#include "eval/patterns/registry.h"

namespace alidade::pattern {

Vec3 bumps_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput&) { return n + amount * vector_noise(p); }

Vec3 dents_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in) {
    const double k = noise(p, in.noise);
    return n + (amount * k * k * k) * vector_noise(p);
}

Vec3 wrinkles_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput&) {
    Vec3 sum(0);
    double frequency = 1;
    for (int i = 0; i < 10; ++i, frequency *= 2) sum += glm::abs(vector_noise(p * frequency)) / frequency;
    return n + amount * sum;
}

Vec3 quilted_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in) { return n + amount * quilt(p, in); }

Vec3 ripples_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in) {
    Vec3 sum(0);
    for (const WaveSource& source : in.sources) {
        const Vec3 from = p - source.at;
        const double distance = length(from);
        if (distance > 0) sum += from * (cycle(distance * in.frequency + in.phase) / distance);
    }
    return n + sum * (amount / double(in.sources.size()));
}

Vec3 waves_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in) {
    Vec3 sum(0);
    for (const WaveSource& source : in.sources) {
        const Vec3 from = p - source.at;
        const double distance = length(from);
        if (distance > 0) sum += from * (cycle(distance * in.frequency * source.frequency + in.phase) / (distance * source.frequency));
    }
    return n + sum * (amount / double(in.sources.size()));
}

/// With `coords` the facets are the cells of crackle, else patches of the sphere of normals. The depth does not matter.
Vec3 facets_relief(const Vec3& p, const Vec3& n, double, const PatternInput& in) {
    const double coords = in[0], size = in[1], metric = in[2];
    if (coords == 0) return nearest_point(n / size, metric);
    const Vec3 d = vector_noise(nearest_point(p / size, metric));
    return n + coords * (d - n * dot(n, d));
}

}  // namespace alidade::pattern
