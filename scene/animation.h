// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/transform.h"
#include "scene/ids.h"

#include <string>
#include <vector>

namespace alidade {

/// Translation, rotation (unit quaternion x, y, z, w) and scale: what an animation can interpolate.
struct Trs {
    Vec3 translation{0};
    Vec4 rotation{0, 0, 0, 1};
    Vec3 scale{1};

    Transform transform() const;
};

enum class ChannelPath { translation, rotation, scale, weights };
enum class Interpolation { step, linear, cubic };

/// `values` holds `width` numbers a key (three times as many for cubic: in-tangent, value, out-tangent); times are seconds, increasing.
struct Channel {
    NodeId target;
    ChannelPath path = ChannelPath::translation;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times, values;
    uint32_t width = 3;
};

struct Animation {
    std::string name;
    std::vector<Channel> channels;
};

/// joint matrix = world(joint) * inverse_bind[joint]
struct Skin {
    std::string name;
    std::vector<NodeId> joints;
    std::vector<Transform> inverse_bind;   ///< empty: identity
};

}  // namespace alidade
