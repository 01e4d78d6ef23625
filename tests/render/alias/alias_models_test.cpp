// Alias models in whole pictures: where they are, what they hide, and what the picture does not depend on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "render/alias/alias_reference.h"
#include "render/renderer.h"
#include "render/view/view_frame.h"
#include "support/allocation_counter.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/models/drawable_models.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"

namespace temblor::test {
namespace {

constexpr int kViewWidth = 160, kViewHeight = 100;
// Corners are rounded to 1/256 pixel: a pixel that near to an edge may show either side of it.
constexpr double kEdgeSlackPx = 1.0 / 64;

render::FrameBuffer drawn(render::Renderer& io_renderer, const render::Scene& scene,
                          const render::Settings& settings, render::PixelFormat format) {
  render::FrameBuffer frame(kViewWidth, kViewHeight, format);
  io_renderer.render(scene, settings, frame);
  return frame;
}

// One model in an empty place far from the level: its depth must be that of the rays that hit it, at every
// pixel that is not at an edge.
class ModelAgainstRays {
 public:
  explicit ModelAgainstRays(formats::Mdl mdl)
      : mdl_(std::move(mdl)), model_(render::make_alias_model(mdl_, "test")) {
    scene_.level = drawable_.level.get();
    // The level is not visible from there.
    scene_.camera.origin_world = {0, 0, 5000};
    scene_.camera.angles_deg = {-80, 0, 0};
  }

  void expect_right(const render::AliasInstance& placed, const render::Camera& camera,
                    const render::Settings& settings) {
    render::AliasInstance instance = placed;
    instance.model = model_.get();
    scene_.camera = camera;
    scene_.alias_models = {&instance, 1};
    const render::FrameBuffer frame = drawn(renderer_, scene_, settings, render::PixelFormat::kIndexed);
    const ReferencePicture picture = reference_picture(camera, kViewWidth, kViewHeight);
    const ReferenceMesh mesh = reference_mesh(mdl_, 0, instance, picture);
    int wrong = 0;
    for (int y = 0; y < kViewHeight; ++y)
      for (int x = 0; x < kViewWidth; ++x)
        wrong += !is_right(mesh, picture, x, y, frame.depth()[static_cast<std::size_t>(y * kViewWidth + x)]);
    EXPECT_EQ(wrong, 0) << "pixels whose depth is not among those of the rays around them";
  }

  // Counts pixels that rays hit, so that a test cannot pass by drawing nothing.
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
      // Rounding a corner also tilts a triangle that is nearly edge-on. More rays only widen the range.
      const double tilt = (most - least) / 2;
      if (depth >= least - tilt && depth <= most + tilt) return true;
    }
    return false;
  }

  const DrawableLevel drawable_ = small_level({.pvs = false});
  render::Renderer renderer_{drawable_.palette, drawable_.colormap};
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
  for (int seed = 0; seed < effort(8, 2); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const render::Camera camera = faraway_camera(random, static_cast<float>(random.uniform(10, 150)));
    const render::AliasInstance instance = random_instance(camera, 600, random);
    for (const bool vectors : {false, true}) {
      box.expect_right(instance, camera, {.simd_kernels = vectors});
      sphere.expect_right(instance, camera, {.simd_kernels = vectors});
    }
  }
  EXPECT_GT(box.hits(), 1000u);
  EXPECT_GT(sphere.hits(), 1000u);
}

TEST(AliasModels, AreCutAtTheNearPlane) {
  ModelAgainstRays box(box_mdl()), sphere(sphere_mdl());
  for (int seed = 0; seed < effort(12, 2); ++seed) {
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
  render::Renderer renderer(drawable.palette, drawable.colormap);
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
          drawn(renderer, scene, {.simd_kernels = vectors}, render::PixelFormat::kRgb);
      for (const float depth : frame.depth()) ASSERT_FALSE(std::isnan(depth)) << "seed " << seed;
    }
  }
}

