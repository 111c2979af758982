// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/scenes.h"

#include "importers/pov/builders/cameras.h"
#include "importers/pov/builders/copies.h"
#include "importers/pov/builders/atmosphere.h"
#include "importers/pov/builders/finish_interiors.h"
#include "importers/pov/builders/globals.h"
#include "importers/pov/builders/misplaced.h"
#include "importers/pov/builders/objects.h"
#include "importers/pov/builders/pigments.h"
#include "importers/pov/builders/textures.h"
#include "importers/pov/quality.h"
#include "scene/validation.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

bool is_same_everywhere(const Build& build, const PovFinish& f) { return !f.normal && std::holds_alternative<ConstantSignal>(build.scene.signals[f.pigment.index].what); }

/// A root that gives the default texture to whatever has none: a texture of the world, which the object's own transformations do not move.
void add_root(Build& build, const Block& block) {
    const auto built = build_object(build, block);
    if (!built) return;
    NodeId root = built->node;
    Node& node = build.scene.nodes[root.index];
    const bool has_own = !node.materials.empty() && node.materials[0];
    if (!has_own && !std::holds_alternative<LightId>(node.what)) {
        const MaterialId usual = default_material(build, block.defaults);
        if (!is_same_everywhere(build, default_texture(build, block.defaults))) {
            Node world;
            world.children = {root};
            root = build.add_node(std::move(world));
        }
        Node& carrier = build.scene.nodes[root.index];
        if (carrier.materials.empty()) carrier.materials.resize(1);
        carrier.materials[0] = usual;
        carrier.usual_material = true;
    }
    build.scene.roots.push_back(root);
}

void add_surroundings(Build& build, const Block& block) {
    switch (block.word) {
        case "global_settings"_w: return read_globals(build, block);
        case "background"_w: return read_background(build, block);
        case "sky_sphere"_w: return read_sky_sphere(build, block);
        case "fog"_w: return read_fog(build, block);
        default: return read_rainbow(build, block);
    }
}

size_t faults_of_surroundings(const Build& build) {
    Validation checked(build.scene);
    check_atmosphere(checked);
    return checked.found.errors();
}

/// In a scene surroundings and settings have no place of their own: what is not finite is told here.
void build_surroundings(Build& build, const Block& block) {
    const size_t before = faults_of_surroundings(build);
    add_surroundings(build, block);
    if (faults_of_surroundings(build) > before) build.p.fail(block.place, fmt::format("{} has a number that is not finite", kWords[block.word]));
}

void build_top_level(Build& build, const Block& block, std::optional<Camera>& camera) {
    switch (block.word) {
        case "camera"_w:
            if (camera) build.p.warn(block.place, "the scene has more than one camera: the last one is used, as in POV-Ray");
            camera = build_camera(build, block);
            return;
        case "global_settings"_w: case "background"_w: case "sky_sphere"_w: case "fog"_w: case "rainbow"_w: return build_surroundings(build, block);
        default: break;
    }
    if (is_object(block.word)) return add_root(build, block);
    if (block.word != "media"_w) build.p.fail(block.place, fmt::format("an object or a directive is expected, not {}", kWords[block.word]));
    build.p.tally(block.place, fmt::format("{} is not modelled yet: it is left out", kWords[block.word]));
}

/// The last camera is the scene's.
void add_camera(Build& build, const std::optional<Camera>& camera) {
    Camera usual;
    usual.direction = {0, 0, 1}, usual.right = {1.33, 0, 0}, usual.up = {0, 1, 0};
    build.scene.cameras.push_back(camera.value_or(usual));
    build.scene.cameras[0].clearance = 1e-4;
    const Camera& lens = build.scene.cameras[0];
    if (lens.aperture > 0 && lens.blur_samples > 0) build.scene.settings.default_spp = lens.blur_samples;
    Node node;
    node.what = CameraId{0};
    node.from = build.scene.cameras[0].from;
    build.scene.nodes.push_back(std::move(node));                    // also where there is no room for another object
    build.scene.roots.push_back({uint32_t(build.scene.nodes.size() - 1)});
}

}  // namespace

Scene build_scene(Parser& parser, const Program& program) {
    Build build(parser);
    build.defaults = program.defaults;
    begin_settings(build);
    std::optional<Camera> camera;
    for (const Ref<Block>& block : program.blocks) {
        parser.reset_nesting();
        try {
            build_top_level(build, *block, camera);
        } catch (Failure& failure) {
            parser.report(std::move(failure.diagnostic));
            if (failure.fatal) break;
        }
    }
    add_camera(build, camera);
    fill_interiors_by_finishes(build.scene);
    if (parser.options.quality < kWholePigments) show_quick_colors(build);
    build.scene.files = program.files;
    if (!build.p.said.has_errors()) check_copies(build);
    return std::move(build.scene);
}

}  // namespace alidade::pov
