// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/compare_report.h"

#include "tools/diff/report_pair.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace alidade {

namespace fs = std::filesystem;

namespace {

/// What the page tells of the renders, beside the numbers of the pictures.
Json statistics_of(const Json& document) {
    Json out = Json::object();
    for (const char* key : {"grade", "noise", "reference_render", "test_render"})
        if (document.contains(key)) out[key] = document[key];
    return out;
}

std::vector<std::string> commands_of(const Json& document) {
    std::vector<std::string> commands;
    for (const char* key : {"reference_render", "test_render"})
        if (document.contains(key)) commands.push_back(document[key]["command"].get<std::string>());
    return commands;
}

}  // namespace

ReportPair report_pair(const SceneComparison& compared) {
    const Json document = to_json(compared);
    ReportPair out = report_pair(compared.comparison, compared.job.scene, commands_of(document));
    out.document = document, out.statistics = statistics_of(document), out.objects = compared.objects;
    return out;
}

std::vector<ReportPair> report_pairs(const std::vector<CorpusResult>& results, const CorpusRequest& request) {
    std::vector<ReportPair> pairs;
    for (const CorpusResult& result : results) {
        const Json& document = result.document;
        const auto path = [&](const char* key) { return (fs::path(request.out) / document[key].get<std::string>()).string(); };   // an absolute one stays as it is
        Comparison comparison;
        if (document.contains("test_picture") && document.contains("reference_picture"))
            comparison = compare_files(path("reference_picture"), path("test_picture"), request.diff);
        ReportPair pair = report_pair(comparison, result.entry.name, commands_of(document));
        pair.group = result.entry.group, pair.document = document, pair.statistics = statistics_of(document);
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

tl::expected<void, std::string> write_report(const std::string& path, const std::string& title, const ReferenceProgram& against, std::vector<ReportPair> pairs) {
    const auto page = report_html({title, {{"alidade", ALIDADE_VERSION}, {against.title, against.version()}}, std::move(pairs)});
    if (!page) return tl::unexpected(page.error());
    return write_file(path, std::as_bytes(std::span(*page)));
}

}  // namespace alidade
