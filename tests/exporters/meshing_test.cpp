// SPDX-License-Identifier: Apache-2.0
/// Meshes in place of closed forms and solids: they lie where these do, all of them, and are as closed.
#include "exporters/meshing/mesh_scene.h"

#include "accel/accelerator.h"
#include "eval/solid_query.h"
#include "exporters/meshing/dual_contouring.h"
#include "exporters/meshing/fill.h"
#include "exporters/meshing/plane_fit.h"
#include "scene/queries.h"
#include "tests/eval/shape_samples.h"
#include "tests/scene/sample_scene.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <map>
#include <set>

namespace alidade::test {
namespace {

constexpr int kSegments = 64;
constexpr double kRegion = 4;

Scene meshed(const Scene& scene) {
    Losses losses;
    auto out = meshing::mesh_scene(scene, kSegments, losses);
    EXPECT_TRUE(out) << (out ? "" : out.error());
    EXPECT_FALSE(validate(*out).has_errors()) << validate(*out).text();
    return std::move(*out);
}

Scene scene_of_shape(const ShapeGeometry& shape) {
    Scene s;
    s.nodes.resize(1);
    s.nodes[0].what = ShapeId{0};
    s.shapes = {{"", shape, {}}};
    s.roots = {NodeId{0}};
    return s;
}

Vec3 corner(const Mesh& mesh, size_t triangle, int i) { return mesh.origin + Vec3(mesh.positions[mesh.triangles[triangle][i]]); }
Vec3 double_area(const Mesh& m, size_t t) { return cross(corner(m, t, 1) - corner(m, t, 0), corner(m, t, 2) - corner(m, t, 0)); }
Vec3 middle(const Mesh& m, size_t t) { return (corner(m, t, 0) + corner(m, t, 1) + corner(m, t, 2)) / 3.0; }

double area(const Mesh& m) {
    double sum = 0;
    for (size_t t = 0; t < m.triangles.size(); ++t) sum += length(double_area(m, t)) / 2;
    return sum;
}

/// Of what is inside of a closed mesh.
double volume(const Mesh& m) {
    double sum = 0;
    for (size_t t = 0; t < m.triangles.size(); ++t) sum += dot(double_area(m, t), corner(m, t, 0)) / 6;
    return sum;
}

/// Has each side its opposite?
bool is_closed(const Mesh& m) {
    std::map<std::pair<uint32_t, uint32_t>, int> sides;
    for (const Index3& t : m.triangles)
        for (int c = 0; c < 3; ++c) ++sides[{t[c], t[(c + 1) % 3]}];
    return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
        const auto opposite = sides.find({side.first.second, side.first.first});
        return opposite != sides.end() && opposite->second == side.second;
    });
}

bool is_contoured(const ShapeGeometry& g) { return std::holds_alternative<Quadric>(g) || std::holds_alternative<Polynomial>(g); }

struct Case {
    const ShapeOps* ops;
    ShapeGeometry shape;
    Mesh mesh;
    double size, near;   ///< `near`: as far as the mesh may be from the surface
    std::string name;
};

/// A quadric may be nowhere 0.
bool is_empty(const ShapeGeometry& g) {
    const auto* q = std::get_if<Quadric>(&g);
    return q && q->products == Vec3(0) && max_component(q->squares) < 0 && q->constant < -1;
}

/// Some of each row of the table of shapes.
std::vector<Case> cases() {
    std::vector<Case> out;
    for (const ShapeOps& ops : shapes())
        for (int i = 0; i < 5; ++i) {
            Draw draw(uint64_t(100 + i));
            Case c{&ops, sample_shape(ops, i, draw), {}, 0, 0, fmt::format("{} {}", ops.name, i)};
            if (is_empty(c.shape)) continue;
            Scene scene = scene_of_shape(c.shape);
            scene.nodes.emplace_back().what = ShapeId{1};
            scene.shapes.push_back({"", Box{Vec3(-kRegion), Vec3(kRegion)}, {}});   // endless shapes are cut near what is bounded
            scene.roots.push_back(NodeId{1});
            c.mesh = std::get<Mesh>(meshed(scene).shapes[0].geometry);
            const Bounds box = ops.bounds(c.shape);
            c.size = box.finite() ? max_component(box.extent()) : 2 * kRegion;
            c.near = (is_contoured(c.shape) ? 5e-3 : 3e-3) * c.size;
            out.push_back(std::move(c));
        }
    return out;
}