// Models all over the level, and a view model.
struct PopulatedScene {
  std::vector<std::shared_ptr<const render::AliasModel>> models;
  std::vector<render::AliasInstance> instances;
  render::AliasInstance weapon;
  Viewpoint viewpoint;
  std::vector<render::DynamicLight> lights;

  render::Scene scene(const world::Level& level) const {
    render::Scene scene = viewpoint.scene(level);
    scene.alias_models = instances;
    scene.view_weapon = &weapon;
    scene.lights = lights;
    return scene;
  }
};

render::AliasInstance random_look(const PopulatedScene& populated, Random& random) {
  render::AliasInstance instance;
  instance.model = populated.models[random.below(populated.models.size())].get();
  const bool has_poses = render::frame_count(*instance.model) > 1;
  const auto pose = [&] {
    return render::pose_at(*instance.model, has_poses ? static_cast<std::uint32_t>(random.below(9)) : 0,
                           0.35);
  };
  instance.from_pose = pose();
  instance.to_pose = pose();
  instance.blend = static_cast<float>(random.uniform(0, 1));
  instance.scale = static_cast<float>(random.log_uniform(0.2, 3));
  instance.angles_deg = random.in_cube(180);
  if (random.chance(0.3))
    instance.colors = {static_cast<std::uint8_t>(random.below(16)),
                       static_cast<std::uint8_t>(random.below(16))};
  instance.full_bright = random.chance(0.1);
  instance.min_light = static_cast<float>(random.below(100));
  return instance;
}

PopulatedScene populate(const world::Level& level, std::uint64_t seed) {
  Random random(seed);
  PopulatedScene populated;
  populated.models = {small_model(box_mdl(), 40), small_model(sphere_mdl(), 60),
                      small_model(many_pose_mdl(), 50)};
  populated.viewpoint.camera = random_camera(level, random);
  if (seed % 6 == 5) populated.viewpoint.camera.projection = render::Projection::kOrthographic;
  for (int i = 0; i < 60; ++i) {
    render::AliasInstance instance = random_look(populated, random);
    const double distance = random.log_uniform(1, 1500);
    const math::Basis axes = math::basis_from_angles(populated.viewpoint.camera.angles_deg);
    instance.origin_world = populated.viewpoint.camera.origin_world + math::Vec3(axes.forward * distance) +
                            random.in_cube(distance * 0.7);
    populated.instances.push_back(instance);
  }
  populated.weapon = random_look(populated, random);
  populated.weapon.origin_world = populated.viewpoint.camera.origin_world;
  populated.lights = {{populated.viewpoint.camera.origin_world, 300, 0, {1, 0.5f, 0.25f}}};
  return populated;
}

constexpr auto kModelFormats = {render::PixelFormat::kIndexed, render::PixelFormat::kRgb};

TEST(AliasModels, AreTheSameForAnyThreadsBandsAndKernels) {
  const DrawableLevel drawable = small_level({.colored_light = true});
  render::Renderer renderer(drawable.palette, drawable.colormap);
  for (int seed = 0; seed < effort(8, 2); ++seed) {
    const PopulatedScene populated = populate(*drawable.level, static_cast<std::uint64_t>(seed));
    const render::Scene scene = populated.scene(*drawable.level);
    for (const render::PixelFormat format : kModelFormats)
      for (const auto raster :
           {render::AliasRaster::kAuto, render::AliasRaster::kAffine, render::AliasRaster::kSubdivision}) {
        render::Settings settings;
        settings.alias_raster = raster;
        settings.alias_snap = seed % 4 == 3;
        const FrameCopy expected = copy_picture(drawn(renderer, scene, settings, format));
        for (const int threads : {1, 2, 8})
          for (const int band_rows : {0, 1, 7})
            for (const bool vectors : {false, true}) {
              settings.threads = threads;
              settings.job_backend = base::JobBackend::kStdThread;
              settings.band_rows = band_rows;
              settings.simd_kernels = vectors;
              const FrameCopy other = copy_picture(drawn(renderer, scene, settings, format));
              ASSERT_TRUE(expected == other)
                  << differing_pixels(expected, other) << " pixels differ: seed " << seed << ", " << threads
                  << " threads, bands of " << band_rows << ", vectors " << vectors << ", raster "
                  << static_cast<int>(raster);
            }
      }
  }
}

