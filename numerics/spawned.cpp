// SPDX-License-Identifier: Apache-2.0
/// Rays that begin on a surface: they do not meet it again, and they meet what is close.
#include "core/draws.h"
#include "numerics/rows.h"
#include "numerics/toy_scenes.h"
#include "numerics/triangles/rays.h"
#include "numerics/triangles/subjects.h"
#include "tracer/compiled_scene.h"
#include "tracer/shade_point.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace alidade::numerics {

namespace {

alidade::Mesh scene_mesh(const TriangleMesh& mesh) {
    alidade::Mesh out;
    out.positions = mesh.positions, out.triangles = mesh.triangles;
    return out;
}

/// A scene and who traces it.
struct Stage {
    std::shared_ptr<const CompiledScene> scene;
    std::string text;
    double size = 1;
    double offset = 0;       ///< of the centre from the origin, in sizes
    double gap = 0;          ///< between its parts, in sizes
    Vec3 center{0};
    bool convex = true;
    Transform to_world;      ///< of the space in which the surfaces are at contact
    size_t parts = 1;        ///< instances

    void compile(Scene source, Draws& draws) {
        CompileOptions options;
        options.threads = 1;
        const auto& entry = accelerators()[draws.below(accelerators().size())];
        options.accel = entry.name, options.precision = precision_of(draws.coin()), options.intersect = asked().intersect;
        Diagnostics said;
        scene = alidade::compile(std::move(source), options, said);
        text += fmt::format(", size {}, at {}, {}, {}", size, length(center), entry.name, name(options.precision));
    }
    Hit first(const Ray& ray) const { return first_hit(*scene->top, ray); }
};

Transform turned(Draws& draws) {
    const Vec3 axis = draws.direction();
    return Transform::rotate(axis, draws.uniform(0, 2 * kPi));
}

struct Form {
    std::string name;
    ShapeGeometry geometry;
    bool convex = false;
};

/// Does a ray that leaves it outwards never meet it again? What is not known to be so has its near hits counted alone.
bool is_convex(const ShapeGeometry& geometry) {
    return std::visit([]<class T>(const T&) { return (std::is_same_v<T, Sphere> || std::is_same_v<T, Plane> || std::is_same_v<T, Box> || std::is_same_v<T, Disc> || std::is_same_v<T, Cylinder> ||
                                                     std::is_same_v<T, Cone> || std::is_same_v<T, Quadric> || std::is_same_v<T, Polynomial> || std::is_same_v<T, Polygon> || std::is_same_v<T, Extrusion>); }, geometry);
}

/// Every closed form as it comes, and some that are harder.
const std::vector<Form>& forms() {
    static const std::vector<Form> all = [] {
        std::vector<Form> list;
        for (size_t row = 0; row < shapes().size(); ++row) list.push_back({shapes()[row].name, toy_shape(row)});
        Polynomial cushion{4, std::vector<double>(Polynomial::terms(4))};   // x^4 + y^4 + z^4 = 1
        cushion.coefficients[0] = cushion.coefficients[20] = cushion.coefficients[30] = 1, cushion.coefficients.back() = -1;
        list.push_back({"cushion", cushion});
        list.push_back({"ellipsoid", Quadric{{1, 1.5, 3}, {0.3, -0.2, 0.1}, {0, 0.1, 0}, -1}});
        for (Form& form : list) form.convex = is_convex(form.geometry);
        for (const TriangleMesh& mesh : {geodesic_sphere(4), cube(2)}) list.push_back({mesh.name, scene_mesh(mesh), true});
        return list;
    }();
    return all;
}

Stage alone(uint64_t block) {
    Draws draws(RandomKey(17, 1, block));
    const Form& form = forms()[block % forms().size()];
    Stage stage;
    stage.text = form.name, stage.convex = form.convex;
    stage.size = std::pow(10, draws.uniform(-12, 12));
    if (draws.coin()) stage.offset = std::pow(10, draws.uniform(0, 7)), stage.center = draws.direction() * stage.size * stage.offset;
    stage.to_world = Transform::translate(stage.center) * turned(draws) * Transform::scale(Vec3(stage.size));
    stage.compile(toy_shapes({{form.geometry, stage.to_world}}), draws);
    return stage;
}

/// On the side of `normal`; half of them graze.
Vec3 outward(const Vec3& normal, Draws& draws) {
    const Vec3 any = draws.direction();
    const Vec3 out = dot(any, normal) < 0 ? -any : any;
    if (draws.coin()) return out;
    return normalized(normalized(out - dot(out, normal) * normal) + std::pow(10, draws.uniform(-8, 0)) * normal);
}

Ray towards(const Stage& stage, Draws& draws) {
    Ray ray;
    ray.origin = stage.center + draws.direction() * (stage.size * draws.uniform(3, 6));
    ray.dir = normalized(stage.center + draws.in_box(Vec3(-1), Vec3(1)) * (0.6 * stage.size) - ray.origin);
    return ray;
}

/// A ray that leaves a convex body meets it nowhere; any other, nowhere nearer than the bend of the surface lets it.
bool is_self_hit(const Stage& stage, const Ray& next, const Vec3& normal) {
    const Hit hit = stage.first(next);
    return hit.valid() && (stage.convex || hit.t < 1e-3 * stage.size * dot(next.dir, normal));
}

/// Two parallel squares of side 2 in the planes z = low and z = high, as one mesh or each by itself.
struct Squares {
    float low, high, x, y;   ///< of the middle

