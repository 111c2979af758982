// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/copies.h"

#include "scene/graph.h"
#include "scene/queries.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

void say_too_many(Build& build, const SourcePos& at, double copies, const std::string& what) {
    const Limits& limits = build.p.options.limits;
    build.p.said.error(at, fmt::format(fmt::runtime(what), fmt::format("{:.3g}", copies), limits.copies), how_to_raise(limits, &Limits::copies, copies));
}

void check_objects(Build& build) {
    const Scene& scene = build.scene;
    const std::vector<double> below = path_counts(scene);
    double copies = -double(scene.nodes.size());
    for (const NodeId root : scene.roots) copies += below[root.index];
    if (copies <= double(build.p.options.limits.copies)) return;
    const NodeId largest = *std::max_element(scene.roots.begin(), scene.roots.end(), [&](NodeId a, NodeId b) { return below[a.index] < below[b.index]; });
    say_too_many(build, scene.nodes[largest.index].from, copies, "objects that are named more than once make {} copies, most of them in this object: the limit is {}");
}

/// Each point of a surface may ask for all that a pigment or a normal is made of, as often as it is named.
void check_signals(Build& build) {
    const Scene& scene = build.scene;
    const auto operands = [&](uint32_t i, const auto& f) { for_each_operand(scene.signals[i], [&](SignalId of) { f(of.index); }); };
    const std::vector<uint32_t> order = topological_order(scene.signals.size(), operands).sequence;
    std::vector<double> parts(scene.signals.size(), 1);
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        operands(*i, [&](uint32_t of) { parts[*i] += parts[of]; });
        if (parts[*i] > double(build.p.options.limits.copies))
            return say_too_many(build, scene.signals[*i].from, parts[*i], "pigments or normals that are named in one another make one of {} parts: the limit is {}");
    }
}

}  // namespace

void check_copies(Build& build) {
    check_objects(build);
    check_signals(build);
}

}  // namespace alidade::pov
