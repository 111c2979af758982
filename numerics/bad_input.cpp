// SPDX-License-Identifier: Apache-2.0
/// What is not a number, too large, too small or nothing at all: the good part of a scene does not notice.
#include "accel/accelerator.h"
#include "numerics/rows.h"
#include "numerics/scene_maker.h"
#include "numerics/shape_samples.h"
#include "numerics/triangles/rays.h"
#include "tracer/compiled_scene.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace alidade::numerics {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Positions and triangles, three positions each.
struct Triangles {
    std::vector<Vec3> positions;
    std::vector<Vec3f> rounded;
    std::vector<Index3> triangles;

    size_t count() const { return triangles.size(); }
    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto first = uint32_t(positions.size());
        for (const Vec3& p : {a, b, c}) positions.push_back(p), rounded.emplace_back(p);
        triangles.emplace_back(first, first + 1, first + 2);
    }
    std::unique_ptr<Accelerator> build(const AcceleratorEntry& entry, Precision precision) const {
        AccelOptions options;
        options.precision = precision;
        return entry.over_triangles({rounded, positions, triangles}, options);
    }
};

/// The unit sphere as a cube that is blown up: 12 n^2 triangles.
Triangles sphere(int n) {
    Triangles mesh;
    const auto corner = [n](int face, int i, int j) {
        Vec3 p(0);
        p[face / 2] = face % 2 ? 1 : -1, p[(face / 2 + 1) % 3] = 2.0 * i / n - 1, p[(face / 2 + 2) % 3] = 2.0 * j / n - 1;
        return normalized(p);
    };
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                mesh.add(corner(face, i, j), corner(face, i + 1, j), corner(face, i + 1, j + 1));
                mesh.add(corner(face, i, j), corner(face, i + 1, j + 1), corner(face, i, j + 1));
            }
    return mesh;
}

constexpr int kFineness = 8;

struct BadPart {
    const char* name;
    std::array<Vec3, 3> corners;
    size_t times;
    bool removed;   ///< it must be told; else either will do
};

/// Those that can be hit are inside of the sphere, or far behind it.
std::vector<BadPart> bad_parts() {
    const Vec3 a(0.1, 0, 0), b(0, 0.1, 0), c(0, 0, 0.1);
    return {{"NaN", {a, b, Vec3(0, kNaN, 0)}, 1, true},
            {"NaN alone", {Vec3(kNaN), Vec3(kNaN), Vec3(kNaN)}, 1, true},
            {"infinite", {a, b, Vec3(kInf, 0, 0)}, 1, true},
            {"minus infinite", {Vec3(0, 0, -kInf), a, b}, 1, true},
            {"at 1e30", {Vec3(1e30, 0, 0), Vec3(1e30, 1e30, 0), Vec3(1e30, 0, 1e30)}, 1, false},
            {"at 3e38", {Vec3(3e38, 0, 0), Vec3(3e38, 3e38, 0), Vec3(3e38, 0, 3e38)}, 1, false},
            {"at both ends of float", {Vec3(-3e38, 3e38, 3e38), Vec3(3e38, 3e38, 3e38), Vec3(3e38, 3e38, -3e38)}, 1, false},
            {"at 1e300", {Vec3(1e300, 0, 0), Vec3(1e300, 1e300, 0), Vec3(1e300, 0, 1e300)}, 1, true},
            {"denormal", {Vec3(1e-41, 0, 0), Vec3(0, 1e-41, 0), Vec3(0, 0, 1e-41)}, 1, false},
            {"a point", {a, a, a}, 1, true},
            {"two points", {a, b, b}, 1, true},
            {"on a line", {Vec3(0.125, 0, 0), Vec3(0.25, 0, 0), Vec3(0.5, 0, 0)}, 1, true},
            {"20,000 equal ones", {a, b, c}, 20000, false},
            {"20,000 points", {a, a, a}, 20000, true},
            {"1,000 NaN", {a, b, Vec3(kNaN)}, 1000, true},
            {"nothing", {}, 0, true}};
}

/// From a corner of the sphere's box, so that a larger box does not move its origin.
Ray at_sphere(Draws& draws) {
    Ray ray;
    do ray.origin = draws.in_box(Vec3(-1), Vec3(1));
    while (length(ray.origin) < 1.01);
    ray.dir = draws.in_box(Vec3(-1), Vec3(1)) - ray.origin;
    return ray;
}

