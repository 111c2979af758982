// SPDX-License-Identifier: Apache-2.0
#include "eval/patterns/warps.h"

#include "eval/noise/hash.h"
#include "eval/noise/noise.h"
#include "eval/noise/single.h"
#include "eval/patterns/registry.h"

#include <fmt/format.h>

namespace alidade {

namespace {

using Parameters = std::array<double, 14>;

Vec3 vector(const Parameters& p, size_t at) { return {p[at], p[at + 1], p[at + 2]}; }

/// How many parameters a kind has, and what POV-Ray has for those that are left out.
struct Usual {
    size_t count;
    Parameters values;
};

Usual usual(WarpKind kind) {
    switch (kind) {
        case WarpKind::turbulence: return {6, {0, 0, 0, 6, 0.5, 2}};
        case WarpKind::black_hole: return {13, {0, 0, 0, 1, 1, 2}};
        case WarpKind::repeat: return {9, {}};
        case WarpKind::planar: return {4, {0, 0, 1, 0}};
        case WarpKind::cylindrical:
        case WarpKind::spherical: return {4, {0, 0, 1, 0}};
        case WarpKind::toroidal: return {5, {0, 0, 1, 0, 1}};
        case WarpKind::transform:
        case WarpKind::cubic: break;
    }
    return {0, {}};
}

Vec3 turbulent(const Parameters& w, const Vec3& p) { return p + vector(w, 0) * vector_turbulence(p, {Vec3(0), int(w[3]), w[4], w[5]}); }

/// The centre of the black hole in whose block the point is.
Vec3 centre_near(const Parameters& w, const Vec3& p) {
    Vec3 centre = vector(w, 0);
    const Vec3 repeat = vector(w, 7), turbulence = vector(w, 10);
    if (repeat == Vec3(0)) return centre;
    Vec3 block(0);
    for (int k = 0; k < 3; ++k)
        if (repeat[k] > 0) block[k] = std::floor(p[k] / repeat[k]);
    centre += block * repeat;
    if (turbulence == Vec3(0)) return centre;
    const unsigned h = cell_hash(truncated(block.x), truncated(block.y), truncated(block.z));
    return centre + turbulence * Vec3(cell_random(h), cell_random(h + 1), cell_random(h + 2));
}

/// Blocks that black holes repeat in hold them whole, wherever turbulence puts them: POV-Ray moves the centre up and makes the block larger for it.
void make_room(Parameters& w) {
    for (size_t k = 0; k < 3; ++k) {
        double &centre = w[k], &repeat = w[7 + k];
        if (repeat <= 0) continue;
        centre = std::max(centre, w[3]);
        repeat = std::max(repeat, centre + w[3] + w[10 + k]);
    }
}

Vec3 black_hole(const Parameters& w, const Vec3& p) {
    const Vec3 away = p - centre_near(w, p);
    const double distance = length(away), radius = w[3];
    if (!(distance < radius)) return p;
    const double pull = std::min(1.0, w[4] * std::pow((radius - distance) / radius, w[5]));
    return p + away * (w[6] != 0 ? -pull : pull);
}

Vec3 repeated(const Parameters& w, Vec3 p) {
    const int axis = w[0] != 0 ? 0 : w[1] != 0 ? 1 : 2;
    const double width = w[size_t(axis)], n = std::floor(p[axis] / width);
    p[axis] -= single(n * width);   // POV-Ray's width, and this product, have single precision
    if (std::fmod(n, 2.0) != 0)
        for (int k = 0; k < 3; ++k)
            if (w[size_t(6 + k)] != 0) p[k] = k == axis ? width - p[k] : -p[k];
    return p + vector(w, 3) * n;
}

/// What a warp made along z, along another axis.
Vec3 oriented(const Vec3& o, const Vec3& v) {
    if (o == Vec3(0, 0, 1)) return v;
    return {o.x * v.z + o.y * v.x + o.z * v.x, o.x * v.y - o.y * v.z + o.z * v.y, -o.x * v.x + o.y * v.y + o.z * v.z};
}

/// The angle about the y axis from x towards z, in turns.
double turn(double x, double z) {
    const double radius = std::hypot(x, z);
    if (radius == 0) return 0;
    const double angle = std::acos(std::clamp(x / radius, -1.0, 1.0));
    return (z < 0 ? 2 * kPi - angle : angle) / (2 * kPi);
}

/// The size that a map grows by with the distance; the same everywhere if the exponent is 0.
double grown(double distance, double exponent) { return exponent == 0 ? 1 : exponent == 1 ? distance : std::pow(distance, exponent); }

Vec3 cylindrical(const Parameters& w, const Vec3& p) {
    const double radius = std::hypot(p.x, p.z);
    if (radius == 0) return p;   // as POV-Ray does, turned to no orientation
    return oriented(vector(w, 0), {turn(p.x, p.z) * grown(radius, w[3]), p.y, radius});
}

Vec3 spherical(const Parameters& w, const Vec3& p) {
    const double distance = length(p), scale = grown(distance, w[3]);
    if (distance == 0) return p;
    return oriented(vector(w, 0), {turn(p.x, p.z) * scale, (0.5 + std::asin(p.y / distance) / kPi) * scale, distance});
}

Vec3 toroidal(const Parameters& w, const Vec3& p) {
    if (p.x == 0 && p.z == 0) return p;
    const double across = std::hypot(p.x, p.z) - w[4], distance = std::hypot(across, p.y), scale = grown(distance, w[3]);
    double around = distance > 0 ? std::acos(std::clamp(-across / distance, -1.0, 1.0)) : 0;
    if (p.y > 0) around = 2 * kPi - around;
    return oriented(vector(w, 0), {turn(p.x, p.z) * scale, around / (2 * kPi) * scale, distance});
}

Vec3 planar(const Parameters& w, const Vec3& p) { return oriented(vector(w, 0), {p.x, p.y, w[3]}); }

/// As POV-Ray maps the sides of a box: a cross of six squares, four in a row. The third coordinate is the distance from the centre, as a cube measures it.
Vec3 cubic(const Vec3& p) {
    const double m = max_abs(p);
    const Vec3 s = (p / m + Vec3(1)) * 0.5;   // 0 to 1 along each edge
    switch (pattern::cube_face(p)) {
        case 0: return {0.75 - s.z / 4, (1 + s.y) / 3, m};
        case 1: return {0.25 + s.x / 4, 1 - s.z / 3, m};
        case 2: return {0.25 + s.x / 4, (1 + s.y) / 3, m};
        case 3: return {s.z / 4, (1 + s.y) / 3, m};
        case 4: return {0.25 + s.x / 4, s.z / 3, m};
        default: return {1 - s.x / 4, (1 + s.y) / 3, m};
    }
}

}  // namespace

tl::expected<PreparedWarp, std::string> prepare(const Warp& warp) {
    PreparedWarp out;
    out.kind = warp.kind;
    const Usual defaults = usual(warp.kind);
    out.parameters = defaults.values;
    if (warp.parameters.size() > defaults.count) return tl::unexpected(fmt::format("a warp has {} parameters, more than {}", warp.parameters.size(), defaults.count));
    std::copy(warp.parameters.begin(), warp.parameters.end(), out.parameters.begin());
    if (warp.kind == WarpKind::transform) {
        const auto back = inverse(warp.transform);
        if (!back) return tl::unexpected(std::string("a pattern is flattened by its transform, which has no inverse"));
        out.inverse = *back;
    }
    if (warp.kind == WarpKind::repeat && vector(out.parameters, 0) == Vec3(0)) return tl::unexpected(std::string("a repeat warp has no width"));
    if (warp.kind == WarpKind::turbulence) out.parameters[3] = std::clamp(out.parameters[3], 1.0, 10.0);
    if (warp.kind == WarpKind::repeat)
        for (size_t k = 0; k < 3; ++k) out.parameters[k] = single(out.parameters[k]);
    if (warp.kind == WarpKind::black_hole) make_room(out.parameters);
    return out;
}

Vec3 warped(const PreparedWarp& warp, const Vec3& p) {
    switch (warp.kind) {
        case WarpKind::transform: return warp.inverse.point(p);
        case WarpKind::turbulence: return turbulent(warp.parameters, p);
        case WarpKind::black_hole: return black_hole(warp.parameters, p);
        case WarpKind::repeat: return repeated(warp.parameters, p);
        case WarpKind::planar: return planar(warp.parameters, p);
        case WarpKind::cylindrical: return cylindrical(warp.parameters, p);
        case WarpKind::spherical: return spherical(warp.parameters, p);
        case WarpKind::toroidal: return toroidal(warp.parameters, p);
        case WarpKind::cubic: break;
    }
    return cubic(p);
}

}  // namespace alidade