/// The way from a point to the surface along a direction, forwards or backwards.
double distance_along(const Case& c, const Vec3& point, const Vec3& direction) {
    Ray ray{point, direction};
    const Crossings found = c.ops->crossings(c.shape, ray);
    double least = kInf;
    for (int i = 0; i < found.count; ++i) least = std::min(least, std::abs(found.at[i].t));
    return least;
}

TEST(Meshing, EveryTriangleLiesOnTheShapeAndFacesOutwards) {
    for (const Case& c : cases()) {
        ASSERT_GT(c.mesh.triangles.size(), 0u) << c.name;
        size_t far = 0, turned = 0, wrong_normals = 0;
        for (size_t t = 0; t < c.mesh.triangles.size(); ++t) {
            const Vec3 normal = normalized(double_area(c.mesh, t)), at = middle(c.mesh, t);
            if (normal == Vec3(0)) continue;
            far += !(distance_along(c, at, normal) <= c.near);
            if (c.ops->solid(c.shape) && has_inside(c.shape)) turned += !c.ops->inside(c.shape, at - 2 * c.near * normal) && c.ops->inside(c.shape, at + 2 * c.near * normal);
            for (int i = 0; i < 3; ++i) wrong_normals += dot(Vec3(c.mesh.normals.values[c.mesh.normals.index(t, i, c.mesh.triangles[t])]), normal) < 0.5;
        }
        const double all = double(c.mesh.triangles.size());
        EXPECT_LE(double(far) / all, is_contoured(c.shape) ? 0.01 : 0) << c.name;
        EXPECT_LE(double(turned) / all, 0.001) << c.name;
        EXPECT_LE(double(wrong_normals) / all, is_contoured(c.shape) ? 0.01 : 0) << c.name;
    }
}

/// Lines that meet the shape meet the mesh near by, and the other way round.
TEST(Meshing, NothingIsMissing) {
    for (const Case& c : cases()) {
        const auto accelerator = find_accelerator("bvh")->over_triangles({c.mesh.positions, {}, c.mesh.triangles}, {});
        Draw draw(7);
        int hits = 0, missed = 0;
        for (int i = 0; i < 3000; ++i) {
            const Ray ray = ray_from(4 * kRegion, draw);
            Ray local = ray;
            local.origin -= c.mesh.origin;
            std::vector<Hit> found;
            WorkCounters unused;
            accelerator->all_hits(local, found, unused, 0);
            const Crossings crossings = c.ops->crossings(c.shape, ray);
            for (int k = 0; k < crossings.count; ++k) {
                const Vec3 at = ray.at(crossings.at[k].t);
                if (max_abs(at) > kRegion && !c.ops->bounds(c.shape).finite()) continue;
                const double slant = std::abs(dot(c.ops->normal_at(c.shape, at, crossings.at[k].part), ray.dir)) / length(ray.dir);
                if (slant < 0.2) continue;
                ++hits;
                missed += std::none_of(found.begin(), found.end(), [&](const Hit& hit) { return length(ray.at(hit.t) - at) * slant < 3 * c.near; });
            }
        }
        EXPECT_GT(hits, 100) << c.name;
        EXPECT_LE(missed, hits / 100) << c.name;
    }
}

TEST(Meshing, SolidsAreClosed) {
    for (const Case& c : cases()) {
        if (!c.ops->solid(c.shape) || !has_inside(c.shape) || !c.ops->bounds(c.shape).finite()) continue;
        EXPECT_TRUE(is_closed(c.mesh)) << c.name;
        EXPECT_GT(volume(c.mesh), 0) << c.name;
    }
}

