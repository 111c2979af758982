// SPDX-License-Identifier: Apache-2.0
#include "numerics/triangles/rays.h"

#include "core/draws.h"

#include <fmt/format.h>

namespace alidade::numerics {
namespace {

Ray ray_to(const Vec3& origin, const Vec3& target) {
    Ray ray;
    ray.origin = origin, ray.dir = target - origin;
    return ray;
}

uint32_t any_triangle(const TriangleMesh& mesh, Draws& draws) { return draws.below(mesh.triangles.size()); }
const Vec3& any_vertex(const TriangleMesh& mesh, Draws& draws) { return mesh.corner(any_triangle(mesh, draws), int(draws.below(3))); }

Vec3 point_on_triangle(const TriangleMesh& mesh, uint32_t triangle, Draws& draws) {
    double u = draws.uniform(), v = draws.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3 a = mesh.corner(triangle, 0), b = mesh.corner(triangle, 1), c = mesh.corner(triangle, 2);
    return a + u * (b - a) + v * (c - a);
}

/// Half of the points are 1/16 steps along the edge.
Vec3 point_on_edge(const TriangleMesh& mesh, Draws& draws) {
    const uint32_t triangle = any_triangle(mesh, draws);
    const int k = int(draws.below(3));
    const Vec3 a = mesh.corner(triangle, k), b = mesh.corner(triangle, (k + 1) % 3);
    const double s = draws.coin() ? draws.below(17) / 16.0 : draws.uniform();
    return a + s * (b - a);
}

/// In a box of twice the size of the mesh.
Vec3 origin_around(const TriangleMesh& mesh, Draws& draws) {
    const Bounds box = mesh.bounds();
    const Vec3 reach = box.extent() * 0.5;
    return draws.in_box(box.min - reach, box.max + reach);
}

Ray random_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key);
    const Vec3 origin = origin_around(mesh, draws);
    return ray_to(origin, point_on_triangle(mesh, any_triangle(mesh, draws), draws));
}

/// Aimed at nothing; most of them miss, many closely.
Ray stray_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key);
    Ray ray;
    ray.origin = origin_around(mesh, draws);
    ray.dir = draws.direction() * mesh.bounds().extent();
    return ray;
}

Ray far_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key);
    const Bounds box = mesh.bounds();
    const double distance = std::pow(10.0, draws.uniform(1, 7)) * max_component(box.extent());
    const Vec3 origin = box.center() + distance * draws.direction();
    return ray_to(origin, point_on_triangle(mesh, any_triangle(mesh, draws), draws));
}

/// Origin and target have their coordinates from vertices, each from another one: rays in many planes of the mesh.
Ray lattice_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key);
    Vec3 origin, target;
    for (int axis = 0; axis < 3; ++axis) origin[axis] = any_vertex(mesh, draws)[axis], target[axis] = any_vertex(mesh, draws)[axis];
    Ray ray = ray_to(origin, target);
    if (max_abs(ray.dir) == 0) ray.dir[int(draws.below(3))] = draws.sign();
    return ray;
}

/// Along an axis through a vertex, an edge or a face, from outside; the two other components of the direction are +-`minor`.
Ray axis_ray(const TriangleMesh& mesh, const RandomKey& key, double minor) {
    Draws draws(key);
    const uint32_t kind = draws.below(3), triangle = any_triangle(mesh, draws);
    const Vec3 target = kind == 0 ? any_vertex(mesh, draws) : kind == 1 ? point_on_edge(mesh, draws) : point_on_triangle(mesh, triangle, draws);
    const Bounds box = mesh.bounds();
    const int axis = int(draws.below(3));
    const double sign = draws.sign(), size = max_component(box.extent());
    Ray ray = ray_to(target, target);
    ray.dir = Vec3(draws.coin() ? minor : -minor, draws.coin() ? minor : -minor, draws.coin() ? minor : -minor);
    ray.dir[axis] = sign * (draws.coin() ? 1.0 : size);
    ray.origin[axis] = sign > 0 ? box.min[axis] - size : box.max[axis] + size;
    return ray;
}

Ray axis_ray_zero(const TriangleMesh& mesh, const RandomKey& key) { return axis_ray(mesh, key, 0.0); }
Ray axis_ray_denormal(const TriangleMesh& mesh, const RandomKey& key) { return axis_ray(mesh, key, 4.9e-324); }
Ray axis_ray_tiny(const TriangleMesh& mesh, const RandomKey& key) { return axis_ray(mesh, key, 1e-42); }  // denormal when rounded to float

/// Parallel to an axis, a few ulps of float beside a vertex: on the padded planes of boxes.
Ray axis_ray_beside(const TriangleMesh& mesh, const RandomKey& key) {
    Ray ray = axis_ray(mesh, key, 0.0);
    Draws draws(key.child(1));
    for (int axis = 0; axis < 3; ++axis) {
        float beside = float(ray.origin[axis]);
        for (uint32_t ulps = draws.below(9); ulps > 0; --ulps)
            beside = std::nextafter(beside, float(draws.sign()) * std::numeric_limits<float>::infinity());
        ray.origin[axis] = double(beside);
    }
    return ray;
}

/// Meets the plane of a triangle, at a point of it, under `angle` radians.
Ray grazing_ray(const TriangleMesh& mesh, const RandomKey& key, double angle) {
    Draws draws(key);
    const uint32_t triangle = any_triangle(mesh, draws);
    const Vec3 a = mesh.corner(triangle, 0), b = mesh.corner(triangle, 1), c = mesh.corner(triangle, 2);
    const Vec3 n = normalized(cross(normalized(b - a), normalized(c - a)));
    const Vec3 along = normalized(draws.uniform(-1, 1) * normalized(b - a) + draws.uniform(-1, 1) * normalized(c - a));
    Ray ray;
    ray.dir = along + (draws.coin() ? angle : -angle) * n;
    ray.origin = point_on_triangle(mesh, triangle, draws) - draws.uniform(0, 2) * length(b - a) * ray.dir;
    return ray;
}

