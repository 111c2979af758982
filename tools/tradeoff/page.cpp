// SPDX-License-Identifier: Apache-2.0
/// The page: the document, and a small picture of each setting, shown by page.js.
#include "tools/tradeoff/page.h"

#include "tools/report/page.h"
#include "tools/tradeoff/document.h"

namespace alidade::tradeoff {

std::string as_page(const Experiment& experiment, const Verdicts& verdicts) {
    Json data = as_document(experiment, verdicts);
    Json& pictures = data["pictures"] = Json::array();
    for (const Row& row : experiment.rows) pictures.push_back({{"thumbnail", row.thumbnail}, {"flip", row.flip}});
    return page_html("What accuracy costs: " + experiment.job.scene, std::string(kReportCss) + std::string(kTradeoffCss), data, kTradeoffJs);
}

}  // namespace alidade::tradeoff
