// SPDX-License-Identifier: Apache-2.0
/// A glTF file in the making: its JSON, and the bytes of its one buffer.
#pragma once

#include "core/vec.h"

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>

namespace alidade::gltf_export {

using Json = nlohmann::ordered_json;

enum class Target { none = 0, vertices = 34962, indices = 34963 };

class Document {
  public:
    Json root;   ///< its arrays are made by add()

    /// Appends to root[array]; returns the index.
    size_t add(const char* array, Json value);

    /// A buffer view of its own for `bytes`, at a multiple of 4.
    size_t add_view(std::string_view bytes, Target target);
    /// An accessor of floats, with their extent if `extent`. `type`: "SCALAR", "VEC2", ..., of `width` components.
    size_t add_floats(std::span<const float> values, const char* type, size_t width, Target target, bool extent = false);
    /// The same; equal arrays become one accessor.
    size_t add_shared_floats(std::span<const float> values, const char* type, size_t width, bool extent);
    size_t add_indices(std::span<const Index3> triangles, size_t vertices);
    size_t add_joints(std::span<const Joints4> joints);

    /// An object that uses `extension`: root's list of used ones names it.
    Json& use(Json& object, const char* extension, bool required = false);

    const std::string& buffer() const { return buffer_; }
    /// Writes the lists of extensions into the root.
    void finish_extensions();

  private:
    size_t add_accessor(std::string_view bytes, int component_type, const char* type, size_t count, Target target);

    std::string buffer_;
    std::map<std::string, size_t> shared_;   ///< by type and bytes
    std::set<std::string> used_, required_;
};

/// A vector as an array.
template <glm::length_t L, class T> Json array(const glm::vec<L, T>& v) {
    Json out = Json::array();
    for (glm::length_t i = 0; i < L; ++i) out.push_back(v[i]);
    return out;
}

/// object[key] = value, unless it is the usual one.
template <class T> void set(Json& object, const char* key, const T& value, const T& usual) {
    if (!(value == usual)) object[key] = value;
}
template <glm::length_t L, class T> void set(Json& object, const char* key, const glm::vec<L, T>& value, const glm::vec<L, T>& usual) {
    if (value != usual) object[key] = array(value);
}

}  // namespace alidade::gltf_export
