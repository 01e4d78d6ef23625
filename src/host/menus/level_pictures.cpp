#include "host/menus/level_pictures.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <vector>

#include "host/menus/make_thumbnail.h"
#include "render/renderer.h"

namespace temblor::host {
namespace {

constexpr int kFrameWidth = 4 * kThumbnailWidth, kFrameHeight = 4 * kThumbnailHeight;
constexpr int kMaxRoomGain = 2, kMaxOverviewGain = 8;

int brightness(std::uint32_t rgb) {
  return static_cast<int>((rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255)) / 3;
}

// Brightens a dark picture like a camera's exposure: nine tenths of the visible pixels get no brighter than
// kTarget, if that takes no more than `max_gain`. Black pixels, outside the level, are not counted, and a
// bright picture is never darkened.
void expose(std::span<std::uint32_t> io_rgb, int max_gain) {
  constexpr int kTarget = 150, kMaxBlack = 2;
  std::vector<int> visible;
  for (const std::uint32_t pixel : io_rgb)
    if (brightness(pixel) > kMaxBlack) visible.push_back(brightness(pixel));
  if (visible.empty()) return;
  const auto ninth_decile = visible.begin() + static_cast<std::ptrdiff_t>(visible.size() * 9 / 10);
  std::nth_element(visible.begin(), ninth_decile, visible.end());
  const float gain = std::clamp(static_cast<float>(kTarget) / static_cast<float>(*ninth_decile), 1.0f,
                                static_cast<float>(max_gain));
  for (std::uint32_t& pixel : io_rgb) {
    std::uint32_t brighter = 0;
    for (const int shift : {16, 8, 0})
      brighter |=
          static_cast<std::uint32_t>(std::min(255.0f, static_cast<float>(pixel >> shift & 255) * gain))
          << shift;
    pixel = brighter;
  }
}

// Draws a scene of the level, and brightens it.
render::FrameBuffer draw_frame(const render::Scene& scene, render::Renderer& io_renderer, int max_gain) {
  render::FrameBuffer frame(kFrameWidth, kFrameHeight, render::PixelFormat::kRgb);
  io_renderer.render(scene, {}, frame);
  expose(frame.rgb(), max_gain);
  return frame;
}

// The whole level from above. Ceilings do not hide the rooms: the camera sees their back sides, which are
// culled. The sky stays black.
render::FrameBuffer draw_overview(const world::Level& level, render::Renderer& io_renderer) {
  const math::Bounds& bounds = level.world().bounds;
  const math::Vec3 size = bounds.maxs - bounds.mins;
  render::Scene scene;
  scene.level = &level;
  scene.camera.origin_world = (bounds.mins + bounds.maxs) * 0.5f + math::Vec3(0, 0, glm::length(size));
  scene.camera.angles_deg = {90, 0, 0};
  scene.camera.projection = render::Projection::kOrthographic;
  const render::Skybox empty;
  scene.skybox = &empty;
  return draw_frame(scene, io_renderer, kMaxOverviewGain);
}

// Looks from the first entity of the first class that the level has.
render::Camera find_room_camera(const world::Level& level) {
  constexpr float kEyeHeight = 22;
  render::Camera camera;
  for (const std::string_view wanted : {"info_intermission", "info_player_start", "info_player_deathmatch"})
    for (const formats::Entity& entity : level.entities) {
      if (entity.classname() != wanted) continue;
      camera.origin_world = entity.find_vec3("origin").value_or(math::Vec3(0.0f));
      camera.angles_deg.y = entity.find_number("angle").value_or(0.0f);
      if (wanted == "info_intermission")
        camera.angles_deg = entity.find_vec3("mangle").value_or(camera.angles_deg);
      else
        camera.origin_world.z += kEyeHeight;
      return camera;
    }
  return camera;
}

// Doors, walls and other brush models where the level places them; not those of triggers, which nobody sees.
std::vector<render::BrushModelInstance> list_brush_models(const world::Level& level) {
  std::vector<render::BrushModelInstance> models;
  for (const formats::Entity& entity : level.entities) {
    const std::string_view model = entity.find("model").value_or("");
    if (!model.starts_with('*') || entity.classname().starts_with("trigger_")) continue;
    std::size_t number = 0;
    std::from_chars(model.data() + 1, model.data() + model.size(), number);
    if (number == 0 || number >= level.models.size()) continue;
    models.push_back({.model = base::to_index<world::ModelIndex>(number),
                      .origin_world = entity.find_vec3("origin").value_or(math::Vec3(0.0f))});
  }
  return models;
}

render::FrameBuffer draw_room(const world::Level& level, render::Renderer& io_renderer) {
  const std::vector<render::BrushModelInstance> models = list_brush_models(level);
  render::Scene scene;
  scene.level = &level;
  scene.camera = find_room_camera(level);
  scene.brush_models = models;
  return draw_frame(scene, io_renderer, kMaxRoomGain);
}

}  // namespace

std::optional<LevelPictures> draw_level_pictures(const GameData& data, const std::string& name,
                                                 const formats::NearestColor& colors) {
  constexpr int kRoomFactor = 2;
  const base::Result<assets::LoadedLevel> loaded = assets::load_level(data.library.files(), name);
  if (!loaded.ok()) return std::nullopt;
  render::Renderer renderer(data.look.palette, data.look.colormap);
  const render::FrameBuffer room = draw_room(*loaded->level, renderer),
                            overview = draw_overview(*loaded->level, renderer);
  return LevelPictures{make_thumbnail(room.rgb(), kFrameWidth, kFrameHeight, colors, kRoomFactor),
                       make_thumbnail(overview.rgb(), kFrameWidth, kFrameHeight, colors)};
}

}  // namespace temblor::host
