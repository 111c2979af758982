// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/text_files.h"

namespace alidade::pov {

namespace fs = std::filesystem;

std::optional<std::string> TextFiles::below(const std::string& folder, const std::string& name) {
    std::error_code failed;
    const fs::path root = fs::weakly_canonical(folder, failed), path = fs::weakly_canonical(root / name, failed);
    if (failed || name.empty()) return std::nullopt;
    const auto [end, _] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    if (end != root.end() || path == root) return std::nullopt;
    return path.string();
}

const std::string* TextFiles::kept(const std::string& name) const {
    const auto at = kept_.find(name);
    return at == kept_.end() ? nullptr : &at->second;
}

bool TextFiles::open_on_disk(const Ref<TextFile>& file, bool append) {
    flush();
    written_.insert(file->path);
    file->out.open(file->path, std::ios::binary | (append ? std::ios::app : std::ios::trunc));
    on_disk_.push_back(file);
    return bool(file->out);
}

bool TextFiles::write(TextFile& file, const std::string& text) {
    if (file.kept) return *file.kept += text, true;
    return bool(file.out << text);
}

std::optional<std::string> TextFiles::flush() {
    std::optional<std::string> failed;
    for (const Ref<TextFile>& file : on_disk_)
        if (file->out.is_open() && !file->out.flush()) failed = file->path;
    std::erase_if(on_disk_, [](const Ref<TextFile>& file) { return file->uses == 1; });      // closed by the scene
    return failed;
}

bool TextFiles::wrote(const std::string& path) const {
    std::error_code failed;
    return !written_.empty() && written_.count(fs::weakly_canonical(path, failed).string());
}

}  // namespace alidade::pov