/// As the segments say: a circle becomes a polygon of n corners, whose area is n / 2 sin(2 pi / n).
TEST(Meshing, VolumesAreThoseOfTheForms) {
    const auto volume_of = [](const ShapeGeometry& shape) { return volume(std::get<Mesh>(meshed(scene_of_shape(shape)).shapes[0].geometry)); };
    const double circle = kSegments / 2.0 * std::sin(2 * kPi / kSegments);
    EXPECT_NEAR(volume_of(Box{Vec3(-1), Vec3(1, 2, 3)}), 24, 1e-6);
    EXPECT_NEAR(volume_of(Cylinder{Vec3(1), Vec3(1, 3, 1), 0.5, false}), 2 * 0.25 * circle, 1e-6);
    EXPECT_NEAR(volume_of(Cone{Vec3(0), Vec3(0, 0, 3), 1, 0, false}), circle, 1e-6);
    EXPECT_NEAR(volume_of(Sphere{Vec3(5), 2}), 4.0 / 3 * kPi * 8, 0.005 * 33);
    EXPECT_NEAR(volume_of(Torus{Vec3(0), 2, 0.5}), 2 * kPi * kPi * 2 * 0.25, 0.005 * 10);
    EXPECT_NEAR(volume_of(Quadric{Vec3(1, 4, 1), Vec3(0), Vec3(0), -1}), 4.0 / 3 * kPi / 2, 0.002 * 2);
}

/// A cube of side 2 without the eighth of a ball of radius 1 around a corner: the mesh keeps edges and faces where they are.
TEST(Meshing, SolidsKeepTheirEdges) {
    Scene s;
    s.nodes.resize(4);
    s.nodes[0].children = {NodeId{1}};
    s.nodes[0].to_parent = Transform::translate(Vec3(100, 0, 0)) * Transform::rotate(normalized(Vec3(1, 2, 3)), 0.7);
    s.nodes[1].csg = CsgKind::difference, s.nodes[1].children = {NodeId{2}, NodeId{3}};
    s.nodes[2].what = ShapeId{0}, s.nodes[3].what = ShapeId{1};
    s.nodes[3].materials = {MaterialId{0}};
    s.shapes = {{"", Box(), {}}, {"", Sphere{Vec3(1), 1}, {}}};
    s.signals.resize(1);
    s.materials.resize(1);
    s.materials[0].layers.emplace_back(PovFinish());
    s.roots = {NodeId{0}};
    const Scene out = meshed(s);
    ASSERT_EQ(out.nodes.size(), 2u) << "the parts are gone";
    EXPECT_TRUE(out.nodes[1].children.empty());
    const auto& mesh = std::get<Mesh>(out.shapes[std::get<ShapeId>(out.nodes[1].what).index].geometry);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume(mesh), 8 - kPi / 6, 0.003);
    double farthest = 0, red = 0;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (out.nodes[1].materials[mesh.slots[t]]) red += length(double_area(mesh, t)) / 2;
        for (int i = 0; i < 3; ++i) {
            const Vec3 p = corner(mesh, t, i);
            farthest = std::max(farthest, std::min(std::abs(max_abs(p) - 1), std::abs(length(p - Vec3(1)) - 1)));
        }
    }
    EXPECT_LT(farthest, 1e-3);
    EXPECT_NEAR(red, kPi / 2, 0.06) << "the ball's part has the ball's material, to a cell";
}

/// A ball of radius 1 that a box clips to its upper half is open below, and its rim is where the box says.
TEST(Meshing, ClipsCutWhereTheyAre) {
    Scene s = scene_of_shape(Sphere());
    s.nodes.emplace_back().what = ShapeId{1};
    s.shapes.push_back({"", Box{Vec3(-2, 0.25, -2), Vec3(2)}, {}});
    s.nodes[0].clips = {NodeId{1}};
    const Scene out = meshed(s);
    const auto& mesh = std::get<Mesh>(out.shapes[std::get<ShapeId>(out.nodes[0].what).index].geometry);
    EXPECT_NEAR(area(mesh), 2 * kPi * 0.75, 0.005);
    double lowest = 1;
    for (const Vec3f& p : mesh.positions) lowest = std::min(lowest, double(p.y));
    EXPECT_NEAR(lowest, 0.25, 1e-6);
}

