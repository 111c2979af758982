// SPDX-License-Identifier: Apache-2.0
#include "tools/features.h"

#include "accel/accelerator.h"
#include "eval/shapes/shape_ops.h"
#include "exporters/exporter.h"
#include "importers/importer.h"
#include "tools/metrics/metric.h"
#include "tools/verbs.h"
#include "tracer/render.h"
#include "tracer/sampler.h"

#include <nlohmann/json.hpp>

namespace alidade {

namespace {

/// {name, doc} of each row, with whatever `more` adds.
template <class Rows, class More> Json rows_of(const Rows& rows, const More& more) {
    Json list = Json::array();
    for (const auto& row : rows) {
        Json each = {{"name", row.name}};
        more(row, each);
        each["doc"] = row.doc;
        list.push_back(std::move(each));
    }
    return list;
}

template <class Rows> Json rows_of(const Rows& rows) {
    return rows_of(rows, [](const auto&, Json&) {});
}

Json instruction_sets() {
    Json list = Json::array();
    for (const Isa isa : available_isas()) list.push_back({{"name", name(isa)}});
    return list;
}

}  // namespace

Json features() {
    return {
        {"importers", rows_of(importers(), [](const ImporterEntry& row, Json& each) { each["extensions"] = row.extensions; })},
        {"exporters", rows_of(exporters(), [](const ExporterEntry& row, Json& each) { each["extensions"] = row.extensions; })},
        {"shapes", rows_of(shapes())},
        {"accelerators", rows_of(accelerators())},
        {"intersect", rows_of(intersects(), [](const IntersectEntry& row, Json& each) {
             each["leaks at edges, of a million"] = row.measured.edges, each["leaks at vertices, of a million"] = row.measured.vertices;
             each["wrong decisions, of a million"] = row.measured.decisions, each["time over exact's"] = row.measured.time;
         })},
        {"instruction sets", instruction_sets()},
        {"integrators", rows_of(integrators())},
        {"samplers", rows_of(samplers())},
        {"output layers", rows_of(aovs(), [](const AovEntry& row, Json& each) { each["channels"] = row.channels; })},
        {"metrics", rows_of(metrics(), [](const Metric& row, Json& each) { each["unit"] = row.unit; })},
        {"verbs", rows_of(verbs(), [](const Verb& row, Json& each) { each["usage"] = row.usage, each["exits"] = row.exits; })},
    };
}

}  // namespace alidade
