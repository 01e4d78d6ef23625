// Builds the renderer's Scene from the client's entities, effects and view: chooses the kind of instance for
// each entity by its model, the pose of each alias model, and the picture of each sprite.
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

// The inputs, all at one server time.
struct SceneInput {
  const ModelTable& models;
  const Game& game;
  std::span<const InterpolatedEntity> entities;
  const Effects& effects;
  const PlayerView& view;
  FrameBlend weapon_frame;
  double time_s;
  // The variable r_drawviewmodel, and no ending.
  bool show_weapon = true;
  // Draw the player's own body, for cameras outside it.
  bool show_player = false;
  world::LightStyleMode light_styles = world::LightStyleMode::kFlickering;
  // Draw MD5 models instead of the MDL files that they replace: the variable r_md5.
  bool prefers_md5 = true;
};

// Owns the lists that a Scene refers to. The lists keep their capacity, so building allocates nothing in the
// steady state.
class SceneBuilder {
 public:
  // Builds a scene. It is valid until the next call, and while the input's parts live. Models that the server
  // never named are drawn as placeholders and reported once each.
  render::Scene build(const SceneInput& input, std::vector<std::string>& io_notes);

  void begin_level() { reported_.clear(); }

 private:
  void add_entity(const SceneInput& input, const InterpolatedEntity& entity,
                  std::vector<std::string>& io_notes);
  void add_alias(const SceneInput& input, const InterpolatedEntity& entity, const render::AliasModel& model);
  void add_sprite(const SceneInput& input, const InterpolatedEntity& entity, const formats::Spr& sprite);
  // Adds a model at a place. The result is valid until the next one is added.
  render::AliasInstance& add_model(const render::AliasModel& model, const math::Vec3& origin_world,
                                   const math::Vec3& angles_deg);
  void add_beams(const SceneInput& input);
  void add_casings(const SceneInput& input);
  void add_puffs(const SceneInput& input);
  bool place_weapon(const SceneInput& input);

  std::vector<render::BrushModelInstance> brush_models_;
  std::vector<render::AliasInstance> alias_models_;
  std::vector<render::SpriteInstance> sprites_;
  render::AliasInstance weapon_;
  std::vector<std::uint16_t> reported_;
};

}  // namespace temblor::client
