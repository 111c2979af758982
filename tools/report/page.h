// SPDX-License-Identifier: Apache-2.0
/// The page's files, as the build put them into the program (embed.cmake).
#pragma once

#include <string_view>

namespace alidade {

extern const std::string_view kReportHtml, kReportCss, kReportJs;

}  // namespace alidade
