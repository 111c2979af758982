// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/source.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sys/stat.h>

namespace alidade::pov {

namespace fs = std::filesystem;

SourcePos Source::position(uint32_t offset) const {
    if (line_starts_.empty()) {
        line_starts_.push_back(0);
        for (size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1)) line_starts_.push_back(uint32_t(at + 1));
    }
    const auto line = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset) - 1;
    SourcePos at;
    at.file = file_, at.line = uint32_t(line - line_starts_.begin()) + 1, at.column = offset - *line + 1;
    return at;
}

std::string Source::excerpt(uint32_t offset, uint32_t& column) const {
    constexpr uint32_t kAround = 80;
    const uint32_t start = offset - (position(offset).column - 1);
    const uint32_t end = uint32_t(std::min(text_.find('\n', start), text_.size()));
    const uint32_t from = offset - start > 2 * kAround ? offset - kAround : start;
    column = offset - from + 1;
    std::string line = text_.substr(from, std::min(end, from + 3 * kAround) - from);
    std::replace_if(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
    return line;
}

SourceFinder::SourceFinder(const fs::path& scene_folder, std::vector<std::string> include_paths, bool scene_folder_last) {
    for (std::string& path : include_paths) folders_.emplace_back(std::move(path));
    folders_.emplace_back(kStandardIncludes);
    folders_.insert(scene_folder_last ? folders_.end() : folders_.begin(), scene_folder.empty() ? fs::path(".") : scene_folder);
}

fs::path SourceFinder::resolved(const fs::path& path, std::error_code& failed) const {
    if (fs::is_symlink(fs::symlink_status(path, failed)) || !path.has_filename()) return fs::weakly_canonical(path, failed);
    const auto [known, fresh] = resolved_.try_emplace(path.parent_path().string());
    if (fresh) known->second = fs::weakly_canonical(path.parent_path(), failed);
    if (failed) return resolved_.erase(known), fs::path();
    return known->second / path.filename();
}

bool SourceFinder::allowed(const fs::path& path) const {
    std::error_code failed;
    if (roots_.empty())
        for (const fs::path& folder : folders_)
            if (fs::path root = fs::weakly_canonical(folder, failed); !failed) roots_.push_back(std::move(root));
    const fs::path real = resolved(path, failed);
    if (failed) return false;
    return std::any_of(roots_.begin(), roots_.end(), [&](const fs::path& root) {
        const auto [end, _] = std::mismatch(root.begin(), root.end(), real.begin(), real.end());
        return end == root.end();
    });
}

namespace {

bool same_letters(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char p, unsigned char q) { return std::tolower(p) == std::tolower(q); });
}

/// The file of `folder` whose name is `name` but for the case of its letters.
std::optional<fs::path> other_case(const fs::path& folder, const std::string& name) {
    std::error_code failed;
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed))
        if (same_letters(it->path().filename().string(), name)) return it->path();
    return std::nullopt;
}

bool is_file(const fs::path& path) {
    std::error_code failed;
    return fs::is_regular_file(path, failed);
}

}  // namespace

std::optional<SourceFinder::Found> SourceFinder::find(const std::string& name) const {
    if (name.empty() || name.find('\0') != std::string::npos) return std::nullopt;
    bool refused = false;
    for (const fs::path& folder : folders_) {
        const fs::path path = folder / name;
        if (!is_file(path)) continue;
        if (allowed(path)) return Found{path.string(), false};
        refused = true;
    }
    if (refused) return std::nullopt;
    for (const fs::path& folder : folders_) {
        const fs::path asked = folder / name;
        if (const auto path = other_case(asked.parent_path(), asked.filename().string()); path && is_file(*path) && allowed(*path))
            return Found{path->string(), true};
    }
    return std::nullopt;
}

std::optional<std::string> read_whole(const std::string& path, uint64_t limit) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(path.c_str(), "rb"), std::fclose);
    struct stat status{};
    if (!in || fstat(fileno(in.get()), &status) != 0 || !S_ISREG(status.st_mode) || uint64_t(status.st_size) > limit) return std::nullopt;
    std::setvbuf(in.get(), nullptr, _IONBF, 0);
    std::string text(size_t(status.st_size), '\0');
    text.resize(std::fread(text.data(), 1, text.size(), in.get()));
    return text;
}

namespace {

/// Does `#declare NAME` or `#macro NAME` stand in the text? What is #local to an include is known nowhere else.
bool declares(std::string_view text, std::string_view name) {
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
        if (at + name.size() < text.size() && is_part(text[at + name.size()])) continue;
        const size_t end = at == 0 ? text.npos : text.find_last_not_of(" \t", at - 1);
        if (end == text.npos || end + 1 == at) continue;
        const std::string_view before = text.substr(0, end + 1);
        for (const std::string_view word : {"declare", "macro"})
            if (before.ends_with(word)) return true;
    }
    return false;
}

/// The texts of the standard includes by their names.
std::map<std::string, std::string> read_standard_includes() {
    constexpr uint64_t kLargest = 1 << 22;
    std::map<std::string, std::string> out;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(kStandardIncludes, error)) {
        if (entry.path().extension() != ".inc") continue;
        if (auto text = read_whole(entry.path().string(), kLargest)) out.emplace(entry.path().filename().string(), std::move(*text));
    }
    return out;
}

}  // namespace

std::string include_that_declares(std::string_view name) {
    static const std::map<std::string, std::string> includes = read_standard_includes();   // once: a scene can have many names that are not declared
    for (const auto& [file, text] : includes)
        if (declares(text, name)) return file;
    return {};
}

}  // namespace alidade::pov
