// SPDX-License-Identifier: Apache-2.0
#include "tracer/interior_carrier.h"

#include <algorithm>

namespace alidade {

size_t interior_carrier(const Scene& scene, const std::vector<NodeId>& path) {
    for (size_t length = path.size(); length > 0; --length)
        if (scene.nodes[path[length - 1].index].interior) return length;
    for (size_t i = 0; i < path.size(); ++i)
        if (scene.nodes[path[i].index].csg != CsgKind::none) return i + 1;
    return 0;
}

bool is_hollow(const Scene& scene, const std::vector<NodeId>& path, size_t carrier) {
    const auto says = [&](NodeId id) { return scene.nodes[id.index].flags.hollow; };
    if (carrier == 0) return std::any_of(path.begin(), path.end(), says);
    if (std::any_of(path.begin(), path.begin() + std::ptrdiff_t(carrier), says)) return true;
    for (NodeId part = path[carrier - 1];;) {
        const auto& parts = scene.nodes[part.index].children;
        const auto last = std::find_if(parts.rbegin(), parts.rend(), [&](NodeId id) { return !scene.nodes[id.index].interior; });   // one with an interior is a body of its own
        if (last == parts.rend()) return false;
        if (says(part = *last)) return true;
    }
}

}  // namespace alidade
