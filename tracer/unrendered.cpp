// SPDX-License-Identifier: Apache-2.0
#include "tracer/unrendered.h"

#include "scene/queries.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade {
namespace {

struct Unrendered {
    Requirement what;
    Severity severity;
    const char* sentence;
};

constexpr Unrendered kTable[] = {
    {Requirement::clipping, Severity::warning, "clipped_by is not rendered yet: all of the object is drawn"},
    {Requirement::functions, Severity::error, "functions are not rendered yet"},
    {Requirement::media, Severity::warning, "media are not rendered yet: they are left out"},
};

/// One message a kind, with how many nodes are of it.
void report_csg(const Scene& scene, CsgKind kind, const char* sentence, Diagnostics& said) {
    const auto is_kind = [kind](const Node& node) { return node.csg == kind; };
    const auto first = std::find_if(scene.nodes.begin(), scene.nodes.end(), is_kind);
    if (first != scene.nodes.end()) said.warning(first->from, fmt::format("{} ({} of them)", sentence, std::count_if(first, scene.nodes.end(), is_kind)));
}

void report_nodes(const Scene& scene, Diagnostics& said) {
    report_csg(scene, CsgKind::intersection, "intersections are not rendered yet: they are left out", said);
    report_csg(scene, CsgKind::difference, "differences are not rendered yet: they are left out", said);
    report_csg(scene, CsgKind::merge, "merges are not rendered yet: they are drawn as unions", said);
}

}  // namespace

void report_unrendered(const Scene& scene, Diagnostics& said) {
    const std::vector<RequiredBy> required = requirements(scene);
    for (const Unrendered& row : kTable)
        for (const RequiredBy& r : required)
            if (r.what == row.what) said.add({row.severity, r.first, row.sentence, {}, {}, {}});
    report_nodes(scene, said);
    if (scene.atmosphere.environment_image) said.warning({}, "environment images of a scene are not rendered yet", "--environment FILE sets one");
}

}  // namespace alidade
