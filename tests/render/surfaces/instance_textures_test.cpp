// Two instances of one brush model at different frames of an animation: each shows its own texture, and the
// blocks of both are kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <vector>

#include "render/renderer.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

// The level, with the next texture as the alternate frame of every texture.
std::shared_ptr<const world::Level> with_alternates(const world::Level& original) {
  auto level = std::make_shared<world::Level>(original);
  level->identity = std::make_shared<const world::LevelIdentity>();
  for (std::size_t i = 0; i < level->textures.size(); ++i)
    level->textures[i].alternate_frames = {
        base::to_index<world::TextureIndex>((i + 1) % level->textures.size())};
  return level;
}

// In front of a camera that looks level, `right_units` to its right.
void place_in_view(const world::Level& level, const render::Camera& camera, double right_units,
                   render::BrushModelInstance& io_instance) {
  constexpr double kForwardUnits = 100;
  const double yaw = static_cast<double>(camera.angles_deg.y) * std::numbers::pi / 180;
  const math::Vec3d forward(std::cos(yaw), std::sin(yaw), 0), right(std::sin(yaw), -std::cos(yaw), 0);
  const math::Bounds& bounds = level.models[base::to_size(io_instance.model)].bounds;
  const math::Vec3d place = math::Vec3d(camera.origin_world) + forward * kForwardUnits + right * right_units;
  io_instance.origin_world = math::Vec3(place) - (bounds.mins + bounds.maxs) * 0.5f;
}

std::set<std::uint32_t> seen_instances(const render::Renderer& renderer, std::size_t pixels) {
  std::vector<render::PixelFace> faces(pixels);
  std::vector<std::uint8_t> writes(pixels);
  renderer.pixel_faces(faces, writes);
  std::set<std::uint32_t> instances;
  for (const render::PixelFace& face : faces) instances.insert(face.instance);
  return instances;
}

TEST(InstanceTextures, OfOneModelAreBuiltOnce) {
  const DrawableLevel drawable = small_level();
  const std::shared_ptr<const world::Level> level = with_alternates(*drawable.level);
  const std::vector<render::BrushModelInstance> shown = shown_brush_models(*level);
  ASSERT_FALSE(shown.empty());
  render::FrameBuffer frame(160, 100, render::PixelFormat::kRgb),
      uncached_frame(160, 100, render::PixelFormat::kRgb);
  render::Renderer renderer(drawable.palette, drawable.colormap),
      uncached(drawable.palette, drawable.colormap);
  int views_of_both = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    Viewpoint viewpoint{.camera = random_camera(*level, random),
                        .brush_models = {shown.front(), shown.front()}};
    viewpoint.camera.angles_deg = {0, viewpoint.camera.angles_deg.y, 0};
    place_in_view(*level, viewpoint.camera, -40, viewpoint.brush_models[0]);
    place_in_view(*level, viewpoint.camera, 40, viewpoint.brush_models[1]);
    viewpoint.brush_models[1].frame = 1;
    renderer.render(viewpoint.scene(*level), {}, frame);
    EXPECT_EQ(renderer.render(viewpoint.scene(*level), {}, frame).surfaces_built, 0u) << "seed " << seed;
    uncached.render(viewpoint.scene(*level), {.surface_cache = false}, uncached_frame);
    EXPECT_TRUE(std::ranges::equal(frame.rgb(), uncached_frame.rgb())) << "seed " << seed;
    const std::set<std::uint32_t> seen = seen_instances(renderer, frame.pixel_count());
    views_of_both += seen.contains(1) && seen.contains(2);
  }
  EXPECT_GT(views_of_both, 0);
}

}  // namespace
}  // namespace temblor::test