Hit counted_hit(const Accelerator& accelerator, const Ray& ray, uint64_t& work) {
    WorkCounters counters;
    Hit hit;
    accelerator.intersect(ray, hit, counters);
    work += counters.boxes + counters.filtered;
    return hit;
}

bool same(const Hit& a, const Hit& b) { return a.t == b.t && a.primitive == b.primitive && a.u == b.u && a.v == b.v && a.error.along_normal == b.error.along_normal; }

/// The sphere's hits with a bad part and without, and brute force's: bits, work, and what is told of the part.
void bad_triangles(uint64_t number, Draws& draws, NumericsTally& tally) {
    static const std::vector<BadPart> parts = bad_parts();
    static const Triangles good = sphere(kFineness);
    const BadPart& part = parts[number % parts.size()];
    const AcceleratorEntry& entry = accelerators()[number / parts.size() % accelerators().size()];
    const Precision precision = draws.coin() ? Precision::float_ : Precision::double_;
    const bool alone = draws.below(8) == 0;   // then there is no good part
    Triangles whole = alone ? Triangles() : good;
    for (size_t i = 0; i < part.times; ++i) whole.add(part.corners[0], part.corners[1], part.corners[2]);
    const auto accelerator = whole.build(entry, precision), before = good.build(entry, precision), truth = whole.build(accelerators()[0], precision);
    const auto what = [&](const std::string& more) { return fmt::format("{}, {}, {}: {}", part.name, entry.name, precision == Precision::float_ ? "float" : "double", more); };
    const size_t kept = whole.count() - part.times;
    if (part.removed) tally.decide(accelerator->stats().removed.size() == part.times && accelerator->stats().primitives == kept && (alone || accelerator->bounds().finite()), [&] { return what("not told"); });
    uint64_t work = 0, work_before = 0, unused = 0;
    constexpr uint64_t kRays = 40;
    for (uint64_t i = 0; i < kRays; ++i) {
        const Ray ray = at_sphere(draws);
        const Hit good_hit = counted_hit(*before, ray, work_before), got = counted_hit(*accelerator, ray, work), want = counted_hit(*truth, ray, unused);
        const bool unchanged = alone || !good_hit.valid() || same(got, good_hit), finite = !got.valid() || std::isfinite(got.t);
        tally.decide(unchanged && finite && same(got, want) && (!part.removed || !got.valid() || got.primitive < kept), [&] { return what(describe(ray)); });
    }
    if (alone || (!part.removed && part.times > 1)) return;   // of those that are at one place, a ray there has to ask each which is the first
    const uint64_t allowed = part.removed ? work_before + work_before / 10 : 2 * work_before + kRays * 8;   // what is kept has boxes around all, and is tested itself
    tally.decide(work <= allowed, [&] { return what(fmt::format("it costs work: {} for {}", work, work_before)); });
}

/// One number of a ray that is none, or too large, or a ray without a length or without an end.
Ray bad_ray(Draws& draws) {
    Ray ray;
    ray.origin = {0, 0, -3};
    const double values[] = {kNaN, kInf, -kInf};
    const double value = values[draws.below(3)];
    const int axis = int(draws.below(3));
    switch (draws.below(10)) {
        case 0: ray.dir[axis] = value; break;
        case 1: ray.origin[axis] = value; break;
        case 2: ray.dir = Vec3(0); break;
        case 3: ray.dir = Vec3(-0.0); break;
        case 4: ray.dir = Vec3(kInf); break;
        case 5: ray.tmin = kNaN; break;
        case 6: ray.tmax = kNaN; break;
        case 7: ray.tmin = 5, ray.tmax = 1; break;
        case 8: ray.tmax = -1; break;
        default: ray.tmin = draws.coin() ? kInf : -kInf, ray.tmax = ray.tmin; break;
    }
    return ray;
}

