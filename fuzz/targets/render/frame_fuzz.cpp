// Draws every level that can be read from arbitrary bytes: from inside and outside, in perspective and
// orthographic projection.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/check.h"
#include "formats/levels/bsp.h"
#include "fuzz/targets.h"
#include "render/renderer.h"
#include "world/level.h"

namespace {

using namespace temblor;

std::vector<math::Vec3> list_eyes(const world::Level& level) {
  const math::Bounds& bounds = level.world().bounds;
  std::vector<math::Vec3> eyes = {{0, 0, 0}, (bounds.mins + bounds.maxs) / 2.0f, {1e5f, -1e5f, 3}};
  if (!level.vertices.empty()) eyes.push_back(level.vertices.front() + math::Vec3(8, 8, 8));
  return eyes;
}

std::vector<render::BrushModelInstance> all_brush_models(const world::Level& level) {
  std::vector<render::BrushModelInstance> instances;
  for (std::size_t model = 1; model < level.models.size() && model < 8; ++model)
    instances.push_back({base::to_index<world::ModelIndex>(model),
                         math::Vec3(0.0f, 0.0f, static_cast<float>(model)), math::Vec3(0.0f), 1});
  return instances;
}

// Every pixel belongs to one span, and has a depth.
void check_frame(const render::Renderer& renderer, const render::FrameBuffer& frame) {
  std::vector<render::PixelFace> faces(frame.pixel_count());
  std::vector<std::uint8_t> writes(frame.pixel_count());
  renderer.pixel_faces(faces, writes);
  for (const std::uint8_t count : writes) CHECK(count == 1, "{} writes", count);
  for (const float depth : frame.depth()) CHECK(depth == depth, "a depth that is no number");
}

void draw(const world::Level& level) {
  const formats::Palette palette{};
  render::Renderer renderer(palette, formats::Colormap{});
  render::FrameBuffer indexed(41, 31, render::PixelFormat::kIndexed), rgb(41, 31, render::PixelFormat::kRgb);
  const std::vector<render::BrushModelInstance> instances = all_brush_models(level);
  render::Scene scene;
  scene.level = &level;
  scene.brush_models = instances;
  scene.time_s = 12.3;
  bool in_parallel = false;
  for (const math::Vec3& eye : list_eyes(level)) {
    scene.camera.origin_world = eye;
    scene.camera.angles_deg = {10, 100, 0};
    scene.camera.projection =
        in_parallel ? render::Projection::kOrthographic : render::Projection::kPerspective;
    in_parallel = !in_parallel;
    render::Settings settings;
    settings.cache_bytes = std::size_t{1} << 20;
    renderer.render(scene, settings, indexed);
    check_frame(renderer, indexed);
    settings.mip_rule = render::MipRule::kStock;
    renderer.render(scene, settings, rgb);
    check_frame(renderer, rgb);
  }
}

}  // namespace

int temblor::fuzz::fuzz_frame(const std::uint8_t* data, std::size_t size) {
  auto bsp = temblor::formats::read_bsp(std::as_bytes(std::span(data, size)));
  if (!bsp.ok()) return 0;
  const auto level = temblor::world::make_level(std::move(bsp).value(), "fuzzed");
  if (level.ok()) draw(**level);
  return 0;
}