    alidade::Mesh mesh(std::initializer_list<float> heights) const {
        alidade::Mesh out;
        for (const float z : heights) {
            const auto first = uint32_t(out.positions.size());
            for (const auto& [i, j] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) out.positions.emplace_back(x + float(i), y + float(j), z);
            out.triangles.emplace_back(first, first + 1, first + 2), out.triangles.emplace_back(first, first + 2, first + 3);
        }
        return out;
    }
};

/// Both in float; as far apart as 1e-7 to 1e-2 of their size, and 4 units in the last place of the largest coordinate or more.
Squares squares(Draws& draws) {
    const double far = draws.coin() ? 0 : std::pow(10, draws.uniform(0, 5));
    const Vec3 at = draws.in_box(Vec3(-1), Vec3(1)) * far;
    Squares s{float(at.z), 0, float(at.x), float(at.y)};
    const auto largest = float(max_abs(at) + 1);
    const float ulp = std::nextafter(largest, 2 * largest) - largest;
    s.high = s.low + std::max(float(std::pow(10, draws.uniform(-7, -2))), 4 * ulp);
    while (s.high - s.low < 4 * ulp) s.high = std::nextafter(s.high, 2 * largest);
    return s;
}

Stage contact(uint64_t block) {
    Draws draws(RandomKey(18, 1, block));
    const Squares s = squares(draws);
    Stage stage;
    stage.size = std::pow(10, draws.uniform(-9, 9));
    stage.center = draws.coin() ? Vec3(0) : draws.direction() * stage.size * std::pow(10, draws.uniform(0, 2));
    const Transform place = Transform::translate(stage.center) * turned(draws) * Transform::scale(Vec3(stage.size));
    stage.to_world = place * Transform::translate({s.x, s.y, s.low});
    const uint64_t kind = block % 4;
    const double gap = kind < 2 ? double(s.high) - s.low : std::pow(10, draws.uniform(-9, -2));   // no float says where closed forms are
    const Transform above = stage.to_world * Transform::translate({0, 0, gap});
    std::vector<PlacedToy> parts;
    if (kind == 0) parts = {{s.mesh({s.low, s.high}), place}};
    if (kind == 1) parts = {{s.mesh({s.low}), place}, {s.mesh({s.high}), place}};
    if (kind == 2) parts = {{Disc{Vec3(0), {0, 0, 1}, 1.5, 0}, stage.to_world}, {Disc{Vec3(0), {0, 0, 1}, 1.5, 0}, above}};
    if (kind == 3) parts = {{Box{Vec3(-1, -1, -1), Vec3(1, 1, 0)}, stage.to_world}, {Box{Vec3(-1, -1, 0), Vec3(1, 1, 1)}, above}};
    stage.parts = parts.size(), stage.gap = gap;
    stage.text = fmt::format("{} apart, {}", gap, std::array{"one mesh", "two meshes", "discs", "boxes"}[kind]);
    stage.compile(toy_shapes(std::move(parts)), draws);
    return stage;
}

/// Was the lower (0) or the upper (1) surface hit?
size_t which(const Stage& stage, const Hit& hit) { return stage.parts == 1 ? hit.primitive / 2 : hit.instance; }

}  // namespace

Check self_hit() {
    return [kept = std::make_shared<Shared<Stage>>()](uint64_t number, NumericsTally& tally) {
        constexpr uint64_t kBlock = 64;   // rays at the same shape
        const Stage& stage = kept->at(number / kBlock, alone);
        Draws draws(RandomKey(17, 0, number));
        tally.at(NumericsScale::size, stage.size), tally.at(NumericsScale::offset, stage.offset);
        const Ray ray = towards(stage, draws);
        const Hit hit = stage.first(ray);
        if (!hit.valid()) return;
        const ShadePoint p = shade_point(*stage.scene, ray, hit);
        const Vec3 normal = dot(ray.dir, p.geometric_normal) > 0 ? -p.geometric_normal : p.geometric_normal;
        const Ray next = spawn_ray(p, outward(normal, draws));
        const auto what = [&] { return fmt::format("{}: {}, then {}", stage.text, describe(ray), describe(next)); };
        tally.decide(!is_self_hit(stage, next, normal), what);
        tally.decide(p.error < 1e-6 * stage.size, what);   // the bound is no epsilon
    };
}

Check contacts() {
    return [kept = std::make_shared<Shared<Stage>>()](uint64_t number, NumericsTally& tally) {
        constexpr uint64_t kBlock = 64;
        const Stage& stage = kept->at(number / kBlock, contact);
        tally.at(NumericsScale::size, stage.size), tally.at(NumericsScale::gap, stage.gap);
        Draws draws(RandomKey(18, 0, number));
        const Vec3 up = normalized(stage.to_world.vector(Vec3(0, 0, 1)));
        const auto steep = [&](double side) {
            const Vec3 any = draws.direction();
            return normalized(any + up * (side * (0.2 + std::abs(dot(any, up))) - dot(any, up)));
        };
        const double x = draws.uniform(-0.6, 0.6), y = draws.uniform(-0.6, 0.6);
        Ray ray;
        ray.dir = steep(1);
        ray.origin = stage.to_world.point({x, y, 0}) - ray.dir * (0.3 * stage.size);   // inside of the lower box, where there is one
        const auto what = [&] { return fmt::format("{}: {}", stage.text, describe(ray)); };
        Hit hit = stage.first(ray);
        for (const size_t next : {0, 1, 0, 1}) {
            tally.decide(hit.valid() && which(stage, hit) == next, what);
            if (!hit.valid() || which(stage, hit) != next) return;
            ray = spawn_ray(shade_point(*stage.scene, ray, hit), steep(next == 0 ? 1 : -1));
            hit = stage.first(ray);
        }
    };
}

}  // namespace alidade::numerics
