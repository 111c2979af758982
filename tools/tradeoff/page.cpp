// SPDX-License-Identifier: Apache-2.0
/// The page: tools/tradeoff/page/ with the document, and a small picture of each setting, in it.
#include "tools/tradeoff/document.h"
#include "tools/tradeoff/page_files.h"

#include <fmt/format.h>

namespace alidade::tradeoff {
namespace {

/// `text` with `with` in place of a character.
std::string replaced(const std::string& text, char what, const char* with) {
    std::string out;
    for (const char c : text) out += c == what ? std::string(with) : std::string(1, c);
    return out;
}

/// `page` with every {{key}} filled in. What is filled in is not looked at again.
std::string filled(std::string_view page, const std::vector<std::pair<std::string, std::string_view>>& values) {
    std::string out;
    while (!page.empty()) {
        const size_t open = page.find("{{"), close = page.find("}}", open);
        out += page.substr(0, open);
        if (close == page.npos) break;
        const std::string key(page.substr(open + 2, close - open - 2));
        for (const auto& [name, value] : values)
            if (name == key) out += value;
        page.remove_prefix(close + 2);
    }
    return out;
}

}  // namespace

std::string as_page(const Experiment& experiment, const Verdicts& verdicts) {
    Json data = as_document(experiment, verdicts);
    Json& pictures = data["pictures"] = Json::array();
    for (const Row& row : experiment.rows) pictures.push_back({{"thumbnail", row.thumbnail}, {"flip", row.flip}});
    const std::string title = replaced(replaced("What accuracy costs: " + experiment.job.scene, '&', "&amp;"), '<', "&lt;");
    const std::string text = replaced(data.dump(-1, ' ', false, Json::error_handler_t::replace), '<', "\\u003c");   // without a '<' nothing there ends the script
    return filled(kPageHtml, {{"title", title}, {"style", kPageCss}, {"data", text}, {"script", kPageJs}});
}

}  // namespace alidade::tradeoff
