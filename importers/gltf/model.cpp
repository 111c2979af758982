// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/model.h"

#include <charconv>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade::gltf {

namespace {

/// tinygltf asks for the "file" of buffer n by the name "n".
bool is_there(const std::string&, void*) { return true; }
std::string same_path(const std::string& path, void*) { return path; }
bool hand_over(std::vector<unsigned char>* out, std::string*, const std::string& path, void* user_data) {
    auto& buffers = *static_cast<std::vector<Bytes>*>(user_data);
    size_t index = 0;
    const auto end = path.data() + path.size();
    if (std::from_chars(path.data(), end, index).ptr != end || index >= buffers.size()) return false;
    *out = std::move(buffers[index]);
    return true;
}
bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }

}  // namespace

std::optional<tinygltf::Model> to_model(Json root, std::vector<Bytes> buffers, Reporter& report) {
    root.erase("images");
    for (size_t i = 0; i < buffers.size(); ++i) {
        if (buffers[i].empty()) buffers[i].resize(1);   // nothing refers to it, but tinygltf wants a byte
        root["buffers"][i] = {{"uri", fmt::format("{}", i)}, {"byteLength", buffers[i].size()}};
    }
    const std::string text = root.dump();
    root = nullptr;   // tinygltf makes a tree of its own: not both at once
    if (text.size() > std::numeric_limits<unsigned>::max()) {
        report.error("", "more than 4 GiB of JSON");
        return std::nullopt;
    }
    tinygltf::TinyGLTF reader;
    reader.SetFsCallbacks({is_there, same_path, hand_over, write_nothing, &buffers});
    std::optional<tinygltf::Model> model(std::in_place);
    std::string errors, warnings;
    try {
        if (reader.LoadASCIIFromString(&*model, &errors, &warnings, text.data(), unsigned(text.size()), "")) return model;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        errors = e.what();
    }
    report.error("", "tinygltf: " + errors.substr(0, errors.find('\n')));
    return std::nullopt;
}

}  // namespace alidade::gltf
