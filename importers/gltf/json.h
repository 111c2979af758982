// SPDX-License-Identifier: Apache-2.0
/// JSON values and the pointers (RFC 6901) that messages name them by.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>

namespace alidade::gltf {

using Json = nlohmann::json;

/// The pointer of the member `key` of what `parent` points to.
std::string child(const std::string& parent, std::string_view key);
/// The pointer of element `index` of what `parent` points to.
std::string child(const std::string& parent, size_t index);

/// The array of that name, or an empty one. `J`: Json or const Json.
template <class J> J& array_in(J& object, const char* name) {
    using Value = std::remove_const_t<J>;
    thread_local Value none;
    const auto found = object.find(name);
    return found == object.end() ? none = Value::array() : *found;
}

/// The extension of that name, or null.
template <class J> J* extension_in(J& object, const char* name) {
    const auto all = object.find("extensions");
    if (all == object.end()) return nullptr;
    const auto found = all->find(name);
    return found == all->end() ? nullptr : &*found;
}

/// The whole number of that name, or 0. Its type has been checked.
inline uint64_t whole(const Json& object, const char* name) { return object.value(name, uint64_t(0)); }

}  // namespace alidade::gltf
