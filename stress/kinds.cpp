// SPDX-License-Identifier: Apache-2.0
#include "stress/builder.h"

namespace alidade {

static constexpr StressKind kKinds[] = {
    {"scan", "a scanned figure: a closed surface, rough at all scales, of even triangles", 270000, make_scan},
    {"architecture", "a nave of fluted columns, arches, battens, tiles and cloth, turned off the axes: long thin triangles", 260000, make_architecture},
    {"stadium", "a figure of size 0.5 in a bowl of radius 1000", 117000, make_stadium},
    {"hair", "ribbons of slivers on a ball", 520000, make_hair},
    {"soup", "small triangles anywhere", 1000000, make_soup},
    {"sphere", "a sphere with gentle hills, of very many triangles", 2000000, make_sphere},
    {"forest", "a tree, a thousand times, by instances", 20000, make_forest},
};

std::span<const StressKind> stress_kinds() { return kKinds; }

const StressKind* find_stress_kind(std::string_view name) {
    for (const StressKind& kind : kKinds) {
        if (name == kind.name) return &kind;
    }
    return nullptr;
}

Bounds StressScene::bounds() const {
    Bounds box;
    for (const Vec3f& p : positions) box.extend(Vec3(p));
    return box;
}

void add_triangle(StressScene& scene, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = uint32_t(scene.positions.size());
    for (const Vec3& p : {a, b, c}) scene.positions.emplace_back(p);
    scene.triangles.emplace_back(first, first + 1, first + 2);
}

Ripples::Ripples(int octaves, double frequency, Draws& draws) {
    double height = 1.0 / 6;
    for (int octave = 0; octave < octaves; ++octave, frequency *= 2, height /= 2) {
        for (int i = 0; i < 3; ++i) waves_.push_back({frequency * draws.direction(), draws.uniform(0, 2 * kPi), height});
    }
}

double Ripples::operator()(const Vec3& p) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += wave.height * std::sin(dot(wave.direction, p) + wave.phase);
    return sum;
}

}  // namespace alidade
