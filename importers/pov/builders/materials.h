// SPDX-License-Identifier: Apache-2.0
/// material -> its layers and its interior.
#pragma once

#include "importers/pov/builders/textures.h"

namespace alidade::pov {

/// `material { ... }`: layers are moved by what stands behind them in it, those of the inside are not.
struct MaterialParts {
    TextureLayers layers, inside;
    std::optional<InteriorId> interior;
};

/// `interior`: that which the object has already.
MaterialParts read_material(Build& build, const Block& block, std::optional<InteriorId> interior);

}  // namespace alidade::pov
