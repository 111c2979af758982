// SPDX-License-Identifier: Apache-2.0
#include "tracer/unrendered.h"

#include "scene/queries.h"

namespace alidade {
namespace {

struct Unrendered {
    Requirement what;
    Severity severity;
    const char* sentence;
};

constexpr Unrendered kTable[] = {
    {Requirement::media, Severity::warning, "media are not rendered yet: they are left out"},
};

}  // namespace

void report_unrendered(const Scene& scene, Diagnostics& said) {
    const std::vector<RequiredBy> required = requirements(scene);
    for (const Unrendered& row : kTable)
        for (const RequiredBy& r : required)
            if (r.what == row.what) said.add({row.severity, r.first, row.sentence, {}, {}, {}});
    if (scene.atmosphere.environment_image) said.warning({}, "environment images of a scene are not rendered yet", "--environment FILE sets one");
}

}  // namespace alidade
