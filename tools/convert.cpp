// SPDX-License-Identifier: Apache-2.0
#include "exporters/exporter.h"
#include "tools/interrupt.h"
#include "tools/json.h"
#include "tools/load.h"
#include "tools/output.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade {

namespace {

Json to_json(const std::vector<Loss>& losses) {
    Json list = Json::array();
    for (const Loss& loss : losses) list.push_back({{"what", loss.what}, {"count", loss.count}, {"instead", loss.instead}});
    return list;
}

void tell(const std::string& output, const Exported& exported) {
    for (const Loss& loss : exported.losses)
        fmt::print(stderr, "{}: lost: {} ({}){}\n", output, loss.what, loss.count, loss.instead.empty() ? "" : "; instead: " + loss.instead);
    fmt::print(stderr, "{}\n", fmt::join(exported.files, "\n"));
}

}  // namespace

int run_convert(const Verb& verb, const Words& given) {
    Request request;
    std::string output;
    bool json = false;
    CLI::App app;
    add_scene_options(app, request);
    app.add_option("OUT", output, fmt::format("the file to write; its ending names the format: {}", known_endings()))->type_name("FILE")->required();
    ExportOptions options;
    app.add_option("--segments", options.segments, "of a full circle where spheres and other closed forms become meshes; solids get as many cells along their longest side (64)")
        ->type_name("N")->check(CLI::Range(3, 1024));
    app.add_flag("--json", json, "prints what was written and what was lost as JSON");
    if (const auto code = parse_words(app, verb, given)) return *code;
    const ExporterEntry* exporter = find_exporter(output);
    if (!exporter) return usage_error(verb, fmt::format("'{}' has no ending that names a format to write: {}", output, known_endings()));
    const auto fail = [](const std::string& sentence) { return fmt::print(stderr, "alidade: error: {}\n", sentence), int(kError); };
    if (const std::string why = why_no_file(output); !why.empty()) return fail(why);

    exit_on_signal();
    Loaded loaded = load(request);
    fmt::print(stderr, "{}", loaded.said.text());
    if (!loaded.scene) return kError;
    const auto exported = export_scene(*loaded.scene, output, options);
    if (!exported) return fail(exported.error());
    tell(output, *exported);
    if (json)
        fmt::print("{}", as_json_text({{"scene", request.scene}, {"exporter", exporter->name}, {"files", exported->files},
                                       {"lost", to_json(exported->losses)}, {"messages", to_json(loaded.said)}}));
    return kDone;
}

}  // namespace alidade
