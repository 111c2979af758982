// SPDX-License-Identifier: Apache-2.0
#include "topology/subdivide.h"

#include "topology/half_edges.h"
#include "topology/polygons.h"

#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

namespace alidade::topology {
namespace {

constexpr const char* kNotManifold = "its surface is not manifold, not wound consistently, or has too many faces around one vertex";

/// The polygons as half-edges; face and vertex handles are their numbers.
template <class HalfEdgeMesh> struct Net {
    HalfEdgeMesh mesh;
    std::vector<uint32_t> edge_of;   ///< by corner: the edge from it to the next
    bool manifold = true;
};

template <class HalfEdgeMesh> Net<HalfEdgeMesh> net_of(const Polygons& polygons) {
    silence_openmesh();
    Net<HalfEdgeMesh> net;
    net.manifold = crowding(polygons.corners, polygons.points.size(), 2) <= kMostSteps;
    for (const Vec3& p : polygons.points) net.mesh.add_vertex(to_openmesh(p));
    std::vector<OpenMesh::VertexHandle> corners;
    for (size_t p = 0; p < polygons.count() && net.manifold; ++p) {
        corners.clear();
        for (uint32_t c = polygons.first[p]; c < polygons.first[p + 1]; ++c) corners.emplace_back(int(polygons.corners[c]));
        net.manifold = net.mesh.add_face(corners).is_valid();
    }
    for (const auto v : net.mesh.vertices()) net.manifold = net.manifold && net.mesh.is_manifold(v);
    if (!net.manifold) return net;
    net.edge_of.resize(polygons.corners.size());
    for (const auto face : net.mesh.faces()) {
        const uint32_t first = polygons.first[size_t(face.idx())], end = polygons.first[size_t(face.idx()) + 1];
        auto side = net.mesh.halfedge_handle(face);
        while (uint32_t(net.mesh.from_vertex_handle(side).idx()) != polygons.corners[first]) side = net.mesh.next_halfedge_handle(side);
        for (uint32_t c = first; c < end; ++c, side = net.mesh.next_halfedge_handle(side)) net.edge_of[c] = uint32_t(net.mesh.edge_handle(side).idx());
    }
    return net;
}

/// What a border vertex becomes: a cubic B-spline's vertex. Loop's of OpenMesh do; its Catmull-Clark's take 1/6, 2/3, 1/6, whose limit is no B-spline.
std::vector<std::pair<size_t, Vec3>> border_points(const PolygonHalfEdges& mesh) {
    std::vector<std::pair<size_t, Vec3>> out;
    for (const auto v : mesh.vertices()) {
        if (!mesh.is_boundary(v) || mesh.is_isolated(v)) continue;
        const auto leaving = mesh.halfedge_handle(v);   // along the border, as OpenMesh keeps it
        const auto p = mesh.point(v) * 0.75 + (mesh.point(mesh.to_vertex_handle(leaving)) + mesh.point(mesh.from_vertex_handle(mesh.prev_halfedge_handle(leaving)))) * 0.125;
        out.emplace_back(size_t(v.idx()), from_openmesh(p));
    }
    return out;
}

/// One step of an OpenMesh subdivider. It is called with the mesh instead of being attached to it: one that is still attached when it is destroyed
/// calls a pure virtual function. The new vertices come after the old ones: one an edge, then (Catmull-Clark) one a face, each in their order.
template <class Subdivider, class HalfEdgeMesh> std::vector<Vec3> refined_points(HalfEdgeMesh& mesh) {
    Subdivider subdivider;
    if constexpr (requires { subdivider.init_weights(size_t(1)); }) {
        size_t valence = 0;
        for (const auto v : mesh.vertices()) valence = std::max<size_t>(valence, mesh.valence(v));
        subdivider.init_weights(valence + 1);   // its table has 50 rows, and is read without a look at its size
    }
    subdivider(mesh, 1);
    std::vector<Vec3> points;
    for (const auto v : mesh.vertices()) points.push_back(from_openmesh(mesh.point(v)));
    return points;
}

/// The numbering of what refinement makes of corners: the old ones, then the middles of sides, then (if asked for) the middles of polygons. For the
/// vertices themselves, and for each channel.
struct Refined {
    uint32_t sides, middles;              ///< the number of the first middle of a side, and of a polygon
    std::vector<uint32_t> side_of;        ///< by corner: the middle of the side that begins there, counted from `sides`