/// On a mesh, and on a scene of closed forms. Directions of any length find what they found, in their own measure; of closed forms, which square it, from 2^-200 to 2^200.
void bad_rays(uint64_t number, Draws& draws, NumericsTally& tally) {
    static const Triangles good = sphere(kFineness);
    const AcceleratorEntry& entry = accelerators()[number % accelerators().size()];
    const auto mesh = good.build(entry, draws.coin() ? Precision::float_ : Precision::double_);
    SceneMaker maker;
    const MaterialId material = maker.unlit(Color(1));
    for (const ShapeOps& ops : shapes()) maker.object(default_shape(ops.kind), material, Transform::rotate(draws.direction(), 1));
    CompileOptions options;
    options.accel = entry.name, options.threads = 1;
    Diagnostics said;
    const auto scene = compile(maker.scene, options, said);
    if (!scene) return tally.decide(false, [&] { return said.text(); });
    uint64_t work = 0;
    for (int i = 0; i < 20; ++i) {
        const Ray ray = bad_ray(draws);
        WorkCounters counters;
        const bool hit = counted_hit(*mesh, ray, work).valid() || counted_hit(*scene->top, ray, work).valid() || mesh->occluded(ray, counters) || scene->top->occluded(ray, counters);
        tally.decide(!hit, [&] { return fmt::format("{}: {} hits", entry.name, describe(ray)); });
        const Ray plain = at_sphere(draws);
        const int power = int(draws.below(2001)) - 1000;
        for (const Accelerator* surfaces : {mesh.get(), scene->top.get()}) {
            Ray stretched = plain;
            const double factor = std::ldexp(1.0, surfaces == mesh.get() ? power : power / 5);
            stretched.dir *= factor;
            const Hit want = counted_hit(*surfaces, plain, work), got = counted_hit(*surfaces, stretched, work);
            tally.decide(got.primitive == want.primitive && got.instance == want.instance && (!want.valid() || got.t * factor == want.t), [&] { return fmt::format("{}: {}, its direction times {}", entry.name, describe(plain), factor); });
        }
    }
}

/// A closed form whose numbers are too large, too small or none stands beside a good sphere: it is refused with a message, or the sphere is seen as ever.
void bad_shapes(uint64_t number, Draws& draws, NumericsTally& tally) {
    const ShapeOps& ops = shapes()[number % shapes().size()];
    static const double kScales[] = {kNaN, kInf, 0, 1e300, 1e-300, 5e-324, 3e38, 1e-45, 1};
    static const double kOffsets[] = {0, kNaN, kInf, 1e300, 3e38, 1e30};
    const double scale = kScales[draws.below(std::size(kScales))], offset = kOffsets[draws.below(std::size(kOffsets))];
    SceneMaker maker;
    const MaterialId material = maker.unlit(Color(1));
    maker.object(Sphere{Vec3(0), 1}, material);
    const bool by_transform = draws.coin();
    const Transform place{Mat3(scale, 0, 0, 0, scale, 0, 0, 0, scale), Vec3(0, 0, offset)};
    maker.object(by_transform ? default_shape(ops.kind) : placed(default_shape(ops.kind), scale, Vec3(0, 0, offset)), material, by_transform ? place : Transform());
    CompileOptions options;
    options.accel = accelerators()[draws.below(accelerators().size())].name, options.threads = 1;
    Diagnostics said;
    const auto scene = compile(maker.scene, options, said);
    const auto what = [&](const std::string& more) { return fmt::format("{} {} by {}, moved by {}, {}: {}", ops.name, by_transform ? "transformed" : "made", scale, offset, options.accel, more); };
    if (!scene) return tally.decide(!said.text().empty() && !(scale == 1 && offset == 0), [&] { return what("refused: " + said.text()); });
    for (int i = 0; i < 20; ++i) {
        const Ray ray = at_sphere(draws);
        const Crossings on_sphere = find_shape(Sphere{})->crossings(Sphere{}, ray);
        std::vector<Hit> hits;
        WorkCounters work;
        scene->top->all_hits(ray, hits, work);
        int seen = 0;
        bool right = true;
        for (const Hit& hit : hits) {
            right = right && std::isfinite(hit.t) && hit.t >= 0;
            if (hit.instance == 0) right = right && seen < on_sphere.count && hit.t == on_sphere.at[size_t(seen)].t, ++seen;
        }
        tally.decide(right && seen == (on_sphere.count && on_sphere.at[0].t < 0 ? 0 : on_sphere.count), [&] { return what(describe(ray)); });
    }
}

}  // namespace

Check bad_input() {
    return [](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(19, 0, number));
        constexpr std::array kSubjects{bad_triangles, bad_rays, bad_shapes};
        kSubjects[number % kSubjects.size()](number / kSubjects.size(), draws, tally);
    };
}

}  // namespace alidade::numerics
