// SPDX-License-Identifier: Apache-2.0
/// tinygltf's own code, compiled once and without our warnings.
#include <nlohmann/json.hpp>
#define TINYGLTF_IMPLEMENTATION
#include "importers/gltf/model.h"
