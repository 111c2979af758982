// SPDX-License-Identifier: Apache-2.0
/// A PatternPicture, decoded and ready to be asked.
#pragma once

#include "core/image.h"
#include "scene/scene.h"

#include <array>
#include <memory>

namespace alidade {

/// A colour of POV-Ray's: what part of the light that passes is coloured (filter), what part is not (transmit).
struct PigmentColor {
    Color color{0};
    double filter = 0, transmit = 0;
    bool ended = false;   ///< outside of a picture that is shown once: there is nothing to colour
};

/// Red, green, blue, filter, transmit.
inline std::array<double, 5> components(const PigmentColor& c) { return {c.color.x, c.color.y, c.color.z, c.filter, c.transmit}; }

class SpacePicture {
  public:
    /// Or why not, in one sentence. `settings`: what the colours of the scene mean.
    static tl::expected<SpacePicture, std::string> make(const PatternPicture& how, const Image& image, const RenderSettings& settings);

    /// The colour of an image_map at a place: clear around a picture that is not repeated.
    /// Source   POV-Ray 3.7 reference, 3.4.7.7 "Bitmap Modifiers"; verified by probing to the last 16-bit step.
    PigmentColor color(const Vec3& place) const;
    /// The number of an image_pattern: 0 around a picture that is not repeated.
    double value(const Vec3& place) const;
    /// How values rise from pixel to pixel, to the right and upwards, as bump_map takes them: through that at the place and those at its lower left and right.
    Vec2 rise(const Vec3& place) const;
    const PatternPicture& how() const { return how_; }
    size_t bytes() const { return picture_.values.size() * sizeof(float); }

  private:
    struct Texel {
        Vec4 rgba{0};   ///< the last is what is transmitted
        double filter = 0, value = 0;
    };
    std::optional<Vec2> pixel(const Vec3& place) const;
    /// Are values whole numbers, from 0 to 255?
    bool is_numbered() const;
    Texel texel(int x, int y) const;
    Texel sampled(const Vec2& at) const;
    Texel between(const Vec2& at) const;
    void decode(StoredPicture& stored, const RenderSettings& settings);
    void set_clearings(std::vector<uint8_t> palette);

    PatternPicture how_;
    Picture picture_;
    struct Clear {
        double filter = 0;
        std::optional<double> transmit;
    };
    bool decoded_ = false;                ///< the curve is not that of the file
    bool transmits_red_ = false;          ///< PictureValue::transmission of a picture without alpha
    bool truncated_ = false;              ///< what is calculated is cut to 8 bits: of a grey PNG of 8 bits
    std::vector<uint8_t> palette_;        ///< of each pixel; empty where the file has none
    std::array<Clear, 256> clear_{};      ///< by colour of the palette; the first alone without one
};

/// Each picture is read once for each way in which it is shown.
class SpacePictures {
  public:
    tl::expected<std::shared_ptr<const SpacePicture>, std::string> get(const PatternPicture& how, const Scene& scene);
    const std::vector<std::shared_ptr<const SpacePicture>>& all() const { return known_; }

  private:
    std::vector<std::shared_ptr<const SpacePicture>> known_;
};

}  // namespace alidade
