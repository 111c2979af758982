// SPDX-License-Identifier: Apache-2.0
/// The figures as one HTML file: tables, and plots of how costs grow.
#pragma once

#include "tools/json.h"

#include <string>
#include <string_view>

namespace alidade {

/// The page's own files, as the build put them into the program.
extern const std::string_view kStressJs, kStressCss;

/// Of what stress_document() makes.
std::string stress_page(const Json& document);

}  // namespace alidade
