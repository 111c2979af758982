// SPDX-License-Identifier: Apache-2.0
/// The page's own files, as the build put them into the program.
#pragma once

#include <string_view>

namespace alidade {

extern const std::string_view kTradeoffJs, kTradeoffCss;

}  // namespace alidade
