// SPDX-License-Identifier: Apache-2.0
#include "tracer/tiles.h"

#include "tracer/supersampling.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade {

namespace {

Region common(const Region& a, const Region& b) { return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)}; }

/// What is rendered, if it can be.
tl::expected<Region, std::string> checked_region(const RenderOptions& o) {
    constexpr int kLargest = 1 << 16;
    if (o.width < 1 || o.height < 1 || o.width > kLargest || o.height > kLargest)
        return tl::unexpected(fmt::format("a picture of {}x{} pixels cannot be made: both sides must be 1 to {}", o.width, o.height, kLargest));
    if (o.tile < 1 || o.tile > 4096) return tl::unexpected(fmt::format("a tile of {} pixels cannot be made: 1 to 4096", o.tile));
    if (o.spp < 0 || o.light_samples < 1) return tl::unexpected(fmt::format("{} samples a pixel and {} a light cannot be taken", o.spp, o.light_samples));
    if (const auto& s = o.supersampling; s && (s->method < 1 || s->method > 2 || s->depth < 1 || s->depth > 9 || !(s->gamma > 0)))
        return tl::unexpected(fmt::format("antialiasing by the method {} with depth {} and gamma {} is not there: methods are 1 and 2, depths 1 to 9", s->method, s->depth, s->gamma));
    if (!(o.adaptive >= 0)) return tl::unexpected(fmt::format("an error of {} cannot be sampled for", o.adaptive));
    if (o.aperture.value_or(0) < 0 || o.focus.value_or(1) <= 0) return tl::unexpected(std::string("a lens needs an aperture of at least 0 and a focus distance above 0"));
    const Region whole{0, 0, o.width, o.height};
    if (!o.region) return whole;
    const Region r = *o.region;
    if (r.x0 < 0 || r.y0 < 0 || r.x1 > o.width || r.y1 > o.height || r.x0 >= r.x1 || r.y0 >= r.y1)
        return tl::unexpected(fmt::format("the region {},{},{},{} is empty or leaves the picture of {}x{}", r.x0, r.y0, r.x1, r.y1, o.width, o.height));
    return r;
}

}  // namespace

Region TileGrid::square(size_t i) const {
    const int x = (first_column + int(i % size_t(columns))) * size, y = (first_row + int(i / size_t(columns))) * size;
    return common({x, y, x + size, y + size}, {0, 0, width, height});
}

Region TileGrid::tile(size_t i) const { return common(square(i), region); }

tl::expected<TileGrid, std::string> tile_grid(const RenderOptions& options) {
    const auto region = checked_region(options);
    if (!region) return tl::unexpected(region.error());
    TileGrid grid{*region, options.width, options.height, options.supersampling ? kSupersamplingBlock : options.tile};
    grid.first_column = region->x0 / grid.size, grid.first_row = region->y0 / grid.size;
    grid.columns = (region->x1 - 1) / grid.size + 1 - grid.first_column;
    grid.rows = (region->y1 - 1) / grid.size + 1 - grid.first_row;
    return grid;
}

}  // namespace alidade
