// SPDX-License-Identifier: Apache-2.0
/// The report against numbers known on paper, and against counting by brute force.
#include "tests/core/run_size.h"
#include "tests/topology/surfaces.h"
#include "topology/half_edges.h"
#include "topology/report.h"

#include <map>
#include <set>

namespace alidade {
namespace {

using topology::examine;
using topology::SurfaceReport;

void expect_closed(const SurfaceReport& r, size_t components, int64_t genus) {
    EXPECT_TRUE(r.closed());
    EXPECT_EQ(r.components, components);
    ASSERT_TRUE(r.genus());
    EXPECT_EQ(*r.genus(), genus);
    EXPECT_EQ(r.holes + r.hole_edges + r.non_manifold_edges + r.non_manifold_vertices + r.inconsistent_edges + r.refused + r.duplicates, 0u);
}

TEST(Report, ClosedSurfaces) {
    for (const Mesh& mesh : {cube(), soup(cube())}) {
        const SurfaceReport r = examine(mesh);
        expect_closed(r, 1, 0);
        EXPECT_EQ(r.vertices, 8u);
        EXPECT_EQ(r.edges, 18u);
        EXPECT_EQ(r.euler(), 2);
    }
    const SurfaceReport ring = examine(torus(24, 12));
    expect_closed(ring, 1, 1);
    EXPECT_EQ(ring.vertices, 24u * 12u);
    EXPECT_EQ(ring.euler(), 0);
    expect_closed(examine(together(torus(9, 7), together(cube(Vec3(10)), octahedron()))), 3, 1);
}

TEST(Report, PolesRepeatAVertex) {
    const SurfaceReport r = examine(sphere(16, 8));
    expect_closed(r, 1, 0);
    EXPECT_EQ(r.degenerate, 32u);
    EXPECT_EQ(r.vertices, 16u * 7u + 2u);
}

TEST(Report, ASphereWithAHole) {
    const SurfaceReport r = examine(sphere(16, 8, 2));
    EXPECT_FALSE(r.closed());
    EXPECT_EQ(r.holes, 1u);
    EXPECT_EQ(r.hole_edges, 16u);
    EXPECT_NEAR(r.hole_length, 16 * 2 * std::sin(kPi / 16) * std::sin(kPi / 4), 1e-6) << "a polygon in the circle of that latitude";
    EXPECT_EQ(r.euler(), 1);
    EXPECT_FALSE(r.genus());
}

TEST(Report, AMoebiusStripHasOneRim) {
    const SurfaceReport r = examine(moebius(20));
    EXPECT_EQ(r.holes, 1u);
    EXPECT_EQ(r.hole_edges, 40u);
    EXPECT_EQ(r.inconsistent_edges, 1u) << "where its ends meet";
    EXPECT_EQ(r.non_manifold_edges + r.non_manifold_vertices, 0u);
    EXPECT_EQ(r.euler(), 0);
    EXPECT_GT(r.refused, 0u);
}

TEST(Report, CubesThatTouch) {
    const SurfaceReport edge = examine(together(cube(), cube(Vec3(1, 1, 0))));
    EXPECT_EQ(edge.non_manifold_edges, 1u);
    EXPECT_EQ(edge.non_manifold_vertices, 2u);
    EXPECT_FALSE(edge.closed());
    EXPECT_EQ(edge.components, 1u);
    EXPECT_EQ(edge.holes, 0u);
    const SurfaceReport vertex = examine(together(cube(), cube(Vec3(1))));
    EXPECT_EQ(vertex.non_manifold_edges, 0u);
    EXPECT_EQ(vertex.non_manifold_vertices, 1u);
    EXPECT_TRUE(vertex.closed());
    EXPECT_FALSE(vertex.genus());
    const SurfaceReport face = examine(together(cube(), cube(Vec3(1, 0, 0))));
    EXPECT_EQ(face.non_manifold_edges, 5u) << "the common face is there twice, diagonal included";
    EXPECT_EQ(face.duplicates, 2u);
}

TEST(Report, OneTriangleTurnedRound) {
    Mesh mesh = octahedron();
    std::swap(mesh.triangles[3].x, mesh.triangles[3].y);
    const SurfaceReport r = examine(mesh);
    EXPECT_EQ(r.inconsistent_edges, 3u);
    EXPECT_TRUE(r.closed());
    EXPECT_FALSE(r.genus());
    EXPECT_GT(r.refused, 0u);
}

TEST(Report, TwoTrianglesAtAPointHaveTwoRims) {
    const SurfaceReport r = examine(mesh_from({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}));
    EXPECT_EQ(r.holes, 2u);
    EXPECT_EQ(r.components, 1u);
    EXPECT_EQ(r.non_manifold_vertices, 1u);
}

TEST(Report, TrianglesWithoutArea) {
    const SurfaceReport r = examine(mesh_from({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}, {1, 1, 3}}));
    EXPECT_EQ(r.without_area, 1u);
    EXPECT_EQ(r.degenerate, 1u);
    EXPECT_EQ(examine(Mesh()).euler(), 0);
    EXPECT_FALSE(examine(Mesh()).closed());
}

// ---- brute force ----

using Point = std::array<float, 3>;

/// The same numbers from maps of points, edges and links: slow, and without a line in common with the report.
class BruteForce {
  public:
    explicit BruteForce(const Mesh& mesh) : mesh_(mesh) {
        for (const Index3& t : mesh.triangles) {
            const std::array<Point, 3> p{point(t.x), point(t.y), point(t.z)};
            if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) ++report.degenerate;
            else faces_.push_back(p);
        }
        report.triangles = mesh.triangles.size();
        std::set<std::set<Point>> different;
        for (const auto& f : faces_) {
            different.insert({f.begin(), f.end()});
            for (size_t k = 0; k < 3; ++k) {
                const Point &a = f[k], &b = f[(k + 1) % 3], &c = f[(k + 2) % 3];
                edges_[std::minmax(a, b)].push_back({a, b});
                links_[a].push_back({b, c});
            }
        }
        report.duplicates = faces_.size() - different.size();
        report.vertices = links_.size();
        report.edges = edges_.size();
        for (const auto& [edge, uses] : edges_) {
            report.hole_edges += uses.size() == 1;
            report.non_manifold_edges += uses.size() > 2;
            report.inconsistent_edges += uses.size() == 2 && uses[0] == uses[1];
        }
        for (const auto& [vertex, link] : links_) report.non_manifold_vertices += !is_path_or_cycle(link);
        report.components = pieces();
        report.holes = rims();
    }
    SurfaceReport report;

