// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bounds.h"
#include "core/ray.h"
#include "core/transform.h"
#include "scene/camera.h"

namespace alidade {

/// `camera` as its node's transform places it.
Camera placed(const Camera& camera, const Transform& to_world);

/// A camera that sees all of `bounds`, from the front, the right and above, for files that bring none. A unit box if `bounds` is empty.
Camera framing_camera(const Bounds& bounds);

/// `camera` with `right` and `up` as the shape of a picture of this size makes them (Camera::fit).
Camera fitted(Camera camera, int width, int height);

/// Rays of one camera for pictures of one size.
class CameraRays {
  public:
    CameraRays(const Camera& camera, int width, int height);
    /// Through the picture point (x, y) in pixels, from the top left corner; the centre of the first pixel is (0.5, 0.5). The direction is a unit vector.
    /// With a lens, `lens` in [0, 1)^2 chooses the point of it that the ray leaves; all rays of a picture point meet in the plane of focus.
    Ray at(double x, double y, const Vec2& lens = Vec2(0.5)) const;
    /// Where the camera's normal bends that ray: a point of the plane z = 0.
    Vec2 bent_at(double x, double y) const;
    bool has_lens() const { return camera_.aperture > 0 && camera_.projection == Projection::perspective; }

  private:
    Ray plane_ray(double x, double y, const Vec2& lens) const;

    Camera camera_;   // right and up as the picture's size makes them
    double width_, height_;
    Vec3 unit_right_, unit_up_;   // of the picture's plane
    double in_focus_ = 1;         // how many times its direction from the middle of the lens a ray goes to the plane of focus, which is parallel to that
};

}  // namespace alidade
