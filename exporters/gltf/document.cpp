// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/document.h"

#include <algorithm>
#include <bit>

namespace alidade::gltf_export {

namespace {

enum ComponentType { kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126 };

/// glTF's byte order.
static_assert(std::endian::native == std::endian::little, "the bytes of numbers are written as they are in memory");

template <class T> std::string_view bytes_of(std::span<const T> values) { return {reinterpret_cast<const char*>(values.data()), values.size_bytes()}; }

}  // namespace

size_t Document::add(const char* array, Json value) {
    Json& list = root[array];
    list.push_back(std::move(value));
    return list.size() - 1;
}

size_t Document::add_view(std::string_view bytes, Target target) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
    if (target != Target::none) view["target"] = int(target);
    buffer_ += bytes;
    return add("bufferViews", std::move(view));
}

size_t Document::add_accessor(std::string_view bytes, int component_type, const char* type, size_t count, Target target) {
    return add("accessors", {{"bufferView", add_view(bytes, target)}, {"componentType", component_type}, {"count", count}, {"type", type}});
}

size_t Document::add_floats(std::span<const float> values, const char* type, size_t width, Target target, bool extent) {
    const size_t index = add_accessor(bytes_of(values), kFloat, type, values.size() / width, target);
    if (!extent || values.empty()) return index;
    Json least = Json::array(), most = Json::array();
    for (size_t c = 0; c < width; ++c) {
        float low = values[c], high = values[c];
        for (size_t i = c; i < values.size(); i += width) low = std::min(low, values[i]), high = std::max(high, values[i]);
        least.push_back(low), most.push_back(high);
    }
    root["accessors"][index]["min"] = std::move(least), root["accessors"][index]["max"] = std::move(most);
    return index;
}

size_t Document::add_shared_floats(std::span<const float> values, const char* type, size_t width, bool extent) {
    const std::string key = std::string(type) + (extent ? "+" : "-") + std::string(bytes_of(values));
    const auto [known, added] = shared_.try_emplace(key);
    if (added) known->second = add_floats(values, type, width, Target::none, extent);
    return known->second;
}

size_t Document::add_indices(std::span<const Index3> triangles, size_t vertices) {
    if (vertices > 0xFFFF) return add_accessor(bytes_of(triangles), kUnsignedInt, "SCALAR", 3 * triangles.size(), Target::indices);
    std::vector<uint16_t> small;   // 65535 itself restarts a strip
    small.reserve(3 * triangles.size());
    for (const Index3& t : triangles) small.insert(small.end(), {uint16_t(t.x), uint16_t(t.y), uint16_t(t.z)});
    return add_accessor(bytes_of(std::span<const uint16_t>(small)), kUnsignedShort, "SCALAR", small.size(), Target::indices);
}

size_t Document::add_joints(std::span<const Joints4> joints) {
    return add_accessor(bytes_of(joints), kUnsignedShort, "VEC4", joints.size(), Target::vertices);
}

Json& Document::use(Json& object, const char* extension, bool required) {
    used_.insert(extension);
    if (required) required_.insert(extension);
    return object["extensions"][extension];
}

void Document::finish_extensions() {
    for (const std::string& name : used_) root["extensionsUsed"].push_back(name);
    for (const std::string& name : required_) root["extensionsRequired"].push_back(name);
}

}  // namespace alidade::gltf_export
