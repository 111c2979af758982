// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/animations.h"

#include <algorithm>

namespace alidade::gltf_export {

namespace {

const char* name_of(ChannelPath path) {
    static constexpr const char* kNames[] = {"translation", "rotation", "scale", "weights"};
    return kNames[size_t(path)];
}

const char* name_of(Interpolation interpolation) {
    static constexpr const char* kNames[] = {"STEP", "LINEAR", "CUBICSPLINE"};
    return kNames[size_t(interpolation)];
}

bool is_writable(const Channel& channel, const Scene& scene) {
    const auto finite = [](float x) { return std::isfinite(x); };
    if (channel.path != ChannelPath::weights && !scene.nodes[channel.target.index].trs) return false;   // a matrix cannot be animated
    const bool good = std::all_of(channel.times.begin(), channel.times.end(), finite) && std::all_of(channel.values.begin(), channel.values.end(), finite);
    return good && !channel.times.empty() && channel.times.front() >= 0;
}

Json sampler_json(const Channel& channel, Document& document) {
    const bool scalars = channel.path == ChannelPath::weights, four = channel.path == ChannelPath::rotation;
    const size_t input = document.add_shared_floats(channel.times, "SCALAR", 1, true);
    const size_t output = document.add_shared_floats(channel.values, scalars ? "SCALAR" : four ? "VEC4" : "VEC3", scalars ? 1 : four ? 4 : 3, false);
    Json json = {{"input", input}, {"output", output}};
    if (channel.interpolation != Interpolation::linear) json["interpolation"] = name_of(channel.interpolation);
    return json;
}

}  // namespace

void write_skins(const Scene& scene, const WrittenNodes& nodes, Document& document) {
    for (const Skin& skin : scene.skins) {
        Json json = Json::object();
        set(json, "name", skin.name, std::string());
        for (const NodeId joint : skin.joints) json["joints"].push_back(*nodes.node[joint.index]);
        std::vector<float> matrices;
        for (const Transform& t : skin.inverse_bind) {
            for (int column = 0; column < 3; ++column) matrices.insert(matrices.end(), {float(t.linear[column].x), float(t.linear[column].y), float(t.linear[column].z), 0});
            matrices.insert(matrices.end(), {float(t.translation.x), float(t.translation.y), float(t.translation.z), 1});
        }
        if (!matrices.empty()) json["inverseBindMatrices"] = document.add_floats(matrices, "MAT4", 16, Target::none);
        document.add("skins", std::move(json));
    }
}

void write_animations(const Scene& scene, const WrittenNodes& nodes, Document& document, Losses& losses) {
    for (const Animation& animation : scene.animations) {
        Json json = Json::object();
        set(json, "name", animation.name, std::string());
        json["channels"] = Json::array(), json["samplers"] = Json::array();
        for (const Channel& channel : animation.channels) {
            const auto& where = channel.path == ChannelPath::weights ? nodes.carrier : nodes.node;
            const auto node = where[channel.target.index];
            if (!node || !is_writable(channel, scene)) {
                losses.add("channels of animations that glTF cannot hold");
                continue;
            }
            losses.add("animations of nodes with several parents", nodes.copied[channel.target.index], "the first copy is animated");
            json["channels"].push_back({{"sampler", json["samplers"].size()}, {"target", {{"node", *node}, {"path", name_of(channel.path)}}}});
            json["samplers"].push_back(sampler_json(channel, document));
        }
        if (!json["channels"].empty()) document.add("animations", std::move(json));
    }
}

}  // namespace alidade::gltf_export
