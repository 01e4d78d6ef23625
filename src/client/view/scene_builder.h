// What the client knows -> what the renderer draws.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "client/effects/effects.h"
#include "client/session/client_state.h"
#include "client/session/model_table.h"
#include "client/view/view.h"
#include "render/scene.h"

namespace temblor::client {

// Everything of one moment.
struct SceneInput {
  const ModelTable& models;
  const Game& game;
  std::span<const SeenEntity> entities;
  const Effects& effects;
  const PlayerView& view;
  FrameBlend weapon_frame;
  double time_s;
  bool show_weapon = true;   // r_drawviewmodel
  bool show_player = false;  // his own body, which stands around the eye otherwise
};

// Keeps the lists that a Scene refers to.
class SceneBuilder {
 public:
  // Valid until the next call, and while the input's parts live. Models
  // that the server never named are drawn as stand-ins and noted once each.
  render::Scene build(const SceneInput& input, std::vector<std::string>& io_notes);

  void begin_level() { noted_.clear(); }

 private:
  void add_entity(const SceneInput& input, const SeenEntity& entity, std::vector<std::string>& io_notes);
  void add_alias(const SceneInput& input, const SeenEntity& entity, const render::AliasModel& model);
  void add_sprite(const SceneInput& input, const SeenEntity& entity, const formats::Spr& sprite);
  void add_beams(const SceneInput& input);
  bool place_weapon(const SceneInput& input);

  std::vector<render::BrushModelInstance> brush_models_;
  std::vector<render::AliasInstance> alias_models_;
  std::vector<render::SpriteInstance> sprites_;
  render::AliasInstance weapon_;
  std::vector<std::uint16_t> noted_;
};

}  // namespace temblor::client
