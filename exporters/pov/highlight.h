// SPDX-License-Identifier: Apache-2.0
/// GGX's highlight in the words of POV-Ray's finish.
#pragma once

#include <map>
#include <tuple>

namespace alidade::pov_export {

/// Factors and exponents of lobes that are added: Blinn's (n.h)^p, Phong's (r.l)^q, and Lambert's n.l for metals, whose whole light has the colour of the pigment.
struct Lobes {
    double specular = 0, roughness = 0.05;
    double phong = 0, phong_size = 40;
    double diffuse = 0;
};

struct Gloss {
    double alpha = 1;           ///< roughness squared
    double f0 = 0.04, f90 = 1;  ///< Fresnel's term straight on and at grazing angles
    bool metal = false;
};

/// The lobes that are nearest to glTF's microfacets (2.0, appendix B.3) for light that makes a white diffuse surface white.
///
/// Method   Least squares with factors >= 0, for each pair of exponents of a list, over directions to the eye and half vectors that are denser towards the normal. Errors
///          count by the brightness that they change, 1 / (it + 0.1), and less at grazing angles, of which little is seen and on which little light falls. Where the
///          diffuse lobe of a surface that reflects the half gets less, because more is mirrored, highlights are fainter by that.
/// Error    The mean difference, of what is displayed, is on average 0.75 of that of the one lobe of Blinn's that has GGX's height and width, of metals 0.45; at roughness
///          0.85 it is not less. Held by PovHighlight.
class HighlightFits {
  public:
    const Lobes& operator()(const Gloss& gloss);

  private:
    std::map<std::tuple<double, double, double, bool>, Lobes> known_;
};

/// pi times glTF's specular lobe times n.l, by the cosines between the normal, the half vector, the eye and the light.
double microfacet_light(const Gloss& gloss, double nh, double nl, double nv, double oh);

}  // namespace alidade::pov_export
