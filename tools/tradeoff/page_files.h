// SPDX-License-Identifier: Apache-2.0
/// The page's files, as the build put them into the program.
#pragma once

#include <string_view>

namespace alidade::tradeoff {

extern const std::string_view kPageHtml, kPageCss, kPageJs;

}  // namespace alidade::tradeoff
