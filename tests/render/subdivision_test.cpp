#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render/renderer.h"
#include "support/drawable_level.h"
#include "support/drawable_models.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"

namespace temblor::test {
namespace {

// Spheres of many sizes, drawn both ways.
struct Difference {
  double covered = 0;    // pixels that affine covers
  double uncovered = 0;  // that one of them covers and the other does not
  double colour = 0;     // mean difference of a channel (0 to 255) where both cover
};

Difference difference_at(const DrawableLevel& drawable, const render::AliasModel& model, float size_units,
                         double side_px_over_distance, double side_px) {
  Difference difference;
  double colours = 0;
  render::Renderer renderer(drawable.palette, drawable.colormap);
  for (int seed = 0; seed < effort(40, 4); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    render::Scene scene;
    scene.level = drawable.level.get();
    scene.camera.origin_world = {0, 0, 100000};
    render::AliasInstance instance;
    instance.model = &model;
    const double distance = side_px_over_distance / side_px;
    instance.origin_world = scene.camera.origin_world + math::Vec3(static_cast<float>(distance), 0, 0) +
                            random.in_cube(size_units / 8);
    instance.angles_deg = random.in_cube(180);
    instance.least_light = 100;
    scene.alias_models = {&instance, 1};
    render::FrameBuffer affine(640, 480, render::PixelFormat::kRgb),
        split(640, 480, render::PixelFormat::kRgb);
    renderer.render(scene, {.alias_raster = render::AliasRaster::kAffine}, affine);
    renderer.render(scene, {.alias_raster = render::AliasRaster::kSubdivision}, split);
    for (std::size_t i = 0; i < affine.pixel_count(); ++i) {
      const bool a = affine.depth()[i] > 0, b = split.depth()[i] > 0;
      difference.covered += a;
      difference.uncovered += a != b;
      if (!a || !b) continue;
      for (int shift = 0; shift < 24; shift += 8)
        colours += std::abs(static_cast<int>(affine.rgb()[i] >> shift & 255) -
                            static_cast<int>(split.rgb()[i] >> shift & 255));
      difference.colour += 3;
    }
  }
  difference.colour = colours / std::max(1.0, difference.colour);
  difference.uncovered /= std::max(1.0, difference.covered);
  return difference;
}

TEST(Subdivision, DiffersFromAffineBySize) {
  const DrawableLevel drawable = small_level({.tiny = true});
  constexpr float kSize = 64;
  const auto model = small_model(sphere_mdl(), kSize);
  for (const double side_px : {0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0}) {
    const double mean_side = 9;
    const Difference d = difference_at(drawable, *model, kSize, mean_side * 320, side_px);
    std::printf("side %4.1f px: coverage %.4f colour %.2f (%.0f px)\n", side_px, d.uncovered, d.colour,
                d.covered);
  }
}

}  // namespace
}  // namespace temblor::test
