// SPDX-License-Identifier: Apache-2.0
/// The patterns of POV-Ray: the table of what is a number at each point of space. A pattern is one function and one row.
#pragma once

#include "core/vec.h"
#include "scene/material.h"

#include <span>
#include <string_view>
#include <vector>

namespace alidade {

/// A point from which concentric waves go out, and how dense they are.
struct WaveSource {
    Vec3 at;
    double frequency = 0;
};

/// What a pattern may ask beside the point.
struct PatternInput {
    std::vector<double> parameters;   ///< all that the row names, rounded as POV-Ray keeps them
    Turbulence turbulence;
    NoiseGenerator noise = NoiseGenerator::range_corrected;
    double frequency = 1, phase = 0;
    std::vector<WaveSource> sources;   ///< made by `prepare`

    double operator[](size_t i) const { return parameters[i]; }
    Vec3 vector(size_t i) const { return {parameters[i], parameters[i + 1], parameters[i + 2]}; }
};

struct PatternParameter {
    const char* name;
    double usual = 0;      ///< POV-Ray's default
    bool single = false;   ///< POV-Ray keeps it in single precision
};

/// What a pattern's number is taken from, where no function of the point makes it.
enum class SourceKind { none, pigment, picture, function };

struct PatternOps {
    const char* name;
    const char* doc;
    std::span<const PatternParameter> parameters;
    double (*value)(const Vec3& p, const PatternInput& in);   ///< before frequency, phase and wave; null where a pattern has no number (`average`, `facets`) or a source for it
    Wave wave = Wave::ramp;                                   ///< what it has if nothing else is asked for
    double frequency = 1;                                     ///< 0: a pattern of blocks, which knows neither frequency nor phase unless a frequency is given
    bool displaced = true;                                    ///< turbulence moves the point; if not, the pattern uses it by itself
    void (*prepare)(PatternInput& in) = nullptr;              ///< what is worth doing once
    /// The unit normal `n`, bent by a relief of its own; null where the value's slope bends it. Not a unit vector.
    Vec3 (*relief)(const Vec3& p, const Vec3& n, double amount, const PatternInput& in) = nullptr;
    SourceKind source = SourceKind::none;
    bool colored = false;                                     ///< its colours stand for a map: those of its picture
    bool embossed = false;                                    ///< it bends normals by the rise of its picture
    void (*four)(const Vec3* p, const PatternInput& in, double* out) = nullptr;   ///< `value` of four points near each other, the same bits in less time; null where there is nothing to gain
};

/// One row for each pattern.
std::span<const PatternOps> patterns();
const PatternOps* find_pattern(std::string_view name);

/// sin(2 pi v), from the fraction of v: odd, and exact in its period.
inline double cycle(double v) { return v >= 0 ? std::sin((v - std::trunc(v)) * 2 * kPi) : -std::sin((-v - std::trunc(-v)) * 2 * kPi); }

/// 0 at integers, 1 half-way.
inline double triangle(double v) {
    const double f = v - std::floor(v);
    return f >= 0.5 ? 2 * (1 - f) : 2 * f;
}

/// POV-Ray's tolerance at the planes between blocks.
inline constexpr double kBlockEpsilon = 1e-10;

namespace pattern {
/// The side of a cube around the origin that a point is nearest to: +x, +y, +z, -x, -y, -z. On an edge, the first of these.
int cube_face(const Vec3& p);

double gradient(const Vec3&, const PatternInput&);
double onion(const Vec3&, const PatternInput&);
double leopard(const Vec3&, const PatternInput&);
double radial(const Vec3&, const PatternInput&);
double planar(const Vec3&, const PatternInput&);
double boxed(const Vec3&, const PatternInput&);
double cylindrical(const Vec3&, const PatternInput&);
double spherical(const Vec3&, const PatternInput&);
double quilted(const Vec3&, const PatternInput&);
/// From the centre of the unit cube of quilted, its length bent by the two controls.
Vec3 quilt(const Vec3&, const PatternInput&);

double checker(const Vec3&, const PatternInput&);
double hexagon(const Vec3&, const PatternInput&);
double brick(const Vec3&, const PatternInput&);
double cubic(const Vec3&, const PatternInput&);
double square(const Vec3&, const PatternInput&);
double triangular(const Vec3&, const PatternInput&);
double cells(const Vec3&, const PatternInput&);

double plain_noise(const Vec3&, const PatternInput&);
double dents(const Vec3&, const PatternInput&);
double granite(const Vec3&, const PatternInput&);
double wrinkles(const Vec3&, const PatternInput&);
double agate(const Vec3&, const PatternInput&);
double marble(const Vec3&, const PatternInput&);
double wood(const Vec3&, const PatternInput&);
double spiral1(const Vec3&, const PatternInput&);
double spiral2(const Vec3&, const PatternInput&);
double crackle(const Vec3&, const PatternInput&);
void four_noises(const Vec3* p, const PatternInput&, double* out);
void four_granites(const Vec3* p, const PatternInput&, double* out);
void four_crackles(const Vec3* p, const PatternInput&, double* out);
/// The point of crackle's that is nearest.
Vec3 nearest_point(const Vec3&, double metric);

void wave_sources(PatternInput&);
double ripples(const Vec3&, const PatternInput&);
double waves(const Vec3&, const PatternInput&);

double mandel(const Vec3&, const PatternInput&);
double julia(const Vec3&, const PatternInput&);
double magnet_mandel(const Vec3&, const PatternInput&);
double magnet_julia(const Vec3&, const PatternInput&);

Vec3 bumps_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in);
Vec3 dents_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in);
Vec3 wrinkles_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in);
Vec3 quilted_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in);
Vec3 ripples_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in);
Vec3 waves_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in);
Vec3 facets_relief(const Vec3& p, const Vec3& n, double amount, const PatternInput& in);
}  // namespace pattern

}  // namespace alidade
