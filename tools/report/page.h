// SPDX-License-Identifier: Apache-2.0
/// One HTML file that shows data by a script of its own: opened from disk, without a network.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace alidade {

/// The pages' files, as the build put them into the program (embed.cmake).
extern const std::string_view kReportHtml, kReportCss, kReportJs, kReportElements;

/// Bytes as a page holds them.
std::string base64(std::span<const std::byte> bytes);

/// report.html with everything in it: `data` as the script's `data`; elements.js stands before `script`, and `blocks` behind it. Texts of the data reach the page
/// as text alone; a content policy forbids every request.
std::string page_html(const std::string& title, std::string_view style, const nlohmann::ordered_json& data, std::string_view script, std::string_view blocks = "");

}  // namespace alidade