// In front of the camera, and at least `reach` beyond the level's bounds.
math::Vec3 place_outside(const math::Bounds& level, const render::Camera& camera, float reach,
                         Random& random) {
  const math::Basis axes = math::basis_from_angles(camera.angles_deg);
  while (true) {
    const double distance = random.log_uniform(200, 4000);
    const math::Vec3 place =
        camera.origin_world + math::Vec3(axes.forward * distance) + random.in_cube(0.5 * distance);
    for (int axis = 0; axis < 3; ++axis)
      if (place[axis] - reach > level.maxs[axis] || place[axis] + reach < level.mins[axis]) return place;
  }
}

// The number of models that are visible when each is alone with the camera, far above the level.
int count_shown_without_walls(render::Renderer& io_renderer, render::Scene scene) {
  const math::Vec3 far_above(0, 0, 20000);
  scene.camera.origin_world += far_above;
  const std::span<const render::AliasInstance> instances = scene.alias_models;
  scene.alias_models = {};
  const FrameCopy without = copy_picture(drawn(io_renderer, scene, {}, render::PixelFormat::kRgb));
  int shown = 0;
  for (render::AliasInstance instance : instances) {
    instance.origin_world += far_above;
    scene.alias_models = {&instance, 1};
    const FrameCopy with = copy_picture(drawn(io_renderer, scene, {}, render::PixelFormat::kRgb));
    shown += differing_pixels(with, without) > 0;
  }
  return shown;
}

TEST(AliasModels, BehindAWallNeverShow) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  const math::Bounds& level_bounds = drawable.level->world().bounds;
  PopulatedScene populated = populate(*drawable.level, 1);
  int placements = 0, shown_without_walls = 0;
  for (int seed = 0; seed < effort(50, 5); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    populated.viewpoint.camera = random_camera(*drawable.level, random);
    populated.instances.clear();
    // The level is closed: beyond its bounds, all that can be seen is walls.
    while (populated.instances.size() < 20) {
      render::AliasInstance instance = random_look(populated, random);
      const float reach = 64 * std::sqrt(3.0f) * instance.scale + 1;
      instance.origin_world = place_outside(level_bounds, populated.viewpoint.camera, reach, random);
      populated.instances.push_back(instance);
      ++placements;
    }
    render::Scene scene = populated.scene(*drawable.level);
    scene.view_weapon = nullptr;
    for (const auto raster : {render::AliasRaster::kAffine, render::AliasRaster::kSubdivision}) {
      const FrameCopy with =
          copy_picture(drawn(renderer, scene, {.alias_raster = raster}, render::PixelFormat::kRgb));
      scene.alias_models = {};
      const FrameCopy without = copy_picture(drawn(renderer, scene, {}, render::PixelFormat::kRgb));
      scene.alias_models = populated.instances;
      ASSERT_EQ(differing_pixels(with, without), 0u) << "seed " << seed;
    }
    shown_without_walls += count_shown_without_walls(renderer, scene);
  }
  EXPECT_GE(placements, effort(1000, 100));
  EXPECT_GE(shown_without_walls, placements / 2) << "the walls hide little";
}

