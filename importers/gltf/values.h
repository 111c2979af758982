// SPDX-License-Identifier: Apache-2.0
/// Members of extensions, which tinygltf keeps as generic values. Their types have been checked by check_schema().
#pragma once

#include "core/vec.h"
#include "importers/gltf/model.h"

namespace alidade::gltf {

/// The extension `name` of `object`, or null.
template <class Object> const tinygltf::Value* extension_of(const Object& object, const char* name) {
    const auto found = object.extensions.find(name);
    return found == object.extensions.end() || !found->second.IsObject() ? nullptr : &found->second;
}

double number_in(const tinygltf::Value& object, const char* name, double absent);
Vec2 vec2_in(const tinygltf::Value& object, const char* name, const Vec2& absent);
Vec3 vec3_in(const tinygltf::Value& object, const char* name, const Vec3& absent);

}  // namespace alidade::gltf
