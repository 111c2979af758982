// SPDX-License-Identifier: Apache-2.0
#include "tools/stress/page.h"

#include "tools/report/page.h"

#include <nlohmann/json.hpp>

namespace alidade {

std::string stress_page(const Json& document) {
    std::string names;
    for (const Json& scene : document.at("scenes")) names += (names.empty() ? "" : ", ") + scene.at("name").get<std::string>();
    return page_html("Accelerators on " + names, std::string(kReportCss) + std::string(kStressCss), document, kStressJs);
}

}  // namespace alidade
