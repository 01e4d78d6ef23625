// Random scenes for pictures of one part of the renderer.
#pragma once

#include "math/angles.h"
#include "render/scene.h"
#include "support/pictures/viewpoints.h"

namespace temblor::render_gl {

// A scene, and the objects that it refers to. Can be moved, but not copied.
struct SceneView {
  SceneView(const world::Level& level, const render::Camera& camera);
  SceneView(SceneView&&) = default;

  test::Viewpoint viewpoint;
  render::Scene scene;
};

SceneView any_view(const world::Level& level, test::Random& io_random);

// Looks at a face of the sky. CHECKs that the level has one.
SceneView any_sky_view(const world::Level& level, test::Random& io_random);

// The camera's axes.
math::Basis view_axes(const render::Scene& scene);
// A point in front of the camera, up to `aside` times as far to the sides.
math::Vec3 point_in_view(const render::Scene& scene, double distance, double aside, test::Random& io_random);

}  // namespace temblor::render_gl
