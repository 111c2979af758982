// SPDX-License-Identifier: Apache-2.0
#include "importers/local_path.h"

#include <algorithm>
#include <filesystem>

namespace alidade {

tl::expected<std::string, std::string> local_path(const std::string& folder, std::string name) {
    const auto refuse = [](const char* why) { return tl::unexpected(std::string(why)); };
    if (name.empty()) return refuse("it is empty");
    if (name.find('\0') != std::string::npos) return refuse("it contains a NUL");
    std::replace(name.begin(), name.end(), '\\', '/');
    const bool drive = name.size() > 1 && name[1] == ':';
    if (name.front() == '/' || drive) return refuse("absolute paths are not allowed");
    const std::filesystem::path path(name);
    for (const auto& part : path)
        if (part == "..") return refuse("\"..\" is not allowed");
    return (std::filesystem::path(folder) / path).lexically_normal().string();
}

std::string folder_of(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

}  // namespace alidade
