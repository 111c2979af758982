// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/text_files.h"

#include <fstream>

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

bool TextFiles::write(const TextFile& file) {
    if (file.kept) {
        std::string& text = kept_[file.path];
        if (!file.append) text.clear();
        text += file.text;
        return true;
    }
    std::ofstream out(file.path, std::ios::binary | (file.append ? std::ios::app : std::ios::trunc));
    out << file.text;
    return bool(out.flush());
}

}  // namespace alidade::pov
