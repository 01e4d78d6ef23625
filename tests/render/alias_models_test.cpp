// Alias models in whole pictures: where they are, in front of what, and what the picture does not depend on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "render/alias_reference.h"
#include "render/renderer.h"
#include "render/view/view_frame.h"
#include "support/drawable_level.h"
#include "support/drawable_models.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/game_data.h"
#include "support/random.h"
#include "support/viewpoints.h"

namespace temblor::test {
namespace {

constexpr int kWidth = 160, kHeight = 100;
// Corners of triangles are rounded to 1/256 pixel: what is that near to an edge may show either side of it.
constexpr double kEdgeSlackPx = 1.0 / 64;

render::FrameBuffer drawn(const DrawableLevel& drawable, const render::Scene& scene,
                          const render::Settings& settings, render::PixelFormat format) {
  render::Renderer renderer(drawable.palette, drawable.colormap);
  render::FrameBuffer frame(kWidth, kHeight, format);
  renderer.render(scene, settings, frame);
  return frame;
}

// One model in an empty place far from the level: its depth must be that of the rays that hit it, at every
// pixel that is not at an edge.
class ModelAgainstRays {
 public:
  explicit ModelAgainstRays(formats::Mdl mdl)
      : mdl_(std::move(mdl)), model_(render::make_alias_model(mdl_, "test")) {
    scene_.level = drawable_.level.get();
    // Nothing of the level is in sight from there.
    scene_.camera.origin_world = {0, 0, 5000};
    scene_.camera.angles_deg = {-80, 0, 0};
  }

  void expect_right(const render::AliasInstance& placed, const render::Camera& camera,
                    const render::Settings& settings) {
    render::AliasInstance instance = placed;
    instance.model = model_.get();
    scene_.camera = camera;
    scene_.alias_models = {&instance, 1};
    const render::FrameBuffer frame = drawn(drawable_, scene_, settings, render::PixelFormat::kIndexed);
    const ReferencePicture picture = reference_picture(camera, kWidth, kHeight);
    const ReferenceMesh mesh = reference_mesh(mdl_, 0, instance, picture);
    int wrong = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        wrong += !is_right(mesh, picture, x, y, frame.depth()[static_cast<std::size_t>(y * kWidth + x)]);
    EXPECT_EQ(wrong, 0) << "pixels whose depth is not among those of the rays around them";
  }

  // Pixels that rays hit, to see that a test draws anything at all.
  std::size_t hits() const { return hits_; }

 private:
  bool is_right(const ReferenceMesh& mesh, const ReferencePicture& picture, int x, int y, float depth) {
    constexpr double kOffsets[][2] = {{0, 0},  {-1, -1}, {1, -1}, {-1, 1}, {1, 1},
                                      {-1, 0}, {1, 0},   {0, -1}, {0, 1}};
    constexpr double kDepthError = 1e-5;
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const auto& offset : kOffsets) {
      const ReferenceHit hit = reference_hit(mesh, picture, x + offset[0] * kEdgeSlackPx,
                                             y + offset[1] * kEdgeSlackPx, render::kNearPlane);
      hits_ += hit.hit && offset[0] == 0 && offset[1] == 0;
      if (!hit.hit && depth < 0) return true;
      if (!hit.hit) continue;
      least = std::min(least, hit.depth * (1 - kDepthError));
      most = std::max(most, hit.depth * (1 + kDepthError));
    }
    // Rounding a corner also tilts a triangle that is nearly edge-on.
    const double tilt = (most - least) / 2;
    return depth >= least - tilt && depth <= most + tilt;
  }

  const DrawableLevel drawable_ = small_level({.pvs = false});
  formats::Mdl mdl_;
  std::shared_ptr<const render::AliasModel> model_;
  render::Scene scene_;
  std::size_t hits_ = 0;
};

render::AliasInstance random_instance(const render::Camera& camera, double distance, Random& random) {
  render::AliasInstance instance;
  const math::Basis axes = math::basis_from_angles(camera.angles_deg);
  const double spread = distance * 0.5;
  instance.origin_world = camera.origin_world + math::Vec3(axes.forward * distance) + random.in_cube(spread);
  instance.angles_deg = random.in_cube(180);
  return instance;
}

render::Camera faraway_camera(Random& random, float fov_deg) {
  render::Camera camera;
  camera.origin_world = math::Vec3(0, 0, 20000) + random.in_cube(100);
  camera.angles_deg = {-60, static_cast<float>(random.uniform(-180, 180)),
                       static_cast<float>(random.uniform(-30, 30))};
  camera.fov_deg = fov_deg;
  return camera;
}

TEST(AliasModels, LieWhereRaysHitThem) {
  ModelAgainstRays box(box_mdl()), sphere(sphere_mdl());
  for (int seed = 0; seed < effort(20, 4); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const render::Camera camera = faraway_camera(random, static_cast<float>(random.uniform(10, 150)));
    const render::AliasInstance instance = random_instance(camera, 600, random);
    for (const bool vectors : {false, true}) {
      box.expect_right(instance, camera, {.vector_kernels = vectors});
      sphere.expect_right(instance, camera, {.vector_kernels = vectors});
    }
  }
  EXPECT_GT(box.hits(), 1000u);
  EXPECT_GT(sphere.hits(), 1000u);
}

TEST(AliasModels, AreCutAtTheNearPlane) {
  ModelAgainstRays box(box_mdl()), sphere(sphere_mdl());
  for (int seed = 0; seed < effort(40, 6); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const render::Camera camera = faraway_camera(random, static_cast<float>(random.uniform(60, 170)));
    render::AliasInstance instance = random_instance(camera, random.uniform(60, 220), random);
    instance.scale = static_cast<float>(random.log_uniform(0.5, 2));
    box.expect_right(instance, camera, {});
    sphere.expect_right(instance, camera, {});
  }
  EXPECT_GT(box.hits() + sphere.hits(), 1000u);
}

TEST(AliasModels, OfAnySizeAreDrawnOrLeftOut) {
  const DrawableLevel drawable = small_level();
  const auto model = small_model(sphere_mdl());
  render::Scene scene;
  scene.level = drawable.level.get();
  for (int seed = 0; seed < effort(300, 30); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    scene.camera = random_camera(*drawable.level, random);
    render::AliasInstance instance = random_instance(scene.camera, random.log_uniform(1e-3, 1e5), random);
    instance.model = model.get();
    instance.scale = static_cast<float>(random.log_uniform(1e-12, 1e12));
    const float wrong[] = {std::nanf(""), HUGE_VALF, -HUGE_VALF, 3e38f};
    if (seed % 5 == 0) instance.origin_world[seed / 5 % 3] = wrong[random.below(4)];
    if (seed % 7 == 0) instance.scale = wrong[random.below(4)];
    if (seed % 11 == 0) instance.angles_deg[seed / 11 % 3] = wrong[random.below(3)];
    if (seed % 13 == 0) instance.blend = wrong[random.below(4)];
    scene.alias_models = {&instance, 1};
    for (const bool vectors : {false, true}) {
      const render::FrameBuffer frame =
          drawn(drawable, scene, {.vector_kernels = vectors}, render::PixelFormat::kRgb);
      for (const float depth : frame.depth()) ASSERT_FALSE(std::isnan(depth)) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace temblor::test
