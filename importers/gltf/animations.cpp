// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/animations.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade::gltf {

namespace {

class ChannelReader {
  public:
    ChannelReader(const Model& model, const ShapeNodes& shape_nodes, const Scene& scene, Reporter& report)
        : model_(model), shape_nodes_(shape_nodes), scene_(scene), report_(report), budget_(model) {}

    /// Appends the channels that `from` becomes: none if it cannot be used, which is said.
    void read(const tinygltf::Animation& animation, size_t index, const std::string& at, std::vector<Channel>& out) {
        const tinygltf::AnimationChannel& from = animation.channels[index];
        const std::string where = child(child(at, "channels"), index);
        if (from.sampler < 0 || size_t(from.sampler) >= animation.samplers.size()) {
            return report_.error(child(where, "sampler"),
                                 fmt::format("index {} is out of range: the animation has {} samplers", from.sampler, animation.samplers.size()));
        }
        if (from.target_path == "pointer") return report_.not_understood(where, "KHR_animation_pointer is not supported: the channel is left out");
        if (from.target_node < 0) return;   // the specification says that such a channel is ignored
        Channel channel;
        channel.target = NodeId{uint32_t(from.target_node)};
        if (!find_path(from, where, channel)) return;
        if (!read_sampler(animation.samplers[size_t(from.sampler)], child(child(at, "samplers"), size_t(from.sampler)), channel)) return;
        if (channel.path != ChannelPath::weights) return out.push_back(std::move(channel));
        for (const NodeId node : shape_nodes_[size_t(from.target_node)]) {
            channel.target = node;
            out.push_back(channel);
        }
    }

  private:
    bool find_path(const tinygltf::AnimationChannel& from, const std::string& at, Channel& channel) {
        const auto left_out = [&](const char* why) {
            report_.warning(at, fmt::format("{}: the channel is left out", why));
            return false;
        };
        if (from.target_path == "weights") {
            channel.path = ChannelPath::weights;
            const auto& shapes = shape_nodes_[size_t(from.target_node)];
            if (shapes.empty()) return left_out("the target has no mesh to morph");
            const ShapeId shape = std::get<ShapeId>(scene_.nodes[shapes.front().index].what);
            channel.width = uint32_t(std::get<Mesh>(scene_.shapes[shape.index].geometry).morphs.size());
            return channel.width > 0 || left_out("the target's mesh has no morph targets");
        }
        channel.path = from.target_path == "rotation" ? ChannelPath::rotation
                       : from.target_path == "scale"  ? ChannelPath::scale
                                                      : ChannelPath::translation;
        channel.width = channel.path == ChannelPath::rotation ? 4 : 3;
        return scene_.nodes[channel.target.index].trs.has_value() || left_out("the target's transform is a matrix, which cannot be animated");
    }

    bool read_sampler(const tinygltf::AnimationSampler& from, const std::string& at, Channel& channel) {
        const tinygltf::Accessor &input = model_.accessors[size_t(from.input)], &output = model_.accessors[size_t(from.output)];
        const auto fail = [&](const char* member, std::string message) {
            report_.error(child(at, member), std::move(message));
            return false;
        };
        if (input.type != TINYGLTF_TYPE_SCALAR || input.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT)
            return fail("input", "must be a SCALAR accessor of floats");
        if (!output_fits(output, channel)) return fail("output", "the accessor has the wrong type for the property that it animates");
        channel.interpolation = from.interpolation == "STEP"          ? Interpolation::step
                                : from.interpolation == "CUBICSPLINE" ? Interpolation::cubic
                                                                      : Interpolation::linear;
        const uint64_t per_key =
            (channel.interpolation == Interpolation::cubic ? 3 : 1) * uint64_t(channel.path == ChannelPath::weights ? channel.width : 1);
        if (output.count != input.count * per_key)
            return fail("output", fmt::format("{} elements, but {} keys need {}", output.count, input.count, input.count * per_key));
        const uint64_t copies = channel.path == ChannelPath::weights ? shape_nodes_[channel.target.index].size() : 1;
        if (!budget_.spend((input.count + output.count * component_count(output)) * copies, at, report_)) return false;
        channel.times = read_floats(model_, from.input);
        channel.values = read_floats(model_, from.output);
        const auto stuck = std::adjacent_find(channel.times.begin(), channel.times.end(), [](float a, float b) { return !(a < b); });
        if (stuck == channel.times.end()) return true;
        report_.warning(child(at, "input"),
                        fmt::format("the times do not increase after key {}: the channel is left out", stuck - channel.times.begin()));
        return false;
    }

    static bool output_fits(const tinygltf::Accessor& output, const Channel& channel) {
        if (output.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return false;
        if (channel.path == ChannelPath::weights) return output.type == TINYGLTF_TYPE_SCALAR;
        return output.type == (channel.path == ChannelPath::rotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3);
    }

    const Model& model_;
    const ShapeNodes& shape_nodes_;
    const Scene& scene_;
    Reporter& report_;
    ReadBudget budget_;
};

}  // namespace

void convert_animations(const Model& model, const ShapeNodes& shape_nodes, Scene& scene, Reporter& report) {
    ChannelReader reader(model, shape_nodes, scene, report);
    for (size_t i = 0; i < model.animations.size(); ++i) {
        Animation animation;
        animation.name = model.animations[i].name;
        for (size_t k = 0; k < model.animations[i].channels.size(); ++k)
            reader.read(model.animations[i], k, child("/animations", i), animation.channels);
        scene.animations.push_back(std::move(animation));
    }
}

}  // namespace alidade::gltf
