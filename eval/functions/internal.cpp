// SPDX-License-Identifier: Apache-2.0
/// Source   the parameters' names in functions.inc; formulas by experiments with POV-Ray 3.7, held by internal_functions_test.
#include "eval/functions/internal.h"

#include "eval/noise/noise.h"

#include <algorithm>
#include <cmath>

namespace alidade {

namespace {

using Arguments = std::span<const double>;

/// Octaves beyond these are not added up: nobody can tell, and the number is the scene's choice.
constexpr double kMostOctaves = 1000;

/// By the lowest two bits of the number; 0 is the first generator, whatever the scene's own is.
double noise_of(const Vec3& p, double generator) {
    const int n = (std::abs(generator) < 1e9 ? int(generator) : 0) & 3;
    return noise(p, NoiseGenerator(std::max(n, 1)));
}

double ellipsoid(const Vec3& p, Arguments a, NoiseGenerator) { return length(p * Vec3(a[0], a[1], a[2])); }
double r(const Vec3& p, Arguments, NoiseGenerator) { return length(p); }
double theta(const Vec3& p, Arguments, NoiseGenerator) { return std::atan2(p.x, p.z); }
double phi(const Vec3& p, Arguments, NoiseGenerator) { return std::atan2(std::hypot(p.x, p.z), p.y); }
double sphere(const Vec3& p, Arguments a, NoiseGenerator) { return length(p) - a[0]; }
double torus(const Vec3& p, Arguments a, NoiseGenerator) { return std::hypot(std::hypot(p.x, p.z) - a[0], p.y) - a[1]; }

/// Radius of the edges, half the sizes.
double rounded_box(const Vec3& p, Arguments a, NoiseGenerator) {
    const Vec3 beyond = glm::max(glm::abs(p) - (Vec3(a[1], a[2], a[3]) - a[0]), Vec3(0));
    return length(beyond) - a[0] - 1e-6;
}

double superellipsoid(const Vec3& p, Arguments a, NoiseGenerator) {
    const double e = a[0], n = a[1];
    const double round = std::pow(std::pow(std::abs(p.x), 2 / e) + std::pow(std::abs(p.y), 2 / e), e / n) + std::pow(std::abs(p.z), 2 / n);
    return 1 - std::pow(round, n / 2);
}

double noise3d(const Vec3& p, Arguments, NoiseGenerator usual) { return noise(p, usual); }
double noise_generator(const Vec3& p, Arguments a, NoiseGenerator) { return noise_of(p, a[0]); }

/// H, lacunarity, octaves, offset, gain, generator: each octave is weighted by the one before. (POV-Ray calculates the weights by frequency in its first call alone, and takes them in all others.)
double ridged_mf(const Vec3& start, Arguments a, NoiseGenerator) {
    const double h = a[0], lacunarity = a[1], octaves = std::min(a[2], kMostOctaves), offset = a[3], gain = a[4];
    Vec3 p = start;
    const auto ridge = [&] {
        const double x = offset - std::abs(2 * noise_of(p, a[5]) - 1);
        return x * x;
    };
    double signal = ridge(), sum = signal;
    for (int i = 1; i < octaves; ++i) {
        p *= lacunarity;
        signal = std::clamp(signal * gain, 0.0, 1.0) * ridge();
        sum += signal * std::pow(lacunarity, -h * i);
    }
    return sum;
}

/// H, lacunarity, octaves, offset, T, generator: each octave is weighted by what was added up before, T times.
double hetero_mf(const Vec3& start, Arguments a, NoiseGenerator) {
    const double h = a[0], lacunarity = a[1], octaves = std::min(a[2], kMostOctaves), offset = a[3];
    const int times = a[4] > 0 ? int(std::min(a[4], kMostOctaves)) : 0;   // none if it is no number
    Vec3 p = start;
    const auto height = [&](int i) { return ((2 * noise_of(p, a[5]) - 1) + offset) * std::pow(lacunarity, -h * i); };
    double sum = height(0);
    int i = 1;
    for (; i < octaves; ++i) {
        p *= lacunarity;
        double more = height(i);
        for (int k = 0; k < times; ++k) more *= sum;
        sum += more;
    }
    const double rest = octaves - std::floor(octaves);
    if (!(rest > 0)) return sum;
    p *= lacunarity;
    return sum + rest * height(i) * sum;
}

/// Lambda, octaves, omega, offset, ridge, generator. The first octave always counts.
double ridge(const Vec3& start, Arguments a, NoiseGenerator) {
    const double lambda = a[0], octaves = std::min(a[1], kMostOctaves), omega = a[2], offset = a[3], crest = a[4];
    Vec3 p = start;
    double weight = 1, sum = 0, weights = 0;
    const auto add = [&](double part) {
        const double v = std::abs(noise_of(p, a[5]) - crest) / std::max(crest, 1 - crest);
        sum += part * (v - offset) / std::max(offset, 1 - offset);
        weights += part;
        p *= lambda, weight *= omega;
    };
    add(1);
    for (int i = 1; i < std::floor(octaves); ++i) add(weight);
    if (const double rest = octaves - std::floor(octaves); rest > 0) add(rest * weight);
    return sum / weights;
}

constexpr InternalFunction kInternalFunctions[] = {
    {17, "f_ellipsoid", 3, ellipsoid}, {29, "f_hetero_mf", 6, hetero_mf}, {47, "f_ph", 0, phi}, {57, "f_r", 0, r}, {58, "f_ridge", 6, ridge}, {59, "f_ridged_mf", 6, ridged_mf},
    {60, "f_rounded_box", 4, rounded_box}, {61, "f_sphere", 1, sphere}, {68, "f_superellipsoid", 2, superellipsoid}, {69, "f_th", 0, theta}, {70, "f_torus", 2, torus},
    {76, "f_noise3d", 0, noise3d}, {78, "f_noise_generator", 1, noise_generator},
};

/// By number. POV-Ray takes number 77, too, which its includes give no name.
constexpr std::string_view kNames[] = {
    "f_algbr_cyl1", "f_algbr_cyl2", "f_algbr_cyl3", "f_algbr_cyl4", "f_bicorn", "f_bifolia", "f_blob", "f_blob2", "f_boy_surface", "f_comma", "f_cross_ellipsoids",
    "f_crossed_trough", "f_cubic_saddle", "f_cushion", "f_devils_curve", "f_devils_curve_2d", "f_dupin_cyclid", "f_ellipsoid", "f_enneper", "f_flange_cover",
    "f_folium_surface", "f_folium_surface_2d", "f_glob", "f_heart", "f_helical_torus", "f_helix1", "f_helix2", "f_hex_x", "f_hex_y", "f_hetero_mf", "f_hunt_surface",
    "f_hyperbolic_torus", "f_isect_ellipsoids", "f_kampyle_of_eudoxus", "f_kampyle_of_eudoxus_2d", "f_klein_bottle", "f_kummer_surface_v1", "f_kummer_surface_v2",
    "f_lemniscate_of_gerono", "f_lemniscate_of_gerono_2d", "f_mesh1", "f_mitre", "f_nodal_cubic", "f_odd", "f_ovals_of_cassini", "f_paraboloid", "f_parabolic_torus",
    "f_ph", "f_pillow", "f_piriform", "f_piriform_2d", "f_poly4", "f_polytubes", "f_quantum", "f_quartic_paraboloid", "f_quartic_saddle", "f_quartic_cylinder", "f_r",
    "f_ridge", "f_ridged_mf", "f_rounded_box", "f_sphere", "f_spikes", "f_spikes_2d", "f_spiral", "f_steiners_roman", "f_strophoid", "f_strophoid_2d", "f_superellipsoid",
    "f_th", "f_torus", "f_torus2", "f_torus_gumdrop", "f_umbrella", "f_witch_of_agnesi", "f_witch_of_agnesi_2d", "f_noise3d", "a function without a name", "f_noise_generator",
};

}  // namespace

std::string_view internal_function_name(double number) {
    const bool is_one = number >= 0 && number < double(std::size(kNames)) && number == std::floor(number);
    return is_one ? kNames[size_t(number)] : "";
}

std::span<const InternalFunction> internal_functions() { return kInternalFunctions; }

const InternalFunction* find_internal_function(double number) {
    for (const InternalFunction& row : kInternalFunctions)
        if (row.number == number) return &row;
    return nullptr;
}

}  // namespace alidade
