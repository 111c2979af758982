// SPDX-License-Identifier: Apache-2.0
#include "stress/tree_file.h"

#include "core/output_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace alidade {
namespace {

/// The shortest that reads back to the same double. JSON has no infinities: null.
std::string number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

void append_ids(std::string& out, std::span<const uint32_t> ids) {
    out += '[';
    for (size_t i = 0; i < ids.size(); ++i) fmt::format_to(std::back_inserter(out), "{}{}", i ? "," : "", ids[i]);
    out += ']';
}

void append_node(std::string& out, const TreeNode& node) {
    const Bounds& b = node.box;
    fmt::format_to(std::back_inserter(out), "{{\"node\":{},\"parent\":{},\"depth\":{},\"box\":[{},{},{},{},{},{}],\"area\":{},\"{}\":", node.number, node.parent == kNoId ? "null" : std::to_string(node.parent), node.depth,
                   number(b.min.x), number(b.min.y), number(b.min.z), number(b.max.x), number(b.max.y), number(b.max.z), number(2 * b.half_area()), node.leaf ? "primitives" : "children");
    append_ids(out, node.leaf ? node.primitives : node.children);
    out += '}';
}

std::string head(const BuildStats& s, size_t triangles, std::string_view words) {
    std::string out = fmt::format("{{{}\"triangles\": {}, \"primitives\": {}, \"references\": {}, \"nodes\": {}, \"leaves\": {}, \"depth\": {}, \"splits\": {}, \"split_candidates\": {}, \"sah_cost\": {}, \"bytes\": {}, \"removed\": ", words, triangles,
                                  s.primitives, s.references, s.nodes, s.leaves, s.depth, s.splits, s.split_candidates, number(s.sah_cost), s.bytes);
    append_ids(out, s.removed);
    return out + ", \"tree\": [\n";
}

}  // namespace

bool tree_json(const Accelerator& accelerator, size_t triangles, const std::function<void(std::string_view)>& write, std::string_view words) {
    constexpr size_t kPiece = 1 << 16;
    std::string piece = head(accelerator.stats(), triangles, words);
    bool any = false;
    const bool tree = accelerator.visit_nodes([&](const TreeNode& node) {
        if (any) piece += ",\n";
        append_node(piece, node);
        any = true;
        if (piece.size() >= kPiece) write(piece), piece.clear();
    });
    if (tree) write(piece + "\n]}");
    return tree;
}

tl::expected<bool, std::string> write_trees(const std::string& path, const AcceleratorEntry& entry, const AccelOptions& options, const StressScene& scene) {
    OutputFile file(path);
    const auto write = [&](std::string_view text) { file.write(std::as_bytes(std::span(text))); };
    write(fmt::format("{{\"schema\": 1, \"accelerator\": \"{}\", \"precision\": \"{}\", \"trees\": [\n", entry.name, options.precision == Precision::float_ ? "float" : "double"));
    for (size_t i = 0; i < scene.meshes.size() && file.good(); ++i) {
        const auto built = entry.over_triangles(scene.meshes[i].view(), options);
        if (i > 0) write(",\n");
        if (!tree_json(*built, scene.meshes[i].triangles.size(), write, fmt::format("\"mesh\": {}, ", i))) return false;
    }
    write("\n]}\n");
    return file.finish().map([] { return true; });
}

}  // namespace alidade
