// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/cameras.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace alidade::gltf {

namespace {

/// Radians; 179.8 degrees.
constexpr double kMaxFieldOfView = kPi * 0.999;

void convert_perspective(const tinygltf::PerspectiveCamera& from, const std::string& at, Camera& camera, Reporter& report) {
    const double yfov = std::min(from.yfov, kMaxFieldOfView);
    if (yfov < from.yfov) report.warning(child(at, "perspective"), fmt::format("a yfov of {} is not less than pi: {} is used", from.yfov, yfov));
    const double height = 2 * std::tan(yfov / 2), aspect = from.aspectRatio > 0 ? from.aspectRatio : 1;
    camera.right = Vec3(aspect * height, 0, 0);
    camera.up = Vec3(0, height, 0);
    camera.fit = from.aspectRatio > 0 ? Fit::show_all : Fit::height;
}

void convert_orthographic(const tinygltf::OrthographicCamera& from, const std::string& at, Camera& camera, Reporter& report) {
    if (from.xmag == 0 || from.ymag == 0) return report.error(child(at, "orthographic"), "xmag and ymag must not be 0");
    camera.projection = Projection::orthographic;
    camera.right = Vec3(2 * from.xmag, 0, 0);
    camera.up = Vec3(0, 2 * from.ymag, 0);
    camera.fit = Fit::show_all;
}

}  // namespace

void convert_cameras(const Model& model, Scene& scene, Reporter& report) {
    for (size_t i = 0; i < model.cameras.size(); ++i) {
        const tinygltf::Camera& from = model.cameras[i];
        const std::string at = child("/cameras", i);
        Camera camera;
        camera.name = from.name;
        camera.from = report.at(at);
        if (from.type == "orthographic") convert_orthographic(from.orthographic, at, camera, report);
        else convert_perspective(from.perspective, at, camera, report);
        scene.cameras.push_back(std::move(camera));
    }
}

}  // namespace alidade::gltf