/// Where nothing is bounded, the camera tells how large the scene is.
TEST(Meshing, AnEndlessSceneIsCutBehindItsMiddle) {
    Scene s = scene_of_shape(Plane{Vec3(0, 1, 0), -1});
    s.cameras.resize(1);
    s.cameras[0].location = Vec3(0, 0, 5);
    s.nodes.emplace_back().what = CameraId{0};
    s.roots.push_back(NodeId{1});
    const Scene out = meshed(s);
    const Bounds box = bounds(out.shapes[0].geometry);
    EXPECT_LT(box.min.z, -50);
    EXPECT_GT(box.max.z, 50);
    EXPECT_EQ(box.min.y, -1);
}

/// What leads elsewhere in the scene keeps leading there.
TEST(Meshing, TheRestStaysAsItWas) {
    const Scene before = sample_scene(), after = meshed(before);
    EXPECT_LT(after.nodes.size(), before.nodes.size());
    EXPECT_EQ(after.nodes[after.lights[0].looks_like->index].name, before.nodes[before.lights[0].looks_like->index].name);
    EXPECT_EQ(after.nodes[after.skins[0].joints[0].index].name, before.nodes[before.skins[0].joints[0].index].name);
    EXPECT_FALSE(meshing::needs_meshes(after));
    EXPECT_TRUE(meshing::needs_meshes(before));
}

TEST(Meshing, TheInnerSheetOfASpindleIsToldAsLost) {
    for (const auto& [torus, told] : {std::pair(Torus{Vec3(0), 1, 0.5}, false), {Torus{Vec3(0), 0.5, 1}, true}, {Torus{Vec3(0), -0.5, 1}, true}, {Torus{Vec3(0), 0, 1}, false}}) {
        Losses losses;
        ASSERT_TRUE(meshing::mesh_scene(scene_of_shape(torus), kSegments, losses));
        EXPECT_EQ(std::any_of(losses.list().begin(), losses.list().end(), [](const Loss& l) { return l.what.starts_with("the inner sheets"); }), told) << torus.major;
    }
}

TEST(Meshing, TooManyTrianglesAreRefused) {
    Scene s;
    for (uint32_t i = 0; i < 40; ++i) {
        s.nodes.emplace_back().what = ShapeId{i};
        s.shapes.push_back({"", Sphere(), {}});
        s.roots.push_back(NodeId{i});
    }
    Losses losses;
    const auto out = meshing::mesh_scene(s, 1024, losses);
    ASSERT_FALSE(out);
    EXPECT_THAT(out.error(), testing::HasSubstr("--segments"));
}

double area_of(const meshing::Filled& f) {
    double sum = 0;
    for (const Index3& t : f.triangles) {
        const Vec2 u = f.points[t.y] - f.points[t.x], v = f.points[t.z] - f.points[t.x];
        EXPECT_GE(u.x * v.y - u.y * v.x, -1e-12);
        sum += (u.x * v.y - u.y * v.x) / 2;
    }
    return sum;
}

/// By Green's theorem from the rim.
double area_in_rim(const meshing::Filled& f) {
    double sum = 0;
    for (const auto& edge : f.rim) sum += (f.points[edge.a].x * f.points[edge.b].y - f.points[edge.b].x * f.points[edge.a].y) / 2;
    return sum;
}

bool odd(int, int crossings) { return crossings % 2 != 0; }
bool wound(int winding, int) { return winding != 0; }

TEST(Filling, AStarIsFilledByItsRule) {
    std::vector<Vec2> star;
    for (int i = 0; i < 5; ++i) star.emplace_back(std::cos(0.1 + 4 * kPi * i / 5), std::sin(0.1 + 4 * kPi * i / 5));
    // The pentagon in the middle has the circumradius of the star over the square of the golden ratio.
    const double golden = (1 + std::sqrt(5.0)) / 2, pentagon = 2.5 * std::sin(2 * kPi / 5) / std::pow(golden, 4), all = 5 * std::sin(kPi / 5) / (golden * golden);
    const auto whole = meshing::fill({star}, wound), hollow = meshing::fill({star}, odd);
    EXPECT_NEAR(area_of(*whole), all, 1e-12);
    EXPECT_NEAR(area_of(*hollow), all - pentagon, 1e-12);
    EXPECT_NEAR(area_in_rim(*whole), all, 1e-12);
    for (const auto& edge : whole->rim) EXPECT_LT(*edge.line, 5u);
}

