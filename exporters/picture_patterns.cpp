// SPDX-License-Identifier: Apache-2.0
#include "exporters/picture_patterns.h"

#include "core/image_colors.h"
#include "exporters/output_files.h"

#include <algorithm>

namespace alidade {

namespace {

/// Do the picture's numbers stand for colours as those of a glTF texture do?
bool is_srgb(const PatternPicture& p, const RenderSettings& settings) {
    if (settings.srgb_coded) return p.scene_gamma || p.code == PictureCode::stored;
    return p.code == PictureCode::srgb || p.code == PictureCode::told_or_srgb;
}

/// From texture coordinates (v downwards) to the place on the picture.
std::optional<Mat3> lookup(const std::vector<Warp>& warps) {
    Transform there;
    for (const Warp& warp : warps) {
        const auto back = inverse(warp.transform);
        if (warp.kind != WarpKind::transform || !back) return std::nullopt;
        there = there * *back;   // the last is undone first
    }
    const Mat3& m = there.linear;
    const Mat3 flip(1, 0, 0, 0, -1, 0, 0, 1, 1);
    return flip * Mat3(m[0].x, m[0].y, 0, m[1].x, m[1].y, 0, there.translation.x, there.translation.y, 1) * flip;
}

}  // namespace

std::optional<ImageSignal> as_texture(const PatternSignal& pattern, const RenderSettings& settings) {
    if (pattern.pattern != kImageMap || !pattern.picture || !pattern.uv_mapped || !pattern.map.empty() || pattern.turbulence.amount != Vec3(0)) return std::nullopt;
    const PatternPicture& p = *pattern.picture;
    if (p.map != PictureMap::planar || p.premultiplied || !p.clearings.empty() || !is_srgb(p, settings)) return std::nullopt;
    const auto placed = lookup(pattern.warps);
    if (!placed) return std::nullopt;
    ImageSignal out;
    out.image = p.image, out.srgb = true, out.uv_transform = *placed;
    if (p.filter == PictureFilter::none) out.filter = Filter::nearest;
    if (p.once) out.wrap_u = out.wrap_v = Wrap::once;
    return out;
}

bool has_alpha(const Image& image) {
    const auto bytes = OutputFiles::read(image);
    const auto picture = bytes ? decode_picture(std::as_bytes(std::span(*bytes)), Encoding::linear) : tl::unexpected(std::string());
    return picture && color_channels(*picture).size() % 2 == 0 && !color_channels(*picture).empty();   // Y, A or R, G, B, A
}

}  // namespace alidade
