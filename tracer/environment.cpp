// SPDX-License-Identifier: Apache-2.0
#include "tracer/environment.h"

#include "core/image_colors.h"
#include "tracer/compiled_scene.h"
#include "tracer/pov_sky.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace alidade {
namespace {

/// One pixel that is not a number would make all light of a sampled sky not a number. How many there were.
size_t blacken_broken(Picture& picture) {
    size_t broken = 0;
    const auto finite = [](float v) { return std::isfinite(v); };
    for (auto pixel = picture.values.begin(); pixel != picture.values.end(); pixel += picture.channels) {
        if (std::all_of(pixel, pixel + picture.channels, finite)) continue;
        std::fill_n(pixel, picture.channels, 0.0f);
        ++broken;
    }
    return broken;
}

}  // namespace

void make_sky(CompiledScene& out, const CompileOptions& options, Diagnostics& said) {
    const Atmosphere& air = out.scene.atmosphere;
    out.sky = std::make_unique<Sky>(air.background, false);
    if (options.environment) {
        out.sky = std::make_unique<Sky>(*options.environment, true);
    } else if (!options.environment_file.empty()) {
        auto picture = read_picture(options.environment_file, Encoding::automatic).and_then(colors_alone);
        if (picture) {
            if (const size_t broken = blacken_broken(*picture)) said.warning({}, fmt::format("environment '{}' has {} pixels that are not finite numbers: they are taken for black", options.environment_file, broken));
            out.sky = std::make_unique<Sky>(std::move(*picture), 1);
        } else {
            said.error({}, fmt::format("environment '{}' cannot be read: {}", options.environment_file, picture.error()));
        }
    } else if (air.environment) {
        out.sky = std::make_unique<Sky>(*air.environment * air.environment_strength, true);
    } else if (air.sky && !air.sky->pigments.empty()) {
        if (const auto from_world = inverse(air.sky->transform)) out.sky_from_world = *from_world;
        else said.warning({}, "the sky's transform has no inverse: it is left out");
        out.sky = std::make_unique<Sky>([scene = &out](const Vec3& direction) { return pov_sky(*scene, direction); });
    }
}

}  // namespace alidade