// The same pixels of the weapon for every position and field of view of the camera.
TEST(AliasModels, ViewWeaponLooksTheSameInEveryFieldOfViewAndBeforeEveryWall) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  const auto model = small_model(sphere_mdl(), 20);
  std::vector<bool> expected;
  for (int seed = 0; seed < effort(40, 8); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    render::Scene scene;
    scene.level = drawable.level.get();
    scene.camera = random_camera(*drawable.level, random);
    scene.camera.fov_deg = static_cast<float>(random.uniform(10, 170));
    scene.camera.projection = render::Projection::kPerspective;
    // Upright and level, so that positions are rounded in the same way.
    scene.camera.angles_deg = {0, 0, 0};
    render::AliasInstance weapon;
    weapon.model = model.get();
    weapon.origin_world = scene.camera.origin_world + math::Vec3(30, 0, -12);
    weapon.full_bright = true;
    scene.view_weapon = &weapon;
    const render::FrameBuffer frame = drawn(renderer, scene, {}, render::PixelFormat::kIndexed);
    std::vector<bool> shown;
    // No part of the level is nearer than 1 / kNearPlane.
    for (const float depth : frame.depth()) shown.push_back(depth > 1 / render::kNearPlane);
    if (expected.empty()) expected = shown;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) differing += shown[i] != expected[i];
    EXPECT_LE(differing, 2u) << "seed " << seed;
    EXPECT_GT(std::count(shown.begin(), shown.end(), true), 500) << "seed " << seed;
  }
}

// With a field of view of its own, the weapon covers the pixels that it would cover as a model of the level
// that is seen with that field of view; with 0, those of the camera's.
TEST(ViewWeapon, HasTheFieldOfViewThatTheSceneAsksFor) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  const auto model = small_model(sphere_mdl(), 8);
  render::AliasInstance weapon;
  weapon.model = model.get();
  weapon.full_bright = true;
  const auto find_covered = [&](float camera_fov_deg, float weapon_fov_deg, bool is_weapon) {
    render::Scene scene;
    scene.level = drawable.level.get();
    scene.camera = {.origin_world = math::Vec3(0, 0, 64), .fov_deg = camera_fov_deg};
    const render::FrameBuffer without = drawn(renderer, scene, {}, render::PixelFormat::kIndexed);
    weapon.origin_world = scene.camera.origin_world + math::Vec3(24, 3, -8);
    scene.weapon_fov_deg = weapon_fov_deg;
    if (is_weapon)
      scene.view_weapon = &weapon;
    else
      scene.alias_models = {&weapon, 1};
    const render::FrameBuffer frame = drawn(renderer, scene, {}, render::PixelFormat::kIndexed);
    std::vector<bool> covered;
    for (std::size_t i = 0; i < frame.pixel_count(); ++i)
      covered.push_back(frame.depth()[i] != without.depth()[i]);
    return covered;
  };
  for (const float fov_deg : {40.0f, 90.0f, 110.0f, 150.0f}) {
    const std::vector<bool> expected = find_covered(fov_deg, 90, false);
    EXPECT_GT(std::ranges::count(expected, true), 20);
    EXPECT_EQ(find_covered(75, fov_deg, true), expected) << fov_deg;
    EXPECT_EQ(find_covered(fov_deg, 0, true), expected) << fov_deg;
  }
}

TEST(AliasModels, OfAWarmFrameAllocateNothing) {
  const DrawableLevel drawable = small_level();
  for (const int threads : {1, 2}) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    render::FrameBuffer frame(kViewWidth, kViewHeight, render::PixelFormat::kIndexed);
    const render::Settings settings{.threads = threads, .job_backend = base::JobBackend::kStdThread};
    const auto draw_all = [&] {
      std::size_t while_drawing = 0;
      for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const PopulatedScene populated = populate(*drawable.level, seed);
        const render::Scene scene = populated.scene(*drawable.level);
        const std::size_t before = allocation_count();
        renderer.render(scene, settings, frame);
        while_drawing += allocation_count() - before;
      }
      return while_drawing;
    };
    EXPECT_GT(draw_all(), 0u);
    draw_all();
    EXPECT_EQ(draw_all(), 0u) << threads << " threads";
  }
}

}  // namespace
}  // namespace temblor::test
