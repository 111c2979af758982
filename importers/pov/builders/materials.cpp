// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/materials.h"

#include "importers/pov/builders/interiors.h"

namespace alidade::pov {

MaterialParts read_material(Build& build, const Block& block, std::optional<InteriorId> interior) {
    MaterialParts parts{{}, {}, interior};
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.block_at("material"_w)) {
            at.next();
            MaterialParts named = read_material(build, *base, {});
            parts = {{}, {}, named.interior};
            add_layers(build, parts.layers, std::move(named.layers), block.version), add_layers(build, parts.inside, std::move(named.inside), block.version);
        } else if (const Block* texture = at.block_at("texture"_w)) at.next(), add_layers(build, parts.layers, build_texture(build, *texture), texture->version);
        else if (const Block* inside = at.block_at("interior_texture"_w)) at.next(), add_layers(build, parts.inside, build_texture(build, *inside), inside->version);
        else if (const Block* within = at.block_at("interior"_w)) at.next(), parts.interior = add_interior(build, *within, parts.interior);
        else if (at.at_transform()) move_layers(build, parts.layers, at.transform());   // and not those of the inside (probed)
        else at.skip_unmodelled();
    }
    return parts;
}

}  // namespace alidade::pov