Ray grazing_ray_3(const TriangleMesh& mesh, const RandomKey& key) { return grazing_ray(mesh, key, 1e-3); }
Ray grazing_ray_6(const TriangleMesh& mesh, const RandomKey& key) { return grazing_ray(mesh, key, 1e-6); }
Ray grazing_ray_9(const TriangleMesh& mesh, const RandomKey& key) { return grazing_ray(mesh, key, 1e-9); }

Ray edge_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key);
    const Vec3 origin = origin_around(mesh, draws);
    return ray_to(origin, point_on_edge(mesh, draws));
}

Ray vertex_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key);
    const Vec3 origin = origin_around(mesh, draws);
    return ray_to(origin, any_vertex(mesh, draws));
}

/// Starts on the surface: at a vertex, on an edge, or on a face as well as double can say it.
Ray surface_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key);
    const uint32_t kind = draws.below(3), triangle = any_triangle(mesh, draws);
    Ray ray;
    ray.origin = kind == 0 ? any_vertex(mesh, draws) : kind == 1 ? point_on_edge(mesh, draws) : point_on_triangle(mesh, triangle, draws);
    ray.dir = draws.direction() * mesh.bounds().extent();
    return ray;
}

/// |dir| from 1e-30 to 1e30.
Ray any_length_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Ray ray = random_ray(mesh, key);
    ray.dir = normalized(ray.dir) * std::pow(10.0, Draws(key.child(1)).uniform(-30, 30));
    return ray;
}

Ray whole_line(const TriangleMesh& mesh, const RandomKey& key) {
    Ray ray = random_ray(mesh, key);
    ray.tmin = -kInf;
    return ray;
}

/// Numbers of any magnitude, but for origins beyond float. Nothing can be aimed so, but nothing may break.
Ray wild_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key.child(1));
    const auto wild = [&](double largest = 308) { return draws.below(4) == 0 ? 0.0 : draws.sign() * std::pow(10.0, draws.uniform(-320, largest)); };
    Ray ray = random_ray(mesh, key);
    for (int axis = 0; axis < 3; ++axis) {
        if (draws.coin()) ray.origin[axis] = wild(38);
        if (draws.coin()) ray.dir[axis] = wild();
    }
    if (draws.coin()) ray.tmin = -std::abs(wild()), ray.tmax = std::abs(wild());
    if (max_abs(ray.dir) == 0) ray.dir.x = 1;
    return ray;
}

/// The point aimed at has t = 1; the interval ends before it, holds it, or begins behind it.
Ray short_ray(const TriangleMesh& mesh, const RandomKey& key) {
    Ray ray = random_ray(mesh, key);
    Draws draws(key.child(1));
    ray.tmin = draws.uniform(-0.5, 1.1);
    ray.tmax = ray.tmin + draws.uniform(0, 1);
    return ray;
}

constexpr RayClass kClasses[] = {
    {"random", 0.9, random_ray},
    {"stray", 0.1, stray_ray},
    {"far", 0.8, far_ray},
    {"lattice", 0.2, lattice_ray},
    {"axis-parallel, others 0 or -0", 0.7, axis_ray_zero},
    {"axis-parallel, others denormal", 0.7, axis_ray_denormal},
    {"axis-parallel, others 1e-42", 0.7, axis_ray_tiny},
    {"axis-parallel, ulps beside a vertex", 0.5, axis_ray_beside},
    {"grazing 1e-3", 0.5, grazing_ray_3},
    {"grazing 1e-6", 0.3, grazing_ray_6},
    {"grazing 1e-9", 0.3, grazing_ray_9},
    {"edge-aimed", 0.5, edge_ray},
    {"vertex-aimed", 0.5, vertex_ray},
    {"from the surface", 0.4, surface_ray},
    {"length 1e-30 to 1e30", 0.9, any_length_ray},
    {"whole line", 0.9, whole_line},
    {"short interval", 0.4, short_ray},
    {"wild numbers", 0.05, wild_ray},
};

Vec3 origin_inside(const TriangleMesh& mesh, Draws& draws) {
    Vec3 at = draws.in_box(Vec3(0), Vec3(1));
    if (draws.coin())
        for (int axis = 0; axis < 3; ++axis) at[axis] = std::floor(at[axis] * 16) / 16;
    return mesh.inside.min + at * mesh.inside.extent();
}

}  // namespace

std::span<const RayClass> ray_classes() { return kClasses; }

Ray edge_aimed_from_inside(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key);
    const Vec3 origin = origin_inside(mesh, draws);
    return ray_to(origin, point_on_edge(mesh, draws));
}

Ray vertex_aimed_from_inside(const TriangleMesh& mesh, const RandomKey& key) {
    Draws draws(key);
    const Vec3 origin = origin_inside(mesh, draws);
    return ray_to(origin, any_vertex(mesh, draws));
}

std::string describe(const Ray& ray) {
    return fmt::format("origin ({:a}, {:a}, {:a}) dir ({:a}, {:a}, {:a}) tmin {:a} tmax {:a}", ray.origin.x, ray.origin.y, ray.origin.z, ray.dir.x,
                       ray.dir.y, ray.dir.z, ray.tmin, ray.tmax);
}

}  // namespace alidade::numerics
