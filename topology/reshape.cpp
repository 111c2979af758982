// SPDX-License-Identifier: Apache-2.0
#include "topology/reshape.h"

#include "topology/decimate.h"
#include "topology/normals.h"
#include "topology/subdivide.h"

#include <cmath>
#include <fmt/format.h>

namespace alidade {

namespace {

/// What decimation leaves of a smooth surface is coarse: at 30 degrees, the usual angle, it would have facets.
constexpr double kCreaseAfterDecimation = 60;

/// False, with an error, if subdivision would make too many triangles.
bool affordable(const Scene& scene, const ReshapeOptions& options, Diagnostics& said) {
    uint64_t triangles = 0;
    for (const ShapeEntry& shape : scene.shapes)
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) triangles += topology::subdivided_triangles(*mesh, options.subdivide);
    if (triangles <= options.most_triangles) return true;
    said.error({}, fmt::format("--subdivide {} would make {} triangles of the scene's meshes; {} are allowed", options.subdivide, triangles, options.most_triangles),
               "subdivide fewer times");
    return false;
}

/// Meshes to which the same happened; told once.
struct Tally {
    size_t count = 0;
    SourcePos first;

    void add(const SourcePos& at) {
        if (count++ == 0) first = at;
    }
};

class Reshaping {
  public:
    Reshaping(const ReshapeOptions& options, Diagnostics& said) : options_(options), said_(said) {}

    void run(ShapeEntry& shape) {
        auto* mesh = std::get_if<Mesh>(&shape.geometry);
        if (!mesh || mesh->triangles.empty()) return;
        const bool had_normals = mesh->normals.present(), had_tangents = mesh->tangents.present();
        bool subdivided = false, decimated = false;
        const bool mixed = !mesh->corner_slots.empty();
        if (mixed && (options_.subdivide > 0 || options_.decimate < 1)) said_.warning(shape.from, fmt::format("the mesh \"{}\" is not reshaped: it mixes textures over its triangles", shape.name));
        if (options_.subdivide > 0 && !mixed) subdivided = replace(shape, *mesh, topology::subdivide(*mesh, options_.subdivide), "subdivided");
        if (options_.decimate < 1 && !mixed) decimated = decimate(shape, *mesh);
        if (!mesh->normals.present() && mesh->morphs.empty()) give_normals(*mesh, subdivided, decimated && had_normals);
        if (had_normals && (subdivided || decimated)) lost_normals_.add(shape.from);
        if (had_tangents && (subdivided || decimated)) lost_tangents_.add(shape.from);
    }

    void tell() const {
        if (lost_normals_.count) said_.warning(lost_normals_.first, fmt::format("meshes that have lost the file's normals, and were given new ones: {}", lost_normals_.count));
        if (lost_tangents_.count)
            said_.warning(lost_tangents_.first, fmt::format("meshes that have lost the file's tangents, which are now made from texture coordinates: {}", lost_tangents_.count));
    }

  private:
    bool replace(const ShapeEntry& shape, Mesh& mesh, tl::expected<Mesh, std::string> made, const char* what) {
        if (made) mesh = std::move(*made);
        else said_.warning(shape.from, fmt::format("the mesh \"{}\" is not {}: {}", shape.name, what, made.error()), "alidade info tells what is wrong with its surface");
        return made.has_value();
    }

    bool decimate(const ShapeEntry& shape, Mesh& mesh) {
        const double wanted = std::ceil(options_.decimate * double(mesh.triangles.size()));
        if (!replace(shape, mesh, topology::decimate(mesh, options_.decimate), "decimated")) return false;
        if (double(mesh.triangles.size()) > wanted)
            said_.warning(shape.from, fmt::format("the mesh \"{}\" still has {} triangles, not {:.0f}: its shape, borders and seams allow no fewer", shape.name,
                                                  mesh.triangles.size(), wanted));
        return true;
    }

    void give_normals(Mesh& mesh, bool subdivided, bool lost) const {
        if (options_.crease_degrees) topology::set_crease_normals(mesh, *options_.crease_degrees);
        else if (subdivided) topology::set_crease_normals(mesh, 180);
        else if (lost) topology::set_crease_normals(mesh, kCreaseAfterDecimation);
    }

    const ReshapeOptions& options_;
    Diagnostics& said_;
    Tally lost_normals_, lost_tangents_;
};

}  // namespace

void reshape(Scene& scene, const ReshapeOptions& options, Diagnostics& said) {
    if (!options.any() || (options.subdivide > 0 && !affordable(scene, options, said))) return;
    Reshaping reshaping(options, said);
    for (ShapeEntry& shape : scene.shapes) reshaping.run(shape);
    reshaping.tell();
}

}  // namespace alidade
