// SPDX-License-Identifier: Apache-2.0
#include "eval/patterns/relief.h"

#include "eval/noise/single.h"
#include "eval/patterns/picture.h"

namespace alidade {

namespace {

/// Normals nearer to the y axis than this count as vertical.
constexpr double kFlat = 1e-10;

}  // namespace

double height_at(std::span<const SlopeEntry> slopes, double value) {
    const MapBlend at = look_up<SlopeEntry>(slopes, value);
    const SlopeEntry &a = slopes[at.low], &b = slopes[at.high];
    if (!(at.t > 0)) return a.height;
    const double t = at.t, rise = a.height - b.height;
    return ((t * (a.slope + b.slope + 2 * rise) - (2 * a.slope + b.slope + 3 * rise)) * t + a.slope) * t + a.height;
}

tl::expected<Relief, std::string> Relief::make(const ReliefSignal& signal, PatternSource source) {
    auto pattern = Pattern::make(signal.pattern, std::move(source));
    if (!pattern) return tl::unexpected(pattern.error());
    Relief out;
    out.pattern_ = std::move(*pattern);
    out.amount_ = single(signal.amount);
    out.accuracy_ = single(signal.accuracy);
    out.scaled_ = signal.scaled;
    out.slopes_ = signal.slopes;
    return out;
}

/// To the right and up as bump_map has it, for a unit normal; where that is vertical, as if it leaned towards -z.
Vec3 Relief::embossed(const Vec3& place, const Vec3& n) const {
    const double across = std::hypot(n.x, n.z);
    const Vec3 right = across > kFlat ? Vec3(n.z, 0, -n.x) / across : Vec3(-1, 0, 0);
    const Vec2 rise = pattern_.picture()->rise(place);
    return n + amount_ * (rise.x * right + rise.y * cross(right, n));
}

/// A pattern with a relief of its own has no height: slopes do not count, as in POV-Ray.
Vec3 Relief::bent(const Vec3& place, const Vec3& n) const {
    if (pattern_.is_bump_map()) return embossed(place, n);
    if (pattern_.row().relief) return pattern_.relief(place, n, amount_);
    static constexpr Vec3 kTowards[] = {{0.942809041, -0.333333333, 0}, {-0.471404521, -0.333333333, 0.816496581}, {-0.471404521, -0.333333333, -0.816496581}, {0, 1, 0}};
    const double k = -5 * amount_ * (0.02 / accuracy_);
    Vec3 places[4], out = n;
    double heights[4];
    for (int i = 0; i < 4; ++i) places[i] = place + accuracy_ * kTowards[i];
    pattern_.values_at(places, heights);
    for (int i = 0; i < 4; ++i) out += kTowards[i] * (k * (slopes_.empty() ? heights[i] : height_at(slopes_, heights[i])));
    return out;
}

}  // namespace alidade
