// SPDX-License-Identifier: Apache-2.0
#include "exporters/output_files.h"

#include "core/image.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace alidade {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

namespace {

constexpr size_t kLongestName = 100;

bool is_plain(char c) {
    const auto u = static_cast<unsigned char>(c);
    return u >= 0x80 || std::isalnum(u) || std::string_view("_-.+").find(c) != std::string_view::npos;
}

bool same_file(const std::string& a, const std::string& b) {
    std::error_code error;
    return fs::exists(a, error) && fs::exists(b, error) && fs::equivalent(a, b, error);
}

std::string as_string(std::span<const std::byte> bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// Does the file hold these bytes and no others?
bool holds(const std::string& path, const std::string& bytes) {
    std::error_code error;
    if (fs::file_size(path, error) != bytes.size() || error) return false;
    const auto there = read_file(path);
    return there && as_string(*there) == bytes;
}

}  // namespace

std::string plain_name(const std::string& name, const std::string& instead) {
    std::string out = name.substr(0, kLongestName);
    std::replace_if(out.begin(), out.end(), [](char c) { return !is_plain(c); }, '_');
    while (!out.empty() && (out.back() & 0xC0) == 0x80 && name.size() > kLongestName) out.pop_back();   // no half of a UTF-8 character
    const bool says_something = std::any_of(out.begin(), out.end(), [](char c) { return c != '_' && c != '.'; });
    return says_something ? out : instead;
}

std::string UniqueNames::make(const std::string& name, const std::string& instead) {
    const std::string plain = plain_name(name, instead);
    std::string out = plain;
    for (size_t& next = taken_.try_emplace(plain, 1).first->second;; ++next) {
        if (next > 1) out = fmt::format("{}_{}", plain, next);
        if (out != plain && !taken_.try_emplace(out, 1).second) continue;
        ++next;
        return out;
    }
}

PictureFormat picture_format(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return {".png", "image/png"};
    if (bytes.starts_with("\xff\xd8\xff"sv)) return {".jpg", "image/jpeg"};
    if (bytes.starts_with("RIFF"sv) && bytes.substr(std::min<size_t>(8, bytes.size())).starts_with("WEBP"sv)) return {".webp", "image/webp"};
    return {"", ""};
}

OutputFiles::OutputFiles(const Scene& scene, const std::string& path)
    : scene_(scene), path_(path), folder_(fs::path(path).parent_path().string()), stem_(plain_name(fs::path(path).stem().string(), "scene")) {}

bool OutputFiles::has_ending(std::string_view ending) const {
    const std::string own = fs::path(path_).extension().string();
    return std::equal(own.begin(), own.end(), ending.begin(), ending.end(), [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

std::string OutputFiles::in_folder(const std::string& name) const { return (fs::path(folder_) / name).string(); }

std::string OutputFiles::add_companion(const std::string& ending, std::string bytes) {
    side_files_[stem_ + ending] = {std::move(bytes), true, false};
    return stem_ + ending;
}

tl::expected<std::string, std::string> OutputFiles::read(const Image& image) {
    if (!image.bytes.empty()) return as_string(image.bytes);
    const auto bytes = read_file(image.path);
    if (!bytes) return tl::unexpected(bytes.error());
    return as_string(*bytes);
}

std::string OutputFiles::add_picture(const Image& image, std::string bytes) {
    const fs::path source = image.path.empty() ? fs::path(image.name) : fs::path(image.path);
    const PictureFormat format = picture_format(bytes);
    const std::string known = format.ending, ending = known.empty() ? plain_name(source.extension().string(), ".img") : known;
    const bool names_itself = source.extension() == ending || (ending == ".jpg" && source.extension() == ".jpeg");
    std::string wanted = source.stem().string();
    if (ascii_) std::replace_if(wanted.begin(), wanted.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '_');
    const std::string stem = plain_name(wanted, "picture"), own = names_itself ? source.extension().string() : ending;
    for (size_t n = 1;; ++n) {
        const std::string name = n == 1 ? stem + own : fmt::format("{}_{}{}", stem, n, own);
        const auto known_file = side_files_.find(name);
        if (known_file != side_files_.end()) {
            if (known_file->second.bytes == bytes) return name;
            continue;
        }
        std::error_code ignored;
        const std::string path = in_folder(name);
        const bool there = fs::exists(path, ignored);
        if (fs::path(path).lexically_normal() == fs::path(path_).lexically_normal() || (there && !holds(path, bytes))) continue;
        side_files_[name] = {std::move(bytes), false, there};
        return name;
    }
}

tl::expected<void, std::string> OutputFiles::check(const std::string& path) const {
    for (const SourceFile& file : scene_.files)
        if (same_file(file.path, path)) return tl::unexpected(fmt::format("'{}' is what the scene was read from: it is not overwritten", path));
    for (const Image& image : scene_.images)
        if (same_file(image.path, path)) return tl::unexpected(fmt::format("'{}' is a picture of the scene: it is not overwritten", path));
    return {};
}

tl::expected<void, std::string> OutputFiles::check_all() const {
    std::error_code ignored;
    if (const auto good = check(path_); !good) return good;
    for (const auto& [name, file] : side_files_) {
        const std::string path = in_folder(name);
        if (file.there || !fs::exists(path, ignored)) continue;
        if (!file.companion) return tl::unexpected(fmt::format("'{}' has just appeared: it is not overwritten", path));
        if (const auto good = check(path); !good) return good;
        if (!fs::exists(path_, ignored) && !holds(path, file.bytes))
            return tl::unexpected(fmt::format("'{}' is there already and may belong to another file: it is not overwritten", path));
    }
    return {};
}

tl::expected<std::vector<std::string>, std::string> OutputFiles::write() const {
    if (const auto good = check_all(); !good) return tl::unexpected(good.error());
    std::vector<std::string> paths{path_};
    for (const auto& [name, file] : side_files_) {
        paths.push_back(in_folder(name));
        if (file.there) continue;
        if (const auto done = write_file(paths.back(), std::as_bytes(std::span(file.bytes))); !done) return tl::unexpected(done.error());
    }
    if (const auto done = write_file(path_, std::as_bytes(std::span(main_))); !done) return tl::unexpected(done.error());
    return paths;
}

}  // namespace alidade
