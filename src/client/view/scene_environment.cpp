#include "client/view/scene_environment.h"

#include <algorithm>

namespace temblor::client {

void SceneEnvironment::apply(const Moment& moment, const EnvironmentSettings& settings,
                             std::vector<std::string>& io_notes, render::Scene& io_scene) {
  io_scene.liquid_alpha = level_.liquid_alpha(settings.liquid_alpha);
  const net::Fog fog = compute_fog(moment.game, {level_.fog.density, level_.fog.color, 0}, moment.time_s);
  fog_ = {fog.density, fog.color};
  if (settings.fog) io_scene.fog = fog_;
  const std::string& skybox = skybox_name(moment.game);
  if (!settings.skybox || skybox.empty()) {
    io_scene.skybox = nullptr;
    return;
  }
  if (skybox != skybox_name_) {
    skybox_name_ = skybox;
    skybox_ = {};
    skybox_.sides = moment.library.skybox(skybox, io_notes);
  }
  const bool is_missing =
      std::ranges::all_of(skybox_.sides, [](const formats::Image& side) { return side.pixels.empty(); });
  io_scene.skybox = is_missing ? nullptr : &skybox_;
}

}  // namespace temblor::client
