// SPDX-License-Identifier: Apache-2.0
#include "stress/prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace alidade {

namespace {

constexpr double kMargin = 1.3;   // predictions are from one run on a smaller scene, on a machine that others may use

/// Of a primitive, while its structure is built: more than any of ours takes on any kind of scene (an octree in double 540).
constexpr double kUnknownBytes = 600;

/// As n log n grows.
double grown(double value, double from, double to) { return kMargin * value * to / from * std::log(to + 2) / std::log(from + 2); }

/// Of a ray: most scenes need less than the cube root.
double grown_ray(const StressPace& pace, double primitives) { return kMargin * pace.ray_seconds * std::cbrt(std::max(1.0, primitives / pace.primitives)); }

}  // namespace

std::string seconds_text(double seconds) { return seconds < 10 ? fmt::format("{:.2g} s", seconds) : fmt::format("{:.0f} s", seconds); }

std::string bytes_text(double bytes) {
    static constexpr const char* kUnits[] = {"bytes", "kB", "MB", "GB", "TB"};
    size_t unit = 0;
    for (; bytes >= 1000 && unit + 1 < std::size(kUnits); ++unit) bytes /= 1000;
    return bytes < 10 && unit > 0 ? fmt::format("{:.1f} {}", bytes, kUnits[unit]) : fmt::format("{:.0f} {}", bytes, kUnits[unit]);
}

std::string StressBudget::admit(const StressPace& pace, double primitives, size_t builds, size_t rays, size_t bytes) {
    const double needs = primitives * (pace.primitives == 0 ? kUnknownBytes : std::max(pace.peak_bytes, pace.bytes) * kMargin / pace.primitives);
    if (double(bytes) + needs > double(options_.bytes))
        return fmt::format("needs about {} while it is built, beside {}: more than {}", bytes_text(needs), bytes_text(double(bytes)), bytes_text(double(options_.bytes)));
    if (pace.primitives == 0) return {};
    const double takes = options_.clock_factor * double(builds) * grown(pace.build_seconds, pace.primitives, primitives), traces = options_.clock_factor * double(rays) * grown_ray(pace, primitives);
    if (takes + traces + reserved_ > left())
        return fmt::format("takes about {}: {} are left", seconds_text(takes + traces), seconds_text(std::max(0.0, left() - reserved_)));
    reserved_ += traces;
    return {};
}

std::string StressBudget::admit_round(const StressPace& pace, double primitives, size_t rays) const {
    const double takes = pace.primitives == 0 ? 0 : options_.clock_factor * double(rays) * grown_ray(pace, primitives);
    if (takes <= left()) return {};
    return fmt::format("takes about {}: {} are left", seconds_text(takes), seconds_text(std::max(0.0, left())));
}

StressPace pace_of(const StressPeerFigures& figures, size_t primitives) {
    if (!figures.left_out.empty() || figures.builds == 0) return {};
    StressPace pace;
    pace.primitives = double(primitives), pace.build_seconds = figures.build_seconds.median, pace.bytes = double(figures.structure.bytes);
    // Of a small structure the mark says little: pages, and what malloc keeps.
    pace.peak_bytes = std::max(2 * pace.bytes, primitives < 50000 ? 0.0 : double(figures.peak_bytes.value_or(0)));
    double seconds = 0, rays = 0;
    for (const StressRayFigures& each : figures.rays) seconds += each.seconds.median, rays += double(each.left_out.empty() ? each.count : 0);
    pace.ray_seconds = rays > 0 ? seconds / rays : 0;
    return pace;
}

double stress_work(size_t primitives, size_t peers, size_t rays, int rounds) {
    return double(peers) * (double(primitives) * std::max(1, rounds / 2) + double(rays) * rounds);
}

}  // namespace alidade
