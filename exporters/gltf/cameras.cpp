// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/cameras.h"

#include "scene/queries.h"

namespace alidade::gltf_export {

namespace {

/// What glTF calls znear and zfar; ray tracers do not need them, but the format asks for them.
struct DepthRange {
    double near = 0, far = 0;
};

DepthRange depth_range(const Scene& scene) {
    const Bounds box = world_bounds(scene);
    const double reach = box.empty() || !box.finite() ? 0 : std::max(max_abs(box.min), max_abs(box.max));
    const double far = reach > 0 ? 4 * reach : 1000;
    return {far * 1e-5, far};
}

/// From the frame (x right, y up, -z ahead) to the camera's.
Transform frame_of(const Camera& camera) {
    const Vec3 x = normalized(camera.right), y = normalized(camera.up), z = -normalized(camera.direction);
    Transform out;
    out.linear[0] = x, out.linear[1] = y, out.linear[2] = z;
    out.translation = camera.location;
    return out;
}

bool is_skew(const Mat3& frame) {
    constexpr double kTolerance = 1e-9;
    return std::abs(dot(frame[0], frame[1])) > kTolerance || std::abs(dot(frame[1], frame[2])) > kTolerance || std::abs(dot(frame[2], frame[0])) > kTolerance;
}

}  // namespace

std::optional<CameraWriter::Written> CameraWriter::write(const Camera& camera) {
    const bool orthographic = camera.projection == Projection::orthographic;
    const double width = length(camera.right), height = length(camera.up), ahead = length(camera.direction);
    const Transform frame = frame_of(camera);
    if ((camera.projection != Projection::perspective && !orthographic) || !frame.is_finite() || !(width > 0 && height > 0 && ahead > 0)) {
        losses_.add("cameras that are neither perspective nor orthographic");
        return std::nullopt;
    }
    losses_.add("apertures of cameras", camera.aperture > 0, "pinholes");
    losses_.add("cameras with a skew window", is_skew(frame.linear), "upright ones");
    losses_.add("left-handed cameras", frame.determinant() < 0, "a mirroring node, which some programs ignore");
    losses_.add("cameras that stretch their picture", camera.fit == Fit::stretch, "their own aspect ratio");
    const DepthRange depth = depth_range(scene_);
    Json json = Json::object();
    set(json, "name", camera.name, std::string());
    json["type"] = orthographic ? "orthographic" : "perspective";
    if (orthographic) {
        json["orthographic"] = {{"xmag", width / 2}, {"ymag", height / 2}, {"znear", depth.near}, {"zfar", depth.far}};
    } else {
        json["perspective"] = {{"yfov", 2 * std::atan(height / (2 * ahead))}, {"znear", depth.near}};
        if (camera.fit != Fit::height) json["perspective"]["aspectRatio"] = width / height;
    }
    return Written{document_.add("cameras", std::move(json)), frame};
}

std::optional<CameraWriter::Written> CameraWriter::add(CameraId id) {
    const auto [known, added] = known_.try_emplace(id);
    if (added) known->second = write(scene_.cameras[id.index]);
    return known->second;
}

}  // namespace alidade::gltf_export
