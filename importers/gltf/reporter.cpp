// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/reporter.h"

#include "importers/gltf/extensions.h"
#include "importers/gltf/json.h"

#include <fmt/format.h>

namespace alidade::gltf {

std::string child(const std::string& parent, std::string_view key) {
    std::string out = parent + '/';
    for (const char c : key) {
        if (c == '~') out += "~0";
        else if (c == '/') out += "~1";
        else out += c;
    }
    return out;
}

std::string child(const std::string& parent, size_t index) { return fmt::format("{}/{}", parent, index); }

void Reporter::not_understood(std::string pointer, std::string message, std::string hint) {
    if (strict_) error(std::move(pointer), std::move(message), std::move(hint));
    else warning(std::move(pointer), std::move(message), std::move(hint));
}

void Reporter::extension_ignored(std::string pointer, const std::string& name) {
    if (!ignored_.insert(name).second) return;
    const Extension* known = find_extension(name);
    if (known && known->support == Support::harmless) return;
    not_understood(std::move(pointer), known ? fmt::format("extension {} is not supported and is ignored: {}", name, known->doc)
                                             : fmt::format("unknown extension {} is ignored", name));
}

}  // namespace alidade::gltf
