// SPDX-License-Identifier: Apache-2.0
/// GGX's highlight in the words of POV-Ray's finishes.
#pragma once

#include <array>
#include <map>
#include <tuple>

namespace alidade::pov_export {

/// factor cos^exponent.
struct Lobe {
    double factor = 0, exponent = 1;
};

/// Lobes that are added: Blinn's of n.h, Phong's of r.l, Lambert's of n.l. A finish has one of each kind.
struct Lobes {
    std::array<Lobe, 2> blinn, phong;
    Lobe lambert;
};

struct Gloss {
    double alpha = 1;           ///< roughness squared
    double f0 = 0.04, f90 = 1;  ///< Fresnel's term straight on and at grazing angles
    bool metal = false;
    bool layers = true;         ///< May it have more than one finish? Diffuse light of another colour than the pigment's also needs one.
};

/// The lobes that are nearest to glTF's microfacets (2.0, appendix B.3) for light that makes a white diffuse surface white.
///
/// Method   Least squares with factors >= 0 over directions to the eye and half vectors that are denser towards the normal, for each choice of exponents of a list. Second
///          lobes of Blinn's and Phong's are there if they take a tenth of the error away; their exponents are exchanged one after the other until that gains nothing.
///          Errors count by the brightness that they change, 1 / (it + 0.1), and less at grazing angles, of which little is seen and on which little light falls. Where
///          the diffuse lobe of a surface that reflects the half gets less, because more is mirrored, highlights are fainter by that.
/// Error    The mean difference, of what is displayed, is in one finish on average 0.75 of that of the one lobe of Blinn's that has GGX's height and width, of metals
///          0.45; at roughness 0.85 it is not less. In directions that are not near the highlight layers take a fifth off that, of metals a tenth. Held by PovHighlight.
class HighlightFits {
  public:
    const Lobes& operator()(const Gloss& gloss);

  private:
    std::map<std::tuple<double, double, double, bool, bool>, Lobes> known_;
};

/// pi times glTF's specular lobe times n.l, by the cosines between the normal, the half vector, the eye and the light.
double microfacet_light(const Gloss& gloss, double nh, double nl, double nv, double oh);

}  // namespace alidade::pov_export
