// SPDX-License-Identifier: Apache-2.0
#include "topology/decimate.h"

#include "topology/half_edges.h"
#include "topology/wedges.h"

#include <OpenMesh/Core/Geometry/QuadricT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>

#include <cmath>

namespace alidade::topology {
namespace {

using Quadric = OpenMesh::Geometry::Quadricd;
using Wedge3 = std::array<uint32_t, 3>;

/// The squared distances from planes, weighted.
struct Error {
    Quadric sum;
    double weight = 0;

    /// From the plane through `point`.
    static Error plane(const Vec3& unit_normal, const Vec3& point, double weight) {
        Error e{Quadric(unit_normal.x, unit_normal.y, unit_normal.z, -dot(unit_normal, point)), weight};
        e.sum *= weight;
        return e;
    }
    Error& operator+=(const Error& other) {
        sum += other.sum, weight += other.weight;
        return *this;
    }
};

/// The root mean squared distance that a vertex may come to have from the planes it stands for, in sizes of the mesh: beyond, there is another shape.
constexpr double kMostShift = 0.05;

/// How much more a border or seam weighs than a triangle on the square over its edge: it must not move, even where the surface around is flat.
constexpr double kWallWeight = 10;

/// The cost of a collapse, and whether the attributes allow it. It carries the wedges of each face along.
template <class MeshT> class WedgeQuadricT : public OpenMesh::Decimater::ModBaseT<MeshT> {
  public:
    DECIMATING_MODULE(WedgeQuadricT, MeshT, WedgeQuadric)

    explicit WedgeQuadricT(MeshT& mesh) : Base(mesh, false) {}

    /// `faces`: the wedges of each face, by handle; `points`: the point of each wedge.
    void set_wedges(std::vector<Wedge3> faces, const std::vector<uint32_t>& points) { faces_ = std::move(faces), point_of_ = points; }
    const Wedge3& wedges(OpenMesh::FaceHandle face) const { return faces_[size_t(face.idx())]; }

    void initialize() override {
        errors_.assign(Base::mesh().n_vertices(), Error::plane(Vec3(0), Vec3(0), 0));
        for (const auto face : Base::mesh().faces()) add_plane(face);
        for (const auto edge : Base::mesh().edges()) add_walls(edge);
    }

    float collapse_priority(const CollapseInfo& c) override {
        for (const auto face : Base::mesh().vf_range(c.v0))
            if (face != c.fl && face != c.fr && moved(wedge_at(face, c.v0), c) == kNone) return float(Base::ILLEGAL_COLLAPSE);
        Error both = errors_[size_t(c.v0.idx())];
        both += errors_[size_t(c.v1.idx())];
        const double error = std::max(0.0, both.sum(c.p1));   // rounding may make it negative
        return error > kMostShift * kMostShift * both.weight ? float(Base::ILLEGAL_COLLAPSE) : float(error);
    }

    void preprocess_collapse(const CollapseInfo& c) override {
        for (const auto face : Base::mesh().vf_range(c.v0)) {
            if (face == c.fl || face == c.fr) continue;
            for (uint32_t& wedge : faces_[size_t(face.idx())])
                if (point_of_[wedge] == uint32_t(c.v0.idx())) wedge = moved(wedge, c);
        }
    }
    void postprocess_collapse(const CollapseInfo& c) override { errors_[size_t(c.v1.idx())] += errors_[size_t(c.v0.idx())]; }

  private:
    Vec3 point(OpenMesh::VertexHandle v) { return from_openmesh(Base::mesh().point(v)); }

    uint32_t wedge_at(OpenMesh::FaceHandle face, OpenMesh::VertexHandle vertex) const {
        for (const uint32_t wedge : wedges(face))
            if (point_of_[wedge] == uint32_t(vertex.idx())) return wedge;
        return kNone;
    }

    /// What becomes of a wedge at v0: the wedge at v1 on its side of the edge; kNone if there is none, or two.
    uint32_t moved(uint32_t wedge, const CollapseInfo& c) const {
        uint32_t to = kNone;
        for (const auto face : {c.fl, c.fr}) {
            if (!face.is_valid() || wedge_at(face, c.v0) != wedge) continue;
            const uint32_t there = wedge_at(face, c.v1);
            if (to != kNone && to != there) return kNone;
            to = there;
        }
        return to;
    }

    /// Twice the area, as a vector.
    Vec3 area(OpenMesh::FaceHandle face) {
        const Wedge3& w = wedges(face);
        const auto at = [&](int k) { return point(OpenMesh::VertexHandle(int(point_of_[w[size_t(k)]]))); };
        return cross(at(1) - at(0), at(2) - at(0));
    }

    void add_plane(OpenMesh::FaceHandle face) {
        const Vec3 normal = area(face);
        for (const uint32_t wedge : wedges(face)) {
            const OpenMesh::VertexHandle v{int(point_of_[wedge])};
            errors_[size_t(v.idx())] += Error::plane(normalized(normal), point(v), length(normal) / 2);
        }
    }

    /// Walls stand on the edges where a face ends, or its attributes do.
    void add_walls(OpenMesh::EdgeHandle edge) {
        const auto side = Base::mesh().halfedge_handle(edge, 0);
        const OpenMesh::FaceHandle one = Base::mesh().face_handle(side), other = Base::mesh().opposite_face_handle(side);
        const auto from = Base::mesh().from_vertex_handle(side), to = Base::mesh().to_vertex_handle(side);
        if (one.is_valid() && other.is_valid() && wedge_at(one, from) == wedge_at(other, from) && wedge_at(one, to) == wedge_at(other, to)) return;
        const Vec3 along = point(to) - point(from);
        for (const auto face : {one, other}) {
            if (!face.is_valid()) continue;
            const Error wall = Error::plane(normalized(cross(normalized(along), normalized(area(face)))), point(from), kWallWeight * dot(along, along));
            errors_[size_t(from.idx())] += wall;
            errors_[size_t(to.idx())] += wall;
        }
    }

    std::vector<Wedge3> faces_;
    std::vector<uint32_t> point_of_;
    std::vector<Error> errors_;
};

/// Errors are single numbers of float: the mesh is made to fit a unit box, so that they neither overflow nor vanish.
void make_unit_size(TriangleHalfEdges& mesh) {
    Bounds box;
    for (const auto v : mesh.vertices()) box.extend(from_openmesh(mesh.point(v)));
    const double size = max_component(box.extent());
    for (const auto v : mesh.vertices()) mesh.set_point(v, to_openmesh((from_openmesh(mesh.point(v)) - box.center()) / (size > 0 ? size : 1)));
}

/// Builds a mesh of triangles of wedges, numbering what they use.
class Rebuilder {
  public:
    Rebuilder(const Mesh& old, const Welded& surface, const Wedges& wedges)
        : old_(old), surface_(surface), wedges_(wedges), position_(surface.points.size(), kNone), wedge_(wedges.corner.size(), kNone) {
        out_.origin = old.origin;
        out_.uvs.resize(old.uvs.size());
        out_.colors.resize(old.colors.size());
    }

