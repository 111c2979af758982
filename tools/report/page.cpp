// SPDX-License-Identifier: Apache-2.0
#include "tools/report/page.h"

#include <utility>
#include <vector>

namespace alidade {
namespace {

using Json = nlohmann::ordered_json;

/// JSON that may stand inside <script>: without a '<' nothing there can end it.
std::string embedded(const Json& json) {
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string out;
    for (const char c : text) {
        if (c == '<') out += "\\u003c";
        else out += c;
    }
    return out;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '<') out += "&lt;";
        else if (c == '&') out += "&amp;";
        else out += c;
    }
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

std::string page_html(const std::string& title, std::string_view style, const Json& data, std::string_view script, std::string_view blocks) {
    const std::string heading = escaped(title), text = embedded(data);
    std::string whole(kReportElements);
    whole += script;
    return filled(kReportHtml, {{"title", heading}, {"style", style}, {"data", text}, {"pictures", blocks}, {"script", whole}});
}

}  // namespace alidade
