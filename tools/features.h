// SPDX-License-Identifier: Apache-2.0
/// What the program can do, from the tables that do it.
#pragma once

#include "tools/json.h"

namespace alidade {

/// One key a registry (importers, exporters, shapes, accelerators, instruction sets, integrators, samplers, output layers, verbs); its rows as objects.
Json features();

}  // namespace alidade
