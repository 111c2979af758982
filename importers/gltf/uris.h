// SPDX-License-Identifier: Apache-2.0
/// URIs of buffers and images: what they hold, and which files a scene may read.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace alidade::gltf {

bool is_data_uri(std::string_view uri);

/// The bytes of a data: URI (RFC 2397), base64 or percent-encoded, whatever its media type. An error is one sentence.
tl::expected<std::vector<unsigned char>, std::string> decode_data_uri(std::string_view uri);

/// %41 -> A. Refuses malformed and NUL escapes.
tl::expected<std::string, std::string> percent_decoded(std::string_view text);

/// The path of the file that `uri` names, at or below `base_dir`. Refuses absolute paths, "..", schemes and drive letters: a scene from
/// a stranger must not name any other file of this machine. An empty `base_dir` means that no file may be read.
tl::expected<std::string, std::string> resolve_uri(std::string_view uri, const std::string& base_dir);

}  // namespace alidade::gltf