    /// The corners of Catmull and Clark's quads, or of Loop's triangles.
    std::vector<uint32_t> children(const Polygons& parents, const std::vector<uint32_t>& corners, bool quads) const {
        std::vector<uint32_t> out;
        out.reserve(4 * corners.size());
        for (size_t p = 0; p < parents.count(); ++p) {
            const uint32_t first = parents.first[p], end = parents.first[p + 1];
            for (uint32_t c = first; c < end; ++c) {
                const uint32_t before = c == first ? end - 1 : c - 1;
                out.insert(out.end(), {corners[c], sides + side_of[c]});
                if (quads) out.push_back(middles + uint32_t(p));
                out.push_back(sides + side_of[before]);
            }
            for (uint32_t c = first; !quads && c < end; ++c) out.push_back(sides + side_of[c]);
        }
        return out;
    }
};

/// The two sides of an edge share their middle if the channel has the same values there, and have two where a seam runs.
Channel refine(const Channel& channel, const Polygons& parents, const std::vector<uint32_t>& edge_of, size_t edges, bool quads) {
    struct Middle {
        uint32_t low = kNone, high = kNone, number = 0;
    };
    std::vector<Middle> at_edge(edges);
    Channel out{channel.values, {}};
    Refined numbers{uint32_t(channel.values.size()), 0, std::vector<uint32_t>(parents.corners.size())};
    for (size_t p = 0; p < parents.count(); ++p)
        for (uint32_t c = parents.first[p]; c < parents.first[p + 1]; ++c) {
            const uint32_t next = c + 1 == parents.first[p + 1] ? parents.first[p] : c + 1;
            const auto [low, high] = std::minmax(channel.corners[c], channel.corners[next]);
            Middle& middle = at_edge[edge_of[c]];
            if (middle.low != low || middle.high != high) {
                middle = {low, high, uint32_t(out.values.size()) - numbers.sides};
                out.values.push_back(0.5f * (channel.values[low] + channel.values[high]));
            }
            numbers.side_of[c] = middle.number;
        }
    numbers.middles = uint32_t(out.values.size());
    for (size_t p = 0; quads && p < parents.count(); ++p) {
        Vec4f sum(0);
        for (uint32_t c = parents.first[p]; c < parents.first[p + 1]; ++c) sum += channel.values[channel.corners[c]];
        out.values.push_back(sum / float(parents.first[p + 1] - parents.first[p]));
    }
    out.corners = numbers.children(parents, channel.corners, quads);
    return out;
}

/// The refined net around the points that the subdivider has made.
Polygons refine(const Polygons& parents, const std::vector<uint32_t>& edge_of, std::vector<Vec3> points, bool quads) {
    const uint32_t vertices = uint32_t(parents.points.size()), faces = quads ? uint32_t(parents.count()) : 0;
    const uint32_t edges = uint32_t(points.size()) - vertices - faces;
    Polygons out;
    out.points = std::move(points);
    out.corners = Refined{vertices, vertices + edges, edge_of}.children(parents, parents.corners, quads);
    const uint32_t width = quads ? 4 : 3;
    for (uint32_t end = width; end <= out.corners.size(); end += width) out.first.push_back(end);
    for (size_t p = 0; p < parents.slots.size(); ++p)
        out.slots.insert(out.slots.end(), quads ? parents.first[p + 1] - parents.first[p] : 4, parents.slots[p]);
    for (const Channel& channel : parents.channels) out.channels.push_back(refine(channel, parents, edge_of, edges, quads));
    return out;
}

/// False if the polygons are not manifold.
template <class Subdivider, class HalfEdgeMesh> bool step(Polygons& polygons, bool quads) {
    Net<HalfEdgeMesh> net = net_of<HalfEdgeMesh>(polygons);
    if (!net.manifold) return false;
    std::vector<std::pair<size_t, Vec3>> border;
    if constexpr (std::is_same_v<HalfEdgeMesh, PolygonHalfEdges>) border = border_points(net.mesh);
    std::vector<Vec3> points = refined_points<Subdivider>(net.mesh);
    for (const auto& [vertex, point] : border) points[vertex] = point;
    polygons = refine(polygons, net.edge_of, std::move(points), quads);
    return true;
}

}  // namespace

tl::expected<Mesh, std::string> subdivide(const Mesh& mesh, int levels) {
    namespace uniform = OpenMesh::Subdivider::Uniform;
    if (!mesh.joint_sets.empty() || !mesh.morphs.empty()) return tl::unexpected(std::string("it is skinned or morphed"));
    Polygons polygons = polygons_of(mesh, weld(mesh));
    const bool quads = !polygons.all_triangles();
    for (int level = 0; level < levels; ++level)
        if (!(quads ? step<uniform::CatmullClarkT<PolygonHalfEdges>, PolygonHalfEdges>(polygons, true)
                    : step<uniform::LoopT<TriangleHalfEdges>, TriangleHalfEdges>(polygons, false)))
            return tl::unexpected(std::string(kNotManifold));
    return mesh_of(polygons, mesh);
}

uint64_t subdivided_triangles(const Mesh& mesh, int levels) {
    const Welded surface = weld(mesh);
    const Polygons polygons = polygons_of(mesh, surface);
    const uint64_t once = polygons.all_triangles() ? 4 * polygons.count() : 2 * polygons.corners.size();
    return levels == 0 ? mesh.triangles.size() : once << 2 * (std::min(levels, kMostLevels) - 1);
}

}  // namespace alidade::topology
