// SPDX-License-Identifier: Apache-2.0
/// Which files a scene may name.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace alidade {

/// The path of the file `name` at or below `folder`. A scene from a stranger must not name any other file of this machine: absolute paths, drive
/// letters, "..", NUL and empty names are refused, in a few words that go behind a colon. Backslashes are slashes, as files written on Windows
/// have them.
tl::expected<std::string, std::string> local_path(const std::string& folder, std::string name);

/// The folder that `path` stands in; "." for a bare name.
std::string folder_of(const std::string& path);

}  // namespace alidade
