// SPDX-License-Identifier: Apache-2.0
#include "tests/accel/stadium.h"

#include "core/draws.h"

#include <fmt/format.h>

namespace alidade::test {

using namespace numerics;

namespace {

constexpr double kLength = 200, kWidth = 150;

/// (radius, height), to be turned around z.
struct Profile {
    std::vector<std::pair<double, double>> rows;
};

struct Builder {
    std::vector<Vec3> vertices;
    std::vector<Index3> triangles;

    /// A patch of rows x columns quads over points(i, j), i in 0..rows, j in 0..columns.
    template <class F> void patch(int rows, int columns, F&& point) {
        const uint32_t first = uint32_t(vertices.size()), width = uint32_t(columns) + 1;
        for (int i = 0; i <= rows; ++i) {
            for (int j = 0; j <= columns; ++j) vertices.push_back(point(i, j));
        }
        for (uint32_t i = 0; i < uint32_t(rows); ++i) {
            for (uint32_t j = 0; j + 1 < width; ++j) {
                const uint32_t a = first + i * width + j, b = a + 1, c = a + width, d = c + 1;
                triangles.emplace_back(a, b, d), triangles.emplace_back(a, d, c);
            }
        }
    }
};

/// Straight between the points of `profile`, at s in [0, 1] of their number.
std::pair<double, double> along(const Profile& profile, double s) {
    const double at = s * double(profile.rows.size() - 1);
    const size_t i = std::min(size_t(at), profile.rows.size() - 2);
    const double f = at - double(i);
    const auto &a = profile.rows[i], &b = profile.rows[i + 1];
    return {a.first + f * (b.first - a.first), a.second + f * (b.second - a.second)};
}

/// Field and stands: steps, each a seat and a riser; at last the rim outside. Radii count half widths.
void add_shell(Builder& out, int triangles) {
    Profile profile{{{0, 0}, {0.62, 0}}};
    for (int step = 0; step < 6; ++step) {
        const double r = 0.62 + 0.06 * step, z = 1 + 5.0 * step;
        profile.rows.insert(profile.rows.end(), {{r, z}, {r + 0.06, z}});
    }
    profile.rows.insert(profile.rows.end(), {{0.98, 35}, {1, 35}, {1, 0}});
    const int rows = int(profile.rows.size()) - 1, around = std::max(4, triangles / (2 * rows));
    out.patch(rows, around, [&](int i, int j) {
        const auto [r, z] = profile.rows[size_t(i)];
        const double a = 2 * kPi * j / around;
        return Vec3(0.5 * kLength * r * std::cos(a), 0.5 * kWidth * r * std::sin(a), z);
    });
}

/// A bent tube of radius `thick` around the points center(s), s in [0, 1], of a curve in the plane y = 0.
template <class F> void add_tube(Builder& out, int rows, int columns, double thick, const Vec3& foot, double height, F&& center) {
    out.patch(rows, columns, [&](int i, int j) {
        const double s = double(i) / rows, a = 2 * kPi * j / columns;
        const Vec3 c = center(s), ahead = normalized(center(s + 1e-4) - center(s - 1e-4)), side(0, 1, 0);
        return foot + height * (c + thick * (std::cos(a) * side + std::sin(a) * cross(ahead, side)));
    });
}

void add_teapot(Builder& out, int triangles, const TeapotPlace& place) {
    static const Profile body{{{0, 0}, {0.3, 0}, {0.45, 0.1}, {0.54, 0.25}, {0.55, 0.4}, {0.5, 0.55}, {0.4, 0.68}, {0.36, 0.74}, {0.37, 0.76}, {0.3, 0.82},
                               {0.15, 0.87}, {0.05, 0.9}, {0.08, 0.94}, {0.07, 0.98}, {0, 1}}};
    const int side = std::max(8, int(std::sqrt(0.8 * triangles / 2))), tube = std::max(6, int(std::sqrt(0.1 * triangles / 2)));
    out.patch(side, side, [&](int i, int j) {
        const auto [r, z] = along(body, double(i) / side);
        const double a = 2 * kPi * j / side;
        return place.foot + place.height * Vec3(r * std::cos(a), r * std::sin(a), z);
    });
    add_tube(out, tube, tube, 0.05, place.foot, place.height, [](double s) { return Vec3(-0.5 - 0.25 * std::sin(kPi * s), 0, 0.25 + 0.4 * s); });
    add_tube(out, tube, tube, 0.06, place.foot, place.height, [](double s) { return Vec3(0.45 + 0.35 * s, 0, 0.25 + 0.5 * s * s); });
}

constexpr int kFine = 120000;

StadiumScene one_teapot(const std::string& name, int shell, const Vec3& foot, double height) {
    const TeapotPlace place{foot, height};
    return teapots_in_a_stadium(name, shell, kFine, {&place, 1});
}

StadiumScene in_the_middle() { return one_teapot("in the middle", 2000, Vec3(0.3, 0.2, 10), 0.2); }
StadiumScene on_the_grass() { return one_teapot("on the grass", 2000, Vec3(0.3, 0.2, 0), 0.2); }
StadiumScene on_the_stands() { return one_teapot("on the stands", 2000, Vec3(80.03, 1.3, 16), 0.2); }
StadiumScene coarse_shell() { return one_teapot("coarse shell", 150, Vec3(0.3, 0.2, 10), 0.2); }
StadiumScene fine_shell() { return one_teapot("fine shell", 10000, Vec3(0.3, 0.2, 10), 0.2); }
StadiumScene tiny() { return one_teapot("1e-4", 2000, Vec3(0.03, 0.02, 0.001), 0.0125); }
StadiumScene speck() { return one_teapot("1e-6", 2000, Vec3(33.33, -7.77, 0), 0.000125); }
StadiumScene speck_at_the_rim() { return one_teapot("1e-6, at the rim", 2000, Vec3(99.9, 0.1, 35), 0.000125); }

StadiumScene tea_party() {
    std::vector<TeapotPlace> places;
    Draws draws(RandomKey(17, 0, 0, 0));
    for (int i = 0; i < 12; ++i) places.push_back({draws.in_box(Vec3(-50, -40, 0), Vec3(50, 40, 20)), 0.2 * std::pow(10.0, draws.uniform(-1, 0))});
    for (int i = 0; i < 4; ++i) places.push_back({Vec3(10 + 0.5 * i, 10, 0), 0.2});   // beside each other
    return teapots_in_a_stadium("sixteen", 2000, 20000, places);
}

constexpr StadiumCase kCases[] = {
    {"in_the_middle", in_the_middle, false}, {"on_the_grass", on_the_grass, false}, {"on_the_stands", on_the_stands, false},
    {"sixteen", tea_party, false},           {"coarse_shell", coarse_shell, false}, {"fine_shell", fine_shell, false},
    {"tiny", tiny, false},                   {"speck", speck, true},                {"speck_at_the_rim", speck_at_the_rim, true},
};

Ray from_to(const Vec3& origin, const Vec3& target) {
    Ray ray;
    ray.origin = origin, ray.dir = target - origin;
    return ray;
}

const Bounds& any_teapot(const StadiumScene& scene, Draws& draws) { return scene.teapots[draws.below(scene.teapots.size())]; }

/// Through a window as large as the teapot, `distance` of its sizes away, from above and any side.
Ray look(const StadiumScene& scene, Draws& draws, double distance) {
    const Bounds& teapot = any_teapot(scene, draws);
    const Vec3 side = draws.direction(), eye = teapot.center() + distance * teapot.extent().x * normalized(Vec3(side.x, side.y, 0.2 + std::abs(side.z)));
    return from_to(eye, draws.in_box(teapot.min, teapot.max));
}

Ray close_camera(const StadiumScene& scene, const RandomKey& key) {
    Draws draws(key);
    return look(scene, draws, 3);
}

Ray far_camera(const StadiumScene& scene, const RandomKey& key) {
    Draws draws(key);
    return from_to(draws.in_box(Vec3(-80, -60, 20), Vec3(80, 60, 34)), look(scene, draws, 3).at(1));
}

Ray anywhere(const StadiumScene&, const RandomKey& key) {
    Draws draws(key);
    const Vec3 low(-0.45 * kLength, -0.45 * kWidth, 1), high(0.45 * kLength, 0.45 * kWidth, 34);
    const Vec3 from = draws.in_box(low, high);
    return from_to(from, draws.in_box(low, high));
}

/// Between two points close to a teapot, not aimed at it.
Ray past_a_teapot(const StadiumScene& scene, const RandomKey& key) {
    Draws draws(key);
    const Bounds& teapot = any_teapot(scene, draws);
    const Vec3 low = teapot.min - 2.0 * teapot.extent(), high = teapot.max + 2.0 * teapot.extent();
    const Vec3 from = draws.in_box(low, high);
    return from_to(from, draws.in_box(low, high));
}

/// From a point of a teapot towards a lamp over the field; it ends there.
Ray to_the_lamp(const StadiumScene& scene, const RandomKey& key) {
    Draws draws(key);
    Vec3 from;
    do {
        const uint32_t triangle = draws.below(scene.mesh.triangles.size());
        from = (scene.mesh.corner(triangle, 0) + scene.mesh.corner(triangle, 1) + scene.mesh.corner(triangle, 2)) * (1 / 3.0);
    } while (std::none_of(scene.teapots.begin(), scene.teapots.end(), [&](const Bounds& teapot) { return teapot.contains(from); }));
    Ray ray = from_to(from, Vec3(20, 30, 34));
    ray.tmin = 1e-9, ray.tmax = 1;
    return ray;
}

/// From anywhere towards a lamp that stands close to a teapot.
Ray to_a_candle(const StadiumScene& scene, const RandomKey& key) {
    Draws draws(key);
    const Bounds& teapot = any_teapot(scene, draws);
    Ray ray = from_to(anywhere(scene, key.child(1)).origin, teapot.max + 0.2 * teapot.extent());
    ray.tmax = 1;
    return ray;
}

constexpr StadiumRays kRays[] = {
    {"camera, close", close_camera, false}, {"camera, on the stands", far_camera, false}, {"past a teapot", past_a_teapot, false},
    {"anywhere", anywhere, false},          {"shadow, to the lamp", to_the_lamp, true},   {"shadow, to a candle", to_a_candle, true},
};

}  // namespace

StadiumScene teapots_in_a_stadium(const std::string& name, int shell, int fine, std::span<const TeapotPlace> places) {
    Builder builder;
    add_shell(builder, shell);
    std::vector<Bounds> teapots;
    for (const TeapotPlace& place : places) {
        const size_t first = builder.vertices.size();
        add_teapot(builder, fine, place);
        teapots.emplace_back();
        for (size_t i = first; i < builder.vertices.size(); ++i) teapots.back().extend(builder.vertices[i]);
    }
    return {TriangleMesh("stadium, " + name, std::move(builder.vertices), std::move(builder.triangles)), std::move(teapots)};
}

std::span<const StadiumCase> stadium_cases() { return kCases; }
std::span<const StadiumRays> stadium_rays() { return kRays; }

}  // namespace alidade::test
