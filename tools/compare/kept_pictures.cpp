// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/kept_pictures.h"

#include "core/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace alidade {

namespace fs = std::filesystem;

KeptPictures::KeptPictures(const std::string& cache, const std::string& key, const std::string& ending, int count) : seconds_(fmt::format("{}/{}.seconds", cache, key)) {
    for (int i = 0; i < count; ++i) pictures_.push_back(fmt::format("{}/{}{}{}", cache, key, i ? fmt::format("-{}", i) : "", ending));
}

std::optional<Rendered> KeptPictures::find() const {
    if (!std::all_of(pictures_.begin(), pictures_.end(), [](const std::string& path) { return fs::exists(path); })) return std::nullopt;
    Rendered found;
    found.picture = pictures_[0], found.more = {pictures_.begin() + 1, pictures_.end()};
    std::ifstream(seconds_) >> found.cpu_seconds;
    found.from_cache = true;
    return found;
}

void KeptPictures::keep(const Rendered& rendered) const {
    std::error_code ignored;
    fs::create_directories(fs::path(seconds_).parent_path(), ignored);
    const std::string seconds = fmt::format("{}\n", rendered.cpu_seconds);
    if (!write_file(seconds_, std::as_bytes(std::span(seconds)))) return;
    for (size_t i = pictures_.size(); i-- > 0;) {
        const auto bytes = read_file(i ? rendered.more[i - 1] : rendered.picture);
        if (!bytes || !write_file(pictures_[i], *bytes)) return;
    }
}

std::string default_cache() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    if (cache && *cache) return std::string(cache) + "/alidade/references";
    return home && *home ? std::string(home) + "/.cache/alidade/references" : (fs::temp_directory_path() / "alidade-references").string();
}

}  // namespace alidade
