// SPDX-License-Identifier: Apache-2.0
/// JSON values and the pointers (RFC 6901) that messages name them by.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace alidade::gltf {

using Json = nlohmann::json;

/// The pointer of the member `key` of what `parent` points to.
std::string child(const std::string& parent, std::string_view key);
/// The pointer of element `index` of what `parent` points to.
std::string child(const std::string& parent, size_t index);

}  // namespace alidade::gltf
