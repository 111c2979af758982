// SPDX-License-Identifier: Apache-2.0
#include "exporters/meshing/shape_mesh.h"

#include "eval/shapes/outlines.h"
#include "exporters/meshing/fill.h"
#include "exporters/meshing/revolution.h"

namespace alidade::meshing {
namespace {

class ShapeMesh {
  public:
    ShapeMesh(int segments, const Bounds& region) : segments_(segments), region_(region) {}

    bool make(const Sphere& s) {
        return turn(arc_pieces(Vec2(0), std::abs(s.radius), -kPi / 2, kPi / 2, (segments_ + 1) / 2), s.center, Vec3(0, 1, 0));
    }

    bool make(const Plane& p) {
        const double size = length(p.normal);
        const Vec3 normal = p.normal / size, middle = region_.center();
        const Vec3 foot = middle - (dot(normal, middle) - p.distance) * normal;
        Vec3 s, t;
        orthonormal_basis(normal, s, t);
        const double half = length(region_.extent()) / 2;
        const uint32_t n = out.normal(normal);
        out.quad({out.position(foot - half * s - half * t), out.position(foot + half * s - half * t), out.position(foot + half * s + half * t),
                  out.position(foot - half * s + half * t)}, {n, n, n, n});
        return true;
    }

    bool make(const Box& box) {
        const Bounds b{glm::min(box.a, box.b), glm::max(box.a, box.b)};
        std::array<uint32_t, 8> corner;
        for (unsigned i = 0; i < 8; ++i) corner[i] = out.position({i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z});
        for (int axis = 0; axis < 3; ++axis)
            for (const bool upper : {false, true}) {
                Vec3 normal(0);
                normal[axis] = upper ? 1 : -1;
                const uint32_t n = out.normal(normal);
                const unsigned base = upper ? 1u << axis : 0, u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3, first = upper ? u : v, second = upper ? v : u;
                out.quad({corner[base], corner[base + first], corner[base + u + v], corner[base + second]}, {n, n, n, n});
            }
        return true;
    }

    bool make(const Disc& d) { return turn({straight_piece({std::abs(d.radius), 0}, {std::abs(d.hole), 0})}, d.center, normalized(d.normal)); }
    bool make(const Cylinder& c) { return make(Cone{c.a, c.b, std::abs(c.radius), std::abs(c.radius), c.open}); }

    bool make(const Cone& c) {
        const double height = length(c.b - c.a), a = std::abs(c.radius_a), b = std::abs(c.radius_b);
        std::vector<ProfilePiece> profile;
        const auto add = [&](const Vec2& from, const Vec2& to) {
            if (from != to) profile.push_back(straight_piece(from, to));
        };
        if (!c.open) add({0, 0}, {a, 0});
        if (c.radius_a * c.radius_b < 0) {
            const Vec2 tip(0, height * (a / (a + b)));
            add({a, 0}, tip), add(tip, {b, height});
        } else {
            add({a, 0}, {b, height});
        }
        if (!c.open) add({b, height}, {0, height});
        return turn(profile, c.a, normalized(c.b - c.a));
    }

    bool make(const Torus& t) {
        const double major = std::abs(t.major), minor = std::abs(t.minor);
        if (minor <= major) return turn(arc_pieces({major, 0}, minor, -kPi, kPi, segments_), t.center, Vec3(0, 1, 0), true);
        const double end = std::acos(-major / minor);   // where the circle meets the axis
        return turn(arc_pieces({major, 0}, minor, -end, end, segments_), t.center, Vec3(0, 1, 0));
    }

    bool make(const Polygon& p) {
        const Vec3 normal = normal_of(p);
        if (normal == Vec3(0)) return false;
        Vec3 s, t;
        orthonormal_basis(normal, s, t);
        const Vec3 base = p.loops[0][0];
        std::vector<std::vector<Vec2>> loops;
        for (const auto& loop : p.loops) {
            auto& flat = loops.emplace_back();
            for (const Vec3& point : loop) flat.emplace_back(dot(point - base, s), dot(point - base, t));
        }
        const auto filled = fill(loops, [](int, int crossings) { return crossings % 2 != 0; });
        if (!filled) return false;
        face(*filled, normal, false, [&](const Vec2& at) { return base + at.x * s + at.y * t; });
        return true;
    }

