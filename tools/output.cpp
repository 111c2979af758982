// SPDX-License-Identifier: Apache-2.0
#include "tools/output.h"

#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace alidade {

namespace fs = std::filesystem;

namespace {

/// "depth" of "depth.Z"; colour has no layer.
std::string layer_of(const std::string& channel) {
    const size_t dot = channel.find('.');
    return dot == channel.npos ? "" : channel.substr(0, dot);
}

/// The end of the layer that channel `first` begins.
int layer_end(const Picture& picture, int first) {
    int end = first + 1;
    while (end < picture.channels && layer_of(picture.names[size_t(end)]) == layer_of(picture.names[size_t(first)])) ++end;
    return end;
}

/// The channels first <= c < end of `picture`, as a picture.
Picture channels(const Picture& picture, int first, int end) {
    Picture out(picture.width, picture.height, {picture.names.begin() + first, picture.names.begin() + end});
    float* to = out.values.data();
    for (size_t i = 0; i < picture.values.size(); i += size_t(picture.channels)) to = std::copy_n(&picture.values[i + size_t(first)], end - first, to);
    return out;
}

}  // namespace

std::string why_no_file(const std::string& path) {
    const fs::path file(path), folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::error_code ignored;
    if (!file.has_filename() || fs::is_directory(file, ignored)) return fmt::format("'{}' is a folder", path);
    if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) return access(path.c_str(), W_OK) == 0 ? "" : fmt::format("'{}' may not be written to", path);
    if (!fs::is_directory(folder, ignored)) return fmt::format("'{}': there is no folder '{}'", path, folder.string());
    if (access(folder.c_str(), W_OK) != 0) return fmt::format("'{}': the folder '{}' may not be written to", path, folder.string());
    return {};
}

std::string why_not_writable(const std::string& path) {
    if (std::string why = why_no_file(path); !why.empty()) return why;
    const std::string why = why_no_format(path);
    return why.empty() ? why : fmt::format("'{}': {}", path, why);
}

tl::expected<std::vector<std::string>, std::string> write_film(const std::string& path, const Picture& picture, int bits) {
    std::vector<std::string> files{path};
    const bool exr = fs::path(path).extension() == ".exr";
    const int color_end = layer_end(picture, 0);
    if (auto done = write_picture(path, exr ? picture : channels(picture, 0, color_end), bits); !done) return tl::unexpected(done.error());
    if (exr) return files;
    for (int first = color_end, end; first < picture.channels; first = end) {
        end = layer_end(picture, first);
        files.push_back(fs::path(path).replace_extension("." + layer_of(picture.names[size_t(first)]) + ".exr").string());
        if (auto done = write_picture(files.back(), channels(picture, first, end)); !done) return tl::unexpected(done.error());
    }
    return files;
}

}  // namespace alidade
