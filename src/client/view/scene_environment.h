// The sky, fog, and liquid opacity of scenes: those of the level, unless messages of the server replace them
// or the player turns them off.
//
//   worldspawn -> LevelEnvironment --+
//   Game (messages of the server) ---+--> apply() -> Scene::skybox, fog, liquid_alpha
//   EnvironmentSettings -------------+
#pragma once

#include <string>
#include <vector>

#include "assets/library.h"
#include "client/prediction/level_environment.h"
#include "client/session/client_state.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

// The player's choices.
struct EnvironmentSettings {
  // For liquids without an opacity in the level.
  render::LiquidAlpha liquid_alpha;
  bool fog = true, skybox = true;
};

class SceneEnvironment {
 public:
  void begin_level(const world::Level& level) { level_ = parse_environment(level); }
  const LevelEnvironment& level() const { return level_; }
  // Empty: the level's sky texture.
  const std::string& skybox_name(const Game& game) const {
    return game.skybox ? *game.skybox : level_.skybox;
  }

  // The source of skyboxes, and the game at a time. A default Game has no messages: the level decides.
  struct Moment {
    const assets::Library& library;
    const Game& game;
    double time_s;
  };
  // Sets the environment of the scene, which refers to the skybox in this object. A skybox is loaded only
  // when its name changes; missing sides are lines in `io_notes`. Without any side, the level's sky texture
  // is drawn, as in other engines.
  void apply(const Moment& moment, const EnvironmentSettings& settings, std::vector<std::string>& io_notes,
             render::Scene& io_scene);

  // The fog of the last apply(), also if the player turned it off.
  const render::Fog& fog() const { return fog_; }

 private:
  LevelEnvironment level_;
  render::Fog fog_;
  std::string skybox_name_;
  render::Skybox skybox_;
};

}  // namespace temblor::client
