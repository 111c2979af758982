// SPDX-License-Identifier: Apache-2.0
/// Closed-form shapes: the table of what can be asked of each. A shape is one file and one row.
#pragma once

#include "core/bounds.h"
#include "core/ray.h"
#include "core/short_list.h"
#include "scene/shape.h"

#include <optional>
#include <span>

namespace alidade {

/// Where the line of a ray crosses a surface.
struct Crossing {
    double t = 0;
    uint32_t part = 0;
};

/// The crossings of one line, in order of t.
struct Crossings {
    ShortList<Crossing, 8> at;
    int count = 0;
    std::optional<bool> begins_inside;   ///< is the line inside before the first? Set where that is known anyway, and always where crossings before it were left out
    void add(double t, uint32_t part) { at.push_back({t, part}), ++count; }
};

/// Which crossings of a line are asked for, by the interval tmin .. tmax of a ray. What is told of others takes no time: they may be anywhere on their side of it.
enum class Wanted : uint8_t {
    all,     ///< those in the interval
    first,   ///< the first of them: later ones may be missing
    any,     ///< whether there is one: as `first`, and that one may be anywhere in the interval
};

/// What shading needs of a point on a shape, in the shape's space.
struct SurfacePoint {
    Vec3 normal{0, 0, 1};     ///< geometric, unit, outward
    Vec2 uv{0};               ///< POV-Ray's uv_mapping of the shape (manual, 3.4.6.5.5 "UV mapping")
    Vec3 dpdu{1, 0, 0}, dpdv{0, 1, 0};
};

struct ShapeOps {
    const char* name;
    const char* doc;
    size_t kind;                                                         ///< the index of its struct in ShapeGeometry
    Bounds (*bounds)(const ShapeGeometry&);                              ///< infinite where the shape is
    /// All crossings of the whole line of the ray (its tmin and tmax do not matter). With bounds b: entry(b) <= t <= exit(b), as computed in double.
    Crossings (*crossings)(const ShapeGeometry&, const Ray&);
    /// The distance of ray.at(t), a crossing with that part, from the true surface along its normal. Asked where a surface is shaded, and not at each crossing.
    ErrorBound (*error)(const ShapeGeometry&, const Ray&, double t, uint32_t part);
    SurfacePoint (*surface)(const ShapeGeometry&, const Vec3& point, uint32_t part);
    bool (*inside)(const ShapeGeometry&, const Vec3& point);             ///< on the surface counts as inside
    /// Do the crossings bound what is inside, so that the line is in and out by turns? Not those of a disc, of a cylinder or cone without caps, or of a torus that overlaps itself.
    bool (*solid)(const ShapeGeometry&);
    /// A box around what is inside (`outside`: outside or on the surface) of the shape within a box, whose sides may be infinite. Null: `bounds` says all.
    Bounds (*narrow)(const ShapeGeometry&, bool outside, const Bounds& box) = nullptr;
    bool costly = false;                                                 ///< crossings cost many times those of a quadric
    /// That of surface(), alone. Null: it costs no less than all of surface().
    Vec3 (*normal)(const ShapeGeometry&, const Vec3& point, uint32_t part) = nullptr;
    /// Those of crossings() that are wanted, bit for bit; the box is that of bounds(). Null: they take as long as all.
    Crossings (*wanted)(const ShapeGeometry&, const Bounds& own, const Ray&, Wanted) = nullptr;
    bool convex = false;                                                 ///< what is between points that are inside is inside, too
    bool sheet = false;                                                  ///< nothing is inside, like in a mesh, also of one that is turned inside out
    /// Which way the surface is shaded, and faces, where that is not by its normal. Null: it is.
    Vec3 (*shading_normal)(const ShapeGeometry&, const Vec3& point) = nullptr;

    /// As `wanted`, for directions of any length: the forms multiply them with themselves, which must neither overflow nor be lost.
    Crossings crossings_wanted(const ShapeGeometry& shape, const Bounds& own, const Ray& ray, Wanted what) const {
        const double speed = max_abs(ray.dir);
        if (!(speed >= 1 / kLargestSpeed && speed <= kLargestSpeed)) [[unlikely]] return crossings_at_unit_speed(shape, own, ray);
        return wanted ? wanted(shape, own, ray, what) : crossings(shape, ray);
    }
    Vec3 normal_at(const ShapeGeometry& shape, const Vec3& point, uint32_t part) const { return normal ? normal(shape, point, part) : surface(shape, point, part).normal; }

  private:
    static constexpr double kLargestSpeed = 0x1p100;
    /// All crossings, found with the direction times a power of two, in the ray's own t.
    Crossings crossings_at_unit_speed(const ShapeGeometry& shape, const Bounds& own, const Ray& ray) const;
};

/// The parts of an extrusion from here on are its sides; those before are its two flat faces.
inline constexpr uint32_t kExtrusionSides = 2;

/// One row for each closed-form shape. Meshes have none: accel/ intersects them.
std::span<const ShapeOps> shapes();
const ShapeOps* find_shape(const ShapeGeometry& geometry);

}  // namespace alidade