/// Random tangles of lines, beside the same question asked of random points.
TEST(Filling, TanglesAreFilledWhereTheyShould) {
    Draw draw(3);
    for (int round = 0; round < 30; ++round) {
        std::vector<std::vector<Vec2>> loops(1 + draw.below(3));
        for (auto& loop : loops)
            for (uint32_t i = 0; i < 3 + draw.below(7); ++i) loop.emplace_back(draw(-1, 1), round % 2 ? draw(-1, 1) : double(draw.below(5)) / 2 - 1);
        const auto filled = meshing::fill(loops, odd);
        ASSERT_TRUE(filled);
        EXPECT_NEAR(area_of(*filled), area_in_rim(*filled), 1e-9);
        for (int i = 0; i < 200; ++i) {
            const Vec2 p(draw(-1, 1), draw(-1, 1));
            bool inside = false, covered = false;
            for (const auto& loop : loops)
                for (size_t k = 0; k < loop.size(); ++k) {
                    const Vec2 a = loop[k], b = loop[(k + 1) % loop.size()];
                    if ((a.y <= p.y) != (b.y <= p.y) && a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) > p.x) inside = !inside;
                }
            for (const Index3& t : filled->triangles) {
                const auto left = [&](uint32_t a, uint32_t b) {
                    const Vec2 u = filled->points[b] - filled->points[a], v = p - filled->points[a];
                    return u.x * v.y - u.y * v.x >= 0;
                };
                covered = covered || (left(t.x, t.y) && left(t.y, t.z) && left(t.z, t.x));
            }
            EXPECT_EQ(covered, inside) << round;
        }
    }
}

/// Walls on the rim close a face only if its neighbours share all points with it.
/// Each line of a zigzag is split at the heights of all its corners.
TEST(Filling, WhatWouldBecomeTooManyLinesIsRefused) {
    std::vector<Vec2> zigzag;
    for (int i = 0; i < 2500; ++i) zigzag.emplace_back(i, i % 2 ? 1 + 1e-4 * i : -1e-4 * i);
    EXPECT_FALSE(meshing::fill({zigzag}, odd));
    zigzag.resize(500);
    EXPECT_TRUE(meshing::fill({zigzag}, odd));
}

TEST(Filling, TheRimGoesRound) {
    Draw draw(4);
    for (int round = 0; round < 30; ++round) {
        const auto filled = meshing::fill({ring(9, 1, 2, draw), ring(6, 0.3, 0.9, draw)}, odd);
        std::map<uint32_t, int> ends;
        for (const auto& edge : filled->rim) ++ends[edge.a], --ends[edge.b];
        for (const auto& [point, balance] : ends) EXPECT_EQ(balance, 0) << point;
        EXPECT_TRUE(std::all_of(filled->rim.begin(), filled->rim.end(), [](const auto& edge) { return edge.line.has_value(); }));
    }
}

TEST(PlaneFit, MeetsThePlanesItIsGiven) {
    Draw draw(5);
    for (int i = 0; i < 100; ++i) {
        const Vec3 tip = draw.vector(), a = draw.direction(), b = normalized(cross(a, draw.direction())), c = cross(a, b);
        meshing::PlaneFit corner, edge, flat;
        const Vec3 on_a = tip + 0.3 * b - 0.2 * c, on_b = tip + 0.1 * a + 0.4 * c, on_c = tip - 0.3 * a + 0.2 * b;
        corner.add(on_a, a), corner.add(on_b, b), corner.add(on_c, c);
        EXPECT_LT(length(corner.nearest() - tip), 1e-12);
        edge.add(on_a, a), edge.add(on_b, b);
        EXPECT_NEAR(dot(edge.nearest() - tip, a), 0, 1e-12);
        EXPECT_NEAR(dot(edge.nearest() - tip, b), 0, 1e-12);
        EXPECT_NEAR(dot(edge.nearest() - (on_a + on_b) / 2.0, c), 0, 1e-12) << "free along the edge";
        flat.add(on_a, a), flat.add(on_a + b, a);
        EXPECT_LT(length(flat.nearest() - (on_a + 0.5 * b)), 1e-12);
    }
}

}  // namespace
}  // namespace alidade::test