  private:
    using Edge = std::pair<Point, Point>;

    Point point(uint32_t i) const {
        const Vec3f& p = mesh_.positions[i];
        return {p.x + 0.f, p.y + 0.f, p.z + 0.f};
    }

    /// The link of a vertex, as a graph: connected, and nobody has more than two neighbours.
    static bool is_path_or_cycle(const std::vector<Edge>& link) {
        std::map<Point, int> degree;
        for (const auto& [a, b] : link) ++degree[a], ++degree[b];
        if (std::any_of(degree.begin(), degree.end(), [](const auto& d) { return d.second > 2; })) return false;
        std::set<Point> reached{link[0].first};
        for (bool grew = true; grew;) {
            grew = false;
            for (const auto& [a, b] : link)
                if (reached.count(a) != reached.count(b)) reached.insert({a, b}), grew = true;
        }
        return reached.size() == degree.size();
    }

    size_t pieces() const {
        std::set<Point> reached;
        size_t count = 0;
        for (const auto& [vertex, link] : links_) {
            if (reached.count(vertex)) continue;
            ++count;
            std::vector<Point> todo{vertex};
            while (!todo.empty()) {
                const Point p = todo.back();
                todo.pop_back();
                if (!reached.insert(p).second) continue;
                for (const auto& [a, b] : links_.at(p)) todo.push_back(a), todo.push_back(b);
            }
        }
        return count;
    }

    /// Walks along each rim: at its end, turns through the triangles around until the next edge with one triangle; at an edge that is too full, the
    /// rim ends there, and is walked from its other end.
    size_t rims() const {
        std::set<Edge> left;
        for (const auto& [edge, uses] : edges_)
            if (uses.size() == 1) left.insert(edge);
        size_t count = 0;
        while (!left.empty()) {
            ++count;
            const Edge start = *left.begin();
            left.erase(left.begin());
            for (const auto& [from, to] : {std::pair(start.first, start.second), std::pair(start.second, start.first)}) {
                Edge at{from, to};
                for (std::optional<Edge> next = next_on_rim(at); next && left.erase(std::minmax(next->first, next->second)); next = next_on_rim(at)) at = *next;
            }
        }
        return count;
    }

