// SPDX-License-Identifier: Apache-2.0
/// A comparison as the HTML report shows it.
#pragma once

#include "tools/diff/document.h"
#include "tools/report/report.h"

namespace alidade {

/// With `commands` as they are to be shown. A comparison without pictures keeps its verdict and its reason.
ReportPair report_pair(const Comparison& comparison, const std::string& name, std::vector<std::string> commands);

}  // namespace alidade
