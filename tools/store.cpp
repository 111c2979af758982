// SPDX-License-Identifier: Apache-2.0
#include "tools/store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace alidade::tradeoff {
namespace {

std::string file_in(const std::string& folder) { return folder + "/measured.jsonl"; }

/// One write, so that a line is whole or the last one.
bool append(const std::string& path, const std::string& text) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0) return false;
    const bool written = ::write(file, text.data(), text.size()) == ssize_t(text.size());
    return ::close(file) == 0 && written;
}

/// The member in which two heads differ.
std::string difference(const Json& a, const Json& b) {
    for (const auto& [key, value] : a.items())
        if (!b.contains(key) || b[key] != value) return key;
    return "contents";
}

}  // namespace

bool Store::take(std::istream& lines) {
    bool cut = false;
    for (std::string line; std::getline(lines, line); cut = lines.eof()) {
        const Json entry = Json::parse(line, nullptr, false);
        if (entry.is_object() && entry.contains("key") && entry["key"].is_string() && entry.contains("value")) known_[entry["key"].get<std::string>()] = entry["value"];
    }
    return cut;
}

Value<Store> Store::read(const std::string& folder) {
    std::ifstream lines(file_in(folder));
    if (!lines) return tl::unexpected(fmt::format("cannot read {}", file_in(folder)));
    Store store;
    store.take(lines);
    return store;
}

Value<Store> Store::open(const std::string& folder, const Json& head) {
    Store store;
    store.folder_ = folder;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return tl::unexpected(fmt::format("cannot make the folder {}: {}", folder, error.message()));
    std::ifstream lines(file_in(folder));
    const bool cut = store.take(lines);
    if (cut && !append(file_in(folder), "\n")) return tl::unexpected(fmt::format("cannot write {}", file_in(folder)));
    if (const Json* known = store.find("head"); known && *known != head)
        return tl::unexpected(fmt::format("{} holds measurements of something else (another {}): take another folder, or remove it", folder, difference(head, *known)));
    if (store.find("head")) return store;
    if (!store.known_.empty()) return tl::unexpected(fmt::format("{} does not say of what its measurements are: take another folder", folder));
    if (const auto kept = store.keep("head", head); !kept) return tl::unexpected(kept.error());
    return store;
}

const Json* Store::find(const std::string& key) const {
    const auto found = known_.find(key);
    return found == known_.end() ? nullptr : &found->second;
}

Value<bool> Store::keep(const std::string& key, Json value) {
    const Json line = {{"key", key}, {"value", value}};
    known_[key] = std::move(value);
    if (folder_.empty() || append(file_in(folder_), line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n")) return true;
    return tl::unexpected(fmt::format("cannot write {}", file_in(folder_)));
}

}  // namespace alidade::tradeoff