    void add(const Wedge3& triangle, uint32_t came_from) {
        out_.triangles.emplace_back(position(triangle[0]), position(triangle[1]), position(triangle[2]));
        if (!old_.slots.empty()) out_.slots.push_back(old_.slots[came_from]);
        for (const uint32_t w : triangle) corners_.push_back(wedge(w));
    }

    Mesh mesh() {
        for (auto& uv : out_.uvs) uv.corners = corners_;
        for (auto& color : out_.colors) color.corners = corners_;
        return std::move(out_);
    }

  private:
    uint32_t position(uint32_t wedge) {
        uint32_t& number = position_[wedges_.point[wedge]];
        if (number == kNone) {
            const uint32_t from = surface_.position_of[wedges_.point[wedge]];
            number = uint32_t(out_.positions.size());
            out_.positions.push_back(old_.positions[from]);
            if (!old_.exact_positions.empty()) out_.exact_positions.push_back(old_.exact_positions[from]);
        }
        return number;
    }

    uint32_t wedge(uint32_t wedge) {
        uint32_t& number = wedge_[wedge];
        if (number == kNone) {
            number = used_++;
            const uint32_t corner = wedges_.corner[wedge], t = corner / 3;
            const auto copy = [&](const auto& from, auto& to) { to.values.push_back(from.values[from.index(t, int(corner % 3), old_.triangles[t])]); };
            for (size_t i = 0; i < old_.uvs.size(); ++i) copy(old_.uvs[i], out_.uvs[i]);
            for (size_t i = 0; i < old_.colors.size(); ++i) copy(old_.colors[i], out_.colors[i]);
        }
        return number;
    }

    const Mesh& old_;
    const Welded& surface_;
    const Wedges& wedges_;
    Mesh out_;
    std::vector<uint32_t> position_, wedge_, corners_;   ///< new numbers by point and by wedge; wedges of the new corners
    uint32_t used_ = 0;
};

/// Calls keep(wedges, triangle it came from) for each triangle that is left.
template <class Keep> void collapse(HalfEdges& edges, const Wedges& wedges, size_t target, Keep keep) {
    std::vector<Wedge3> faces;
    for (const uint32_t t : edges.triangle_of) faces.push_back({wedges.of_corner[3 * t], wedges.of_corner[3 * t + 1], wedges.of_corner[3 * t + 2]});
    make_unit_size(edges.mesh);
    edges.mesh.request_face_normals();
    edges.mesh.update_face_normals();
    OpenMesh::Decimater::DecimaterT<TriangleHalfEdges> decimater(edges.mesh);
    WedgeQuadricT<TriangleHalfEdges>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<TriangleHalfEdges>::Handle flipping;
    decimater.add(quadric);
    decimater.add(flipping);
    decimater.module(quadric).set_wedges(std::move(faces), wedges.point);
    decimater.initialize();
    decimater.decimate_to_faces(0, target);
    for (size_t f = 0; f < edges.triangle_of.size(); ++f) {
        const OpenMesh::FaceHandle face{int(f)};
        if (!edges.mesh.status(face).deleted()) keep(decimater.module(quadric).wedges(face), edges.triangle_of[f]);
    }
}

}  // namespace

tl::expected<Mesh, std::string> decimate(const Mesh& mesh, double ratio) {
    if (!mesh.joint_sets.empty() || !mesh.morphs.empty()) return tl::unexpected(std::string("it is skinned or morphed"));
    const Welded surface = weld(mesh);
    HalfEdges edges = half_edges(surface);
    if (!edges.manifold) return tl::unexpected(std::string("its surface is not manifold, or not wound consistently"));
    std::vector<uint32_t> corners;
    for (const uint32_t t : edges.triangle_of)
        for (int k = 0; k < 3; ++k) corners.push_back(surface.triangles[t][k]);
    if (crowding(corners, surface.points.size(), 3) > 10 * kMostSteps) return tl::unexpected(std::string("it has too many triangles around one vertex"));
    const Wedges wedges = wedges_of(mesh, surface);
    Rebuilder rebuilder(mesh, surface, wedges);
    const size_t target = size_t(std::ceil(ratio * double(edges.triangle_of.size())));
    collapse(edges, wedges, std::max<size_t>(target, 1), [&](const Wedge3& triangle, uint32_t came_from) { rebuilder.add(triangle, came_from); });
    return rebuilder.mesh();
}

}  // namespace alidade::topology
