// SPDX-License-Identifier: Apache-2.0
#include "tools/surfaces.h"

#include "topology/report.h"

#include <nlohmann/json.hpp>

namespace alidade {

namespace {

using topology::SurfaceReport;

Json kind(const SurfaceReport& r) {
    return {{"triangles", r.triangles}, {"vertices", r.vertices}, {"edges", r.edges}, {"components", r.components}, {"closed", r.closed()},
            {"euler", r.euler()}, {"genus", r.genus() ? Json(*r.genus()) : Json()}};
}

Json defects(const SurfaceReport& r) {
    return {{"holes", r.holes}, {"hole edges", r.hole_edges}, {"hole length", r.hole_length}, {"non-manifold edges", r.non_manifold_edges},
            {"non-manifold vertices", r.non_manifold_vertices}, {"inconsistent edges", r.inconsistent_edges}, {"degenerate", r.degenerate},
            {"without area", r.without_area}, {"duplicates", r.duplicates}, {"refused", r.refused}};
}

bool has_defects(const SurfaceReport& r) {
    return r.hole_edges + r.non_manifold_edges + r.non_manifold_vertices + r.inconsistent_edges + r.degenerate + r.without_area + r.duplicates + r.refused > 0;
}

}  // namespace

Json describe_surfaces(const Scene& scene) {
    Json surfaces = Json::array(), with_defects = Json::array();
    for (size_t i = 0; i < scene.shapes.size(); ++i) {
        const auto* mesh = std::get_if<Mesh>(&scene.shapes[i].geometry);
        if (!mesh) continue;
        const SurfaceReport report = topology::examine(*mesh);
        const Json who{{"shape", i}, {"name", scene.shapes[i].name}};
        surfaces.push_back(who);
        surfaces.back().update(kind(report));
        if (!has_defects(report)) continue;
        with_defects.push_back(who);
        with_defects.back().update(defects(report));
    }
    return {{"surfaces", surfaces}, {"defects", with_defects}};
}

}  // namespace alidade