    bool make(const Extrusion& e) {
        std::vector<size_t> arcs;
        const auto filled = fill(flatten(e, arcs), [&](int winding, int crossings) { return is_inside(e, winding, crossings); });
        if (!filled) return false;
        const double low = std::min(e.bottom, e.top), high = std::max(e.bottom, e.top);
        const auto above = face(*filled, Vec3(0, 0, 1), false, [&](const Vec2& at) { return Vec3(at.x, at.y, high); });
        const auto below = face(*filled, Vec3(0, 0, -1), true, [&](const Vec2& at) { return Vec3(at.x, at.y, low); });
        for (const auto& [a, b, line] : filled->rim) {
            const Vec2 &from = filled->points[a], &to = filled->points[b];
            const BezierArc arc = line ? arc_of(e, arcs[*line], Vec2(0)) : BezierArc{from, from, to};
            const uint32_t na = wall_normal(arc, from, to), nb = wall_normal(arc, to, from, -1);
            out.quad({below[a], below[b], above[b], above[a]}, {na, nb, nb, na});
        }
        return true;
    }

    bool make(const Quadric&) { return false; }
    bool make(const Polynomial&) { return false; }
    bool make(const Mesh&) { return false; }

    TriangleList out;

  private:
    bool turn(std::vector<ProfilePiece> profile, const Vec3& base, const Vec3& axis, bool closed = false) {
        if (profile.empty()) return true;
        if (closed) profile.back().b = profile.front().a;
        else for (Vec2* end : {&profile.front().a, &profile.back().b})
            if (std::abs(end->x) < 1e-12 * std::abs(end->y)) end->x = 0;   // the pole of a sphere, but for rounding
        revolve(profile, base, axis, segments_, out);
        return true;
    }

    /// A filled face as triangles; the positions of its points.
    template <class F> std::vector<uint32_t> face(const Filled& filled, const Vec3& normal, bool turned, const F& place) {
        std::vector<uint32_t> positions;
        for (const Vec2& point : filled.points) positions.push_back(out.position(place(point)));
        const uint32_t n = out.normal(normal);
        for (const Index3& t : filled.triangles) out.triangle({positions[t.x], positions[turned ? t.z : t.y], positions[turned ? t.y : t.z]}, {n, n, n});
        return positions;
    }

    /// A curve's lines lie as near to it as those of a circle of its size: n of them are |a - 2 control + b| / (4 n^2) away at most.
    int steps_of(const BezierArc& arc) const {
        const auto size = [](const Vec2& v) { return std::hypot(v.x, v.y); };
        if (arc.control == arc.a || arc.control == arc.b) return 1;
        const double away = size(arc.a - 2.0 * arc.control + arc.b) / 4, radius = std::max(size(arc.control - arc.a), size(arc.b - arc.control));
        return std::clamp(int(std::ceil(std::sqrt(away / (radius * (1 - std::cos(kPi / segments_)))))), 1, segments_);
    }

    /// Outlines as lines, and the arc of each line.
    std::vector<std::vector<Vec2>> flatten(const Extrusion& e, std::vector<size_t>& arcs) const {
        std::vector<std::vector<Vec2>> loops;
        size_t index = 0;
        for (const Outline& outline : e.outlines) {
            auto& loop = loops.emplace_back();
            for (size_t i = 0; i < outline.points.size() / 2; ++i, ++index) {
                const BezierArc arc = arc_of(e, index, Vec2(0));
                const int steps = steps_of(arc);
                for (int k = 0; k < steps; ++k) loop.push_back(arc.at(double(k) / steps)), arcs.push_back(index);
            }
        }
        return loops;
    }

    /// The normal of the curve at a point from which a wall goes to `next`, with the inside on its left, or on its right (`side` -1).
    uint32_t wall_normal(const BezierArc& arc, const Vec2& at, const Vec2& next, double side = 1) {
        const Vec2 step = side * (next - at), tangent = arc.tangent(arc.nearest(at));
        const double along = step.x * tangent.x + step.y * tangent.y;
        const Vec2 d = along == 0 ? step : along > 0 ? tangent : -tangent;
        return out.normal(normalized(Vec3(d.y, -d.x, 0)));
    }

    int segments_;
    Bounds region_;
};

}  // namespace

std::optional<TriangleList> shape_mesh(const ShapeGeometry& shape, int segments, const Bounds& region) {
    ShapeMesh maker(segments, region);
    const bool made = std::visit([&](const auto& s) { return maker.make(s); }, shape);
    return made ? std::optional(std::move(maker.out)) : std::nullopt;
}

}  // namespace alidade::meshing
