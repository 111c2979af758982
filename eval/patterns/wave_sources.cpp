// SPDX-License-Identifier: Apache-2.0
/// Waves that go out from points of the unit sphere.
/// Source   POV-Ray 3.7 user documentation, 3.4.7.1.24 "Ripples Pattern" and 3.4.7.1.29 "Waves Pattern"; what they leave open by experiment
#include "eval/noise/hash.h"
#include "eval/noise/noise.h"
#include "eval/patterns/registry.h"

namespace alidade::pattern {

void wave_sources(PatternInput& in) {
    constexpr double kMost = 1000;   // each costs every evaluation
    NoiseSequence sequence(uint32_t(-560851967));
    const int count = int(std::clamp(in[0], 1.0, kMost));
    for (int i = 0; i < count; ++i) in.sources.push_back({normalized(vector_noise(Vec3(i, 0, 0))), sequence.next() * 0.000030518509476 + 0.01});
}

double ripples(const Vec3& p, const PatternInput& in) {
    double sum = 0;
    for (const WaveSource& source : in.sources) sum += cycle(length(p - source.at) * in.frequency + in.phase);
    return 0.5 * (1 + sum / double(in.sources.size()));
}

double waves(const Vec3& p, const PatternInput& in) {
    double sum = 0;
    for (const WaveSource& source : in.sources) sum += cycle(length(p - source.at) * in.frequency * source.frequency + in.phase) / source.frequency;
    return 0.2 * (2.5 + sum / double(in.sources.size()));
}

}  // namespace alidade::pattern
