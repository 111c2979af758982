// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image.h"
#include "core/vec.h"

#include <functional>
#include <vector>

namespace alidade {

/// Light from infinitely far away, from all directions: a background that only is seen, a constant sky, or an equirectangular image.
class Sky {
  public:
    struct Sample {
        Vec3 direction{0};      ///< unit
        Color radiance{0};
        double density = 0;     ///< per steradian
    };

    /// A sky of one colour; `lights`: it does not only stand behind everything.
    Sky(const Color& color, bool lights) : color_(color), lights_(lights && !is_black(color)) {}
    /// What `seen` says of a unit direction: it is seen, and lights nothing.
    explicit Sky(std::function<Color(const Vec3&)> seen) : lights_(false), seen_(std::move(seen)) {}
    /// An image whose top row is +y, whose centre column is +x, and whose columns go from there towards +z (Blender's world in glTF's axes).
    Sky(Picture image, double strength);

    Color radiance(const Vec3& direction) const;
    bool lights() const { return lights_; }
    /// A direction for light on a surface with the unit normal `n`: in proportion to the cosine under a constant sky, to the image's luminance under
    /// an image.
    Sample sample(const Vec3& n, const Vec2& square) const;

  private:
    Vec3 direction_of(double column, double row) const;

    Color color_{0};
    bool lights_ = true;
    Picture image_;
    double strength_ = 1;
    std::function<Color(const Vec3&)> seen_;
    std::vector<double> rows_, columns_;   // cumulative luminance: of rows, and within each row
};

}  // namespace alidade