    std::optional<Edge> next_on_rim(const Edge& edge) const {
        Point pivot = edge.second, from = edge.first;
        const std::array<Point, 3>* face = nullptr;
        for (;;) {
            const std::array<Point, 3>* next = nullptr;
            for (const auto& f : faces_) {
                const auto has = [&](const Point& p) { return f[0] == p || f[1] == p || f[2] == p; };
                if (&f != face && has(pivot) && has(from)) next = &f;
            }
            face = next;
            Point third = pivot;
            for (const Point& p : *face)
                if (p != pivot && p != from) third = p;
            const size_t uses = edges_.at(std::minmax(pivot, third)).size();
            if (uses == 1) return Edge{pivot, third};
            if (uses > 2) return std::nullopt;
            from = third;
        }
    }

    const Mesh& mesh_;
    std::vector<std::array<Point, 3>> faces_;
    std::map<Edge, std::vector<Edge>> edges_;
    std::map<Point, std::vector<Edge>> links_;
};

void expect_brute_force(const std::string& name, const Mesh& mesh) {
    const SurfaceReport got = examine(mesh), want = BruteForce(mesh).report;
    EXPECT_EQ(got.triangles, want.triangles) << name;
    EXPECT_EQ(got.vertices, want.vertices) << name;
    EXPECT_EQ(got.edges, want.edges) << name;
    EXPECT_EQ(got.components, want.components) << name;
    EXPECT_EQ(got.holes, want.holes) << name;
    EXPECT_EQ(got.hole_edges, want.hole_edges) << name;
    EXPECT_EQ(got.non_manifold_edges, want.non_manifold_edges) << name;
    EXPECT_EQ(got.non_manifold_vertices, want.non_manifold_vertices) << name;
    EXPECT_EQ(got.inconsistent_edges, want.inconsistent_edges) << name;
    EXPECT_EQ(got.degenerate, want.degenerate) << name;
    EXPECT_EQ(got.duplicates, want.duplicates) << name;
}

TEST(Report, AnyMessAsBruteForceCountsIt) {
    size_t holes = 0, full = 0, touching = 0, turned = 0;
    for (uint32_t seed = 0; seed < 600; ++seed) {
        const Mesh mesh = mess(seed, 4 + int(seed % 40), int(seed % 50));
        expect_brute_force("mess " + std::to_string(seed), mesh);
        const SurfaceReport r = examine(mesh);
        holes += r.holes > 1, full += r.non_manifold_edges > 0, touching += r.non_manifold_vertices > 2 * r.non_manifold_edges, turned += r.inconsistent_edges > 0;
    }
    EXPECT_GT(std::min({holes, full, touching, turned}), 30u) << "the test must exercise every defect";
}

TEST(Report, FilesAsBruteForceCountsThem) {
    size_t compared = 0;
    for_each_mesh_file(test::run_size(1 << 20), [&](const std::string& name, const Mesh& mesh) {
        const bool finite = std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3f& p) { return is_finite(p); });
        if (mesh.triangles.size() > 3000 || !finite || !mesh.exact_positions.empty()) return;
        expect_brute_force(name, mesh);
        ++compared;
    });
    EXPECT_GE(compared, 3u);
}

/// OpenMesh, where it takes the whole surface, walks the same holes and finds the same pieces manifold.
TEST(Report, AgreesWithOpenMesh) {
    size_t compared = 0;
    for_each_mesh_file(test::run_size(4 << 20), [&](const std::string& name, const Mesh& mesh) {
        topology::HalfEdges edges = topology::half_edges(topology::weld(mesh));
        const SurfaceReport r = examine(mesh);
        EXPECT_EQ(edges.refused.size(), r.refused) << name;
        EXPECT_EQ(edges.manifold, r.non_manifold_edges + r.non_manifold_vertices + r.inconsistent_edges == 0 && r.refused == 0) << name;
        if (!edges.manifold) return;
        std::set<int> walked;
        size_t holes = 0;
        for (const auto side : edges.mesh.halfedges()) {
            if (!edges.mesh.is_boundary(side) || walked.count(side.idx())) continue;
            ++holes;
            for (auto at = edges.mesh.next_halfedge_handle(side); walked.insert(at.idx()).second;) at = edges.mesh.next_halfedge_handle(at);
        }
        EXPECT_EQ(holes, r.holes) << name;
        EXPECT_EQ(edges.mesh.n_edges(), r.edges) << name;
        ++compared;
    });
    EXPECT_GE(compared, 1u);
}

}  // namespace
}  // namespace alidade
