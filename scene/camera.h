// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/source.h"
#include "core/vec.h"
#include "scene/ids.h"

#include <optional>
#include <string>

namespace alidade {

enum class Projection { perspective, orthographic, fisheye, ultra_wide_angle, omnimax, panoramic, cylindrical, spherical };

/// What to do when the picture's aspect ratio is not the camera's own, |right| / |up|.
enum class Fit {
    stretch,    ///< the camera's window is the picture, whatever its pixels then look like (POV-Ray)
    show_all,   ///< pixels stay square: all of the camera's window is seen, and more on the longer side (glTF)
    height,     ///< pixels stay square: the camera's height is the picture's (glTF without aspectRatio)
};

/// In the space of its node. Perspective: the ray of the picture point (s, t), both in [0, 1] from the top left, has origin `location` and direction
/// `direction + (s - 1/2) right + (1/2 - t) up`. Orthographic: origin `location + (s - 1/2) right + (1/2 - t) up`, direction `direction`.
struct Camera {
    std::string name;
    Projection projection = Projection::perspective;
    Vec3 location{0}, direction{0, 0, -1}, right{1, 0, 0}, up{0, 1, 0};
    Fit fit = Fit::stretch;
    double angle = 0;            ///< degrees; used by the projections that are not linear
    double vertical_angle = 0;   ///< degrees; of the spherical projection, 0: half of `angle`
    int cylinder = 1;            ///< POV-Ray's kinds of the cylindrical projection, 1 to 4: the axis is up, right, up, right; in 3 and 4 the location moves along it
    double aperture = 0;         ///< diameter of the lens; 0: pinhole
    Vec3 focal_point{0, 0, -1};  ///< in focus
    int blur_samples = 0;
    double clearance = 0;        ///< what is nearer to the beginning of a ray is not seen (POV-Ray: 0.0001); world units
    std::optional<SignalId> normal;   ///< a ReliefSignal that bends the rays (POV-Ray)
    SourcePos from;
};

}  // namespace alidade
