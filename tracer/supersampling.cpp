// SPDX-License-Identifier: Apache-2.0
#include "tracer/supersampling.h"

#include <map>

namespace alidade {
namespace {

/// Colours as they are compared, and what shows through them.
class Difference {
  public:
    Difference(const Supersampling& how, const BlockRays& rays) : how_(how), rays_(rays) {}
    Vec4 coded(const PixelSamples& pixel) const {
        const Color c = glm::max(rays_.comparable(pixel.radiance / double(pixel.samples)), Color(0));
        const double power = 1 / how_.gamma;
        return {std::pow(c.x, power), std::pow(c.y, power), std::pow(c.z, power), pixel.sum.shows / double(pixel.samples)};
    }
    bool between(const Vec4& a, const Vec4& b) const { return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z) + std::abs(a.w - b.w) >= how_.threshold; }

  private:
    const Supersampling& how_;
    const BlockRays& rays_;
};

/// Method 1: every pixel has a ray through its centre. Where it differs from the pixel to its left or above, both get a grid of rays more, once.
class GridBlock {
  public:
    GridBlock(const Supersampling& how, const Region& block, const Region& wanted, const BlockRays& rays)
        : how_(how), block_(needed(block, wanted)), wanted_(wanted), rays_(rays), difference_(how, rays), columns_(block_.x1 - block_.x0 + 1) {
        pixels_.resize(size_t(columns_) * size_t(block_.y1 - block_.y0 + 1));
    }

    std::optional<std::vector<PixelSamples>> run() {
        for (int x = block_.x0; x < block_.x1; ++x) begin(x, block_.y0 - 1);
        for (int y = block_.y0; y < block_.y1; ++y) {
            if (rays_.stopped()) return std::nullopt;
            begin(block_.x0 - 1, y);
            for (int x = block_.x0; x < block_.x1; ++x) {
                begin(x, y);
                compare(x, y);
            }
        }
        std::vector<PixelSamples> out;
        for (int y = wanted_.y0; y < wanted_.y1; ++y)
            for (int x = wanted_.x0; x < wanted_.x1; ++x) out.push_back(at(x, y).samples);
        return out;
    }

  private:
    /// A pixel depends on those before it, which may have been refined, and on the first rays of the one to its right and the one below.
    static Region needed(const Region& block, const Region& wanted) { return {block.x0, block.y0, std::min(block.x1, wanted.x1 + 1), std::min(block.y1, wanted.y1 + 1)}; }

    struct Pixel {
        PixelSamples samples;
        Vec4 coded{0};
        bool refined = false;
    };

    /// The pixels of the block, and those above and to the left of it, which are there to be compared with.
    Pixel& at(int x, int y) { return pixels_[size_t(y - block_.y0 + 1) * size_t(columns_) + size_t(x - block_.x0 + 1)]; }
    uint32_t count() const { return uint32_t(how_.depth * how_.depth + 1); }

    void begin(int x, int y) {
        Pixel& pixel = at(x, y);
        pixel.samples = rays_.take({x, y, Vec2(0.5), 0, 0, count()});
        pixel.coded = difference_.coded(pixel.samples);
    }
    /// A pixel as its first ray saw it, with neighbours that may have been refined already.
    void compare(int x, int y) {
        const Vec4 own = at(x, y).coded;
        for (const auto& [beside_x, beside_y] : {std::pair(x - 1, y), std::pair(x, y - 1)}) {
            if (!difference_.between(own, at(beside_x, beside_y).coded)) continue;
            refine(beside_x, beside_y);
            refine(x, y);
        }
    }
    void refine(int x, int y) {
        Pixel& pixel = at(x, y);
        if (pixel.refined || x < block_.x0 || y < block_.y0) return;   // nobody looks at those outside again
        pixel.refined = true;
        for (int row = 0; row < how_.depth; ++row)
            for (int column = 0; column < how_.depth; ++column) {
                const uint32_t index = uint32_t(row * how_.depth + column + 1);
                pixel.samples.add(rays_.take({x, y, Vec2(column + 0.5, row + 0.5) / double(how_.depth), how_.jitter / how_.depth, index, count()}));
            }
        pixel.coded = difference_.coded(pixel.samples);
    }

