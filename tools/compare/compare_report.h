// SPDX-License-Identifier: Apache-2.0
/// Comparisons of renders as one HTML page.
#pragma once

#include "tools/compare/corpus.h"
#include "tools/report/report.h"

namespace alidade {

/// One scene.
ReportPair report_pair(const SceneComparison& compared);
/// A list's scenes; their pictures are read from the folder of results.
std::vector<ReportPair> report_pairs(const std::vector<CorpusResult>& results, const CorpusRequest& request);

/// Writes the page. An error is one sentence.
tl::expected<void, std::string> write_report(const std::string& path, const std::string& title, const ReferenceProgram& against, std::vector<ReportPair> pairs);

}  // namespace alidade
