// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/values.h"

namespace alidade::gltf {

double number_in(const tinygltf::Value& object, const char* name, double absent) {
    return object.Has(name) ? object.Get(name).GetNumberAsDouble() : absent;
}

Vec2 vec2_in(const tinygltf::Value& object, const char* name, const Vec2& absent) {
    if (!object.Has(name)) return absent;
    const tinygltf::Value& v = object.Get(name);
    return {v.Get(0).GetNumberAsDouble(), v.Get(1).GetNumberAsDouble()};
}

Vec3 vec3_in(const tinygltf::Value& object, const char* name, const Vec3& absent) {
    if (!object.Has(name)) return absent;
    const tinygltf::Value& v = object.Get(name);
    return {v.Get(0).GetNumberAsDouble(), v.Get(1).GetNumberAsDouble(), v.Get(2).GetNumberAsDouble()};
}

}  // namespace alidade::gltf