    const Supersampling& how_;
    const Region block_, wanted_;
    const BlockRays& rays_;
    const Difference difference_;
    const int columns_;
    std::vector<Pixel> pixels_;
};

/// Method 2: rays go through the corners of pixels. A square whose corners differ is divided in four, else it is the mean of its corners. No pixel
/// depends on another.
class CornerBlock {
  public:
    CornerBlock(const Supersampling& how, const Region& block, const BlockRays& rays) : how_(how), block_(block), rays_(rays), difference_(how, rays), parts_(1 << (how.depth - 1)) {}

    std::optional<std::vector<PixelSamples>> run() {
        std::vector<PixelSamples> out;
        for (int y = block_.y0; y < block_.y1; ++y) {
            if (rays_.stopped()) return std::nullopt;
            for (int x = block_.x0; x < block_.x1; ++x) out.push_back(pixel(x, y));
            corners_.erase(corners_.begin(), corners_.lower_bound({y + 1, 0}));
        }
        return out;
    }

  private:
    struct Corner {
        PixelSamples samples;
        Vec4 coded{0};
    };

    /// Points of the lattice are moved at random, but the corners of pixels stay (measured on POV-Ray's pictures: where nothing is divided, jitter changes nothing).
    Corner taken(int x, int y, int column, int row) const {
        const auto row_size = uint32_t(parts_ + 1);
        const Vec2 at = Vec2(column, row) / double(parts_);
        const bool moves = column % parts_ != 0 || row % parts_ != 0;
        Corner corner{rays_.take({x, y, at, moves ? how_.jitter / (2 * parts_ + 1) : 0, uint32_t(row) * row_size + uint32_t(column), parts_ == 1 ? 1 : row_size * row_size}), {}};
        corner.coded = difference_.coded(corner.samples);
        return corner;
    }
    /// A point of the lattice of `parts_` by `parts_` squares in the pixel (x, y). Pixels share their corners.
    const Corner& corner(int x, int y, int column, int row) {
        const bool own = column % parts_ == 0 && row % parts_ == 0;
        auto& known = own ? corners_ : inner_;
        const std::pair key = own ? std::pair(y + row / parts_, x + column / parts_) : std::pair(row, column);
        const auto found = known.find(key);
        if (found != known.end()) return found->second;
        return known.emplace(key, own ? taken(key.second, key.first, 0, 0) : taken(x, y, column, row)).first->second;
    }

    PixelSamples pixel(int x, int y) {
        inner_.clear();
        used_.clear();
        const Vec4 mean = square(x, y, 0, 0, parts_);
        PixelSamples out;
        for (const auto& [row, column] : used_) out.add(corner(x, y, column, row).samples);
        out.radiance = Color(mean) * double(out.samples), out.sum.shows = mean.w * double(out.samples);   // corners count as the squares do that they belong to
        return out;
    }

    /// The mean of the colour, and of what shows through it.
    Vec4 square(int x, int y, int column, int row, int size) {
        const std::pair<int, int> places[] = {{row, column}, {row, column + size}, {row + size, column}, {row + size, column + size}};
        const Corner* corners[4];
        for (int i = 0; i < 4; ++i) corners[i] = &corner(x, y, places[i].second, places[i].first);
        if (size > 1 && differ(corners)) {
            const int half = size / 2;
            return (square(x, y, column, row, half) + square(x, y, column + half, row, half) + square(x, y, column, row + half, half) + square(x, y, column + half, row + half, half)) * 0.25;
        }
        Vec4 sum(0);
        for (int i = 0; i < 4; ++i) sum += Vec4(corners[i]->samples.radiance, corners[i]->samples.sum.shows);
        used_.insert(used_.end(), std::begin(places), std::end(places));
        return sum * 0.25;
    }
    bool differ(const Corner* const (&corners)[4]) const {
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < i; ++k)
                if (difference_.between(corners[i]->coded, corners[k]->coded)) return true;
        return false;
    }

    using Corners = std::map<std::pair<int, int>, Corner>;   // by row and column
    const Supersampling& how_;
    const Region block_;
    const BlockRays& rays_;
    const Difference difference_;
    const int parts_;
    Corners corners_, inner_;                          // of pixels, in the picture; of one pixel's inside
    std::vector<std::pair<int, int>> used_;            // by one pixel, once for each square
};

}  // namespace

std::optional<std::vector<PixelSamples>> supersample(const Supersampling& how, const Region& block, const Region& wanted, const BlockRays& rays) {
    return how.method == 2 ? CornerBlock(how, wanted, rays).run() : GridBlock(how, block, wanted, rays).run();
}

}  // namespace alidade
