// SPDX-License-Identifier: Apache-2.0
#include "scene/validation.h"

namespace alidade {

namespace {

bool finite(const std::vector<float>& values) {
    return std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); });
}

/// How many numbers a value of the channel has to have.
size_t expected_width(const Scene& scene, const Channel& channel) {
    if (channel.path == ChannelPath::rotation) return 4;
    if (channel.path != ChannelPath::weights) return 3;
    const ShapeId* shape = std::get_if<ShapeId>(&scene.nodes[channel.target.index].what);
    const Mesh* mesh = shape ? std::get_if<Mesh>(&scene.shapes[shape->index].geometry) : nullptr;
    return mesh ? mesh->morphs.size() : 0;
}

/// What is wrong with the channel, or nothing.
std::string fault(const Scene& scene, const Channel& c) {
    if (c.times.empty()) return "has no keys";
    if (!finite(c.times) || !finite(c.values)) return "has a number that is not finite";
    if (!std::is_sorted(c.times.begin(), c.times.end())) return "has times that do not increase";
    if (const size_t width = expected_width(scene, c); c.width != width) return fmt::format("has {} numbers a value where its target takes {}", c.width, width);
    const size_t rows = c.interpolation == Interpolation::cubic ? 3 * c.times.size() : c.times.size();
    if (c.values.size() != rows * c.width) return fmt::format("has {} numbers for {} keys: they should be {}", c.values.size(), c.times.size(), rows * c.width);
    if (c.path != ChannelPath::weights && !scene.nodes[c.target.index].trs) return "moves a node whose place is given by a matrix";
    return {};
}

}  // namespace

void check_animations(Validation& v) {
    for (size_t i = 0; i < v.scene.animations.size(); ++i) {
        const Animation& animation = v.scene.animations[i];
        for (size_t k = 0; k < animation.channels.size(); ++k) {
            const std::string what = fault(v.scene, animation.channels[k]);
            const Node& target = v.scene.nodes[animation.channels[k].target.index];
            if (!what.empty()) v.error(target.from, fmt::format("{}, channel {}, {}", label("animation", i, animation.name).text(), k, what));
        }
    }
}

}  // namespace alidade
