#include "render_gl/scene_views.h"

#include <cmath>
#include <numbers>

#include "base/check.h"
#include "world/visibility.h"

namespace temblor::render_gl {

namespace {

math::Vec3 find_middle(const world::Level& level, const world::Face& face) {
  math::Vec3 sum(0.0f);
  for (std::size_t i = 0; i < face.surfedge_count; ++i)
    sum += level.vertices[level.surfedge_start(face.first_surfedge + i)];
  return sum / static_cast<float>(face.surfedge_count);
}

math::Vec3 angles_towards(const math::Vec3& direction) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const math::Vec3d d(direction);
  return math::Vec3(
      math::Vec3d(-std::atan2(d.z, std::hypot(d.x, d.y)) * kDegrees, std::atan2(d.y, d.x) * kDegrees, 0));
}

}  // namespace

SceneView::SceneView(const world::Level& level, const render::Camera& camera)
    : viewpoint{.camera = camera, .brush_models = test::shown_brush_models(level)},
      scene(viewpoint.scene(level)) {
  scene.marks = nullptr;  // the viewpoint may move
}

SceneView any_view(const world::Level& level, test::Random& io_random) {
  return SceneView(level, test::random_camera(level, io_random));
}

SceneView any_sky_view(const world::Level& level, test::Random& io_random) {
  constexpr int kAttempts = 100000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const world::Face& face = level.faces[io_random.below(level.faces.size())];
    if (face.kind != world::FaceKind::kSky) continue;
    const math::Vec3 middle = find_middle(level, face);
    const math::Vec3 eye = middle + io_random.in_cube(250);
    const world::Contents contents = level.leaf(world::find_leaf(level, eye)).contents;
    if (contents == world::Contents::kSolid || contents == world::Contents::kSky) continue;
    SceneView view(level, {.origin_world = eye, .angles_deg = angles_towards(middle - eye)});
    view.scene.camera.angles_deg.z = static_cast<float>(io_random.uniform(-30, 30));
    return view;
  }
  CHECK(false, "level {} has no sky", level.name);
}

math::Basis view_axes(const render::Scene& scene) {
  return math::basis_from_angles(scene.camera.angles_deg);
}

math::Vec3 point_in_view(const render::Scene& scene, double distance, double aside, test::Random& io_random) {
  const math::Basis axes = view_axes(scene);
  const math::Vec3d forward(axes.forward), right(axes.right), up(axes.up);
  return math::Vec3(math::Vec3d(scene.camera.origin_world) + forward * distance +
                    right * (distance * io_random.uniform(-aside, aside)) +
                    up * (distance * io_random.uniform(-aside, aside)));
}

}  // namespace temblor::render_gl
