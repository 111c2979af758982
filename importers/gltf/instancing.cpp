// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/instancing.h"

#include "importers/gltf/values.h"
#include "scene/animation.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade::gltf {

namespace {

constexpr const char* kName = "EXT_mesh_gpu_instancing";

/// An instance becomes a node of some hundred bytes: it must cost the file some, too. A translation alone has 12, a rotation in bytes 4.
constexpr uint64_t kFreeInstances = uint64_t(1) << 16, kBytesPerInstance = 4;

constexpr int kByte = 5120, kShort = 5122, kFloat = 5126;

/// What is wrong with the format of the attribute `name`, or nothing. Attributes of an application (_ID) may have any.
std::string broken_rule(const std::string& name, const Json& accessor) {
    const auto& type = accessor["type"].get_ref<const std::string&>();
    const int component = accessor["componentType"].get<int>();
    if (name == "TRANSLATION" || name == "SCALE") return type == "VEC3" && component == kFloat ? "" : "must be a VEC3 accessor of floats";
    if (name != "ROTATION") return {};
    const bool normalised = (component == kByte || component == kShort) && accessor.value("normalized", false);
    return type == "VEC4" && (component == kFloat || normalised) ? "" : "must be a VEC4 accessor of floats, or of normalised bytes or shorts";
}

/// The number of instances at `at`, or nothing and an error.
std::optional<uint64_t> check_attributes(const Json& root, const Json& attributes, const std::string& at, Reporter& report) {
    std::optional<uint64_t> count;
    for (const auto& [name, index] : attributes.items()) {
        const Json& accessor = root["accessors"][index.get<size_t>()];
        const auto own = accessor["count"].get<uint64_t>();
        std::string broken = broken_rule(name, accessor);
        if (broken.empty() && count && own != *count) broken = fmt::format("has {} elements, but another attribute of the instances has {}", own, *count);
        if (!broken.empty()) {
            report.error(child(at, name), std::move(broken));
            return std::nullopt;
        }
        count = own;
    }
    return count.value_or(0);
}

/// The accessor of the attribute `name`, or -1.
int accessor_of(const tinygltf::Value& attributes, const char* name) { return attributes.Has(name) ? int(number_in(attributes, name, -1)) : -1; }

/// The elements of an attribute that may be absent; none if it is.
std::vector<float> values_of(const Model& model, const tinygltf::Value& attributes, const char* name) {
    const int accessor = accessor_of(attributes, name);
    return accessor < 0 ? std::vector<float>() : read_floats(model, accessor);
}

}  // namespace

void check_instances(const Json& root, const std::vector<Bytes>& buffers, Reporter& report) {
    uint64_t left = kFreeInstances;
    for (const Bytes& b : buffers) left += b.size() / kBytesPerInstance;
    const auto nodes = root.find("nodes");
    for (size_t i = 0; nodes != root.end() && i < nodes->size(); ++i) {
        const auto extensions = (*nodes)[i].find("extensions");
        if (extensions == (*nodes)[i].end() || !extensions->contains(kName)) continue;
        const std::string at = child(child(child("/nodes", i), "extensions"), kName);
        const auto count = check_attributes(root, (*extensions)[kName]["attributes"], child(at, "attributes"), report);
        if (!count) continue;
        if (*count > left) return report.error(at, "the instances here and before are far more than the file holds data for");
        left -= *count;
    }
}

std::optional<std::vector<Transform>> read_instances(const Model& model, const tinygltf::Node& node, const std::string& at, Reporter& report) {
    const auto* extension = extension_of(node, kName);
    if (!extension) return std::nullopt;
    const tinygltf::Value& attributes = extension->Get("attributes");
    if (attributes.Keys().empty()) return std::nullopt;
    const std::vector<float> t = values_of(model, attributes, "TRANSLATION"), r = values_of(model, attributes, "ROTATION"), s = values_of(model, attributes, "SCALE");
    const size_t count = model.accessors[size_t(number_in(attributes, attributes.Keys().front().c_str(), 0))].count;
    std::vector<Transform> out;
    out.reserve(count);
    size_t without_direction = 0;
    for (size_t i = 0; i < count; ++i) {
        Trs trs;
        if (!t.empty()) trs.translation = Vec3(t[3 * i], t[3 * i + 1], t[3 * i + 2]);
        if (!s.empty()) trs.scale = Vec3(s[3 * i], s[3 * i + 1], s[3 * i + 2]);
        if (!r.empty()) {
            const Vec4 q(r[4 * i], r[4 * i + 1], r[4 * i + 2], r[4 * i + 3]);   // integers leave it a little off unit length
            if (const double norm = glm::length(q); norm > 0) trs.rotation = q / norm;
            else ++without_direction;
        }
        out.push_back(trs.transform());
    }
    if (without_direction) report.warning(at, fmt::format("{} quaternions have no direction: these instances are not rotated", without_direction));
    return out;
}

}  // namespace alidade::gltf
