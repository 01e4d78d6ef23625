#include "client/view/scene_builder.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/models/group_time.h"

namespace temblor::client {
namespace {

// The weapon in hand is never darker than this light level, as in the original.
constexpr float kWeaponMinLight = 24;

// Frame groups with a random phase start at a different time for each entity, so that a row of torches does
// not flicker in step.
double compute_phase_time_s(double time_s, std::uint32_t entity, bool random_phase) {
  constexpr double kPhaseStep_s = 0.618034;  // the golden ratio spreads neighbors evenly
  return random_phase ? time_s + kPhaseStep_s * entity : time_s;
}

render::BrushModelInstance make_brush_model(const world::Level& level, world::ModelIndex model,
                                            const InterpolatedEntity& entity) {
  render::BrushModelInstance instance{model, entity.origin_world, entity.angles_deg, entity.to_frame,
                                      entity.alpha};
  const std::size_t number = base::to_size(model);
  if (number < level.brush_entities.size()) {
    instance.is_additive = level.brush_entities[number].is_additive;
    instance.color = level.brush_entities[number].color;
  }
  return instance;
}

}  // namespace

// Blends between two poses. The frame numbers come from the entity; groups of frames choose a pose by time.
void SceneBuilder::add_alias(const SceneInput& input, const InterpolatedEntity& entity,
                             const render::AliasModel& model) {
  const double time_s = compute_phase_time_s(input.time_s, entity.number, render::has_random_phase(model));
  render::AliasInstance instance;
  instance.model = &model;
  instance.origin_world = entity.origin_world;
  instance.angles_deg = entity.angles_deg;
  if ((render::find_model_flags(model) & formats::kMdlRotate) != 0)
    instance.angles_deg.y = compute_rotated_yaw_deg(input.time_s);
  instance.scale = entity.scale;
  instance.from_pose = render::pose_at(model, entity.from_frame, time_s);
  instance.to_pose = render::pose_at(model, entity.to_frame, time_s);
  instance.blend = entity.blend;
  instance.skin = render::skin_at(model, entity.skin, time_s);
  instance.alpha = entity.alpha;
  // Colormap n is that of player n; 0 leaves the skin as it is.
  if (entity.colormap > 0 && entity.colormap <= input.game.players.size()) {
    const Player& player = input.game.players[entity.colormap - 1u];
    instance.colors = render::PlayerColors{player.shirt, player.pants};
  }
  alias_models_.push_back(instance);
}

// Sprites are not blended.
void SceneBuilder::add_sprite(const SceneInput& input, const InterpolatedEntity& entity,
                              const formats::Spr& sprite) {
  const std::size_t number = entity.to_frame < sprite.frames.size() ? entity.to_frame : 0;
  const formats::SprFrame& frame = sprite.frames[number];
  const double time_s = compute_phase_time_s(input.time_s, entity.number, sprite.random_phase);
  render::SpriteInstance instance;
  instance.sprite = &sprite;
  instance.picture = &frame.pictures[formats::find_group_member(frame.end_times_s, time_s)];
  instance.origin_world = entity.origin_world;
  instance.angles_deg = entity.angles_deg;
  instance.scale = entity.scale;
  instance.alpha = entity.alpha;
  sprites_.push_back(instance);
}

void SceneBuilder::add_entity(const SceneInput& input, const InterpolatedEntity& entity,
                              std::vector<std::string>& io_notes) {
  const bool is_player = entity.number == input.game.view_entity;
  if (entity.model == 0 || entity.alpha <= 0 || (is_player && !input.show_player)) return;
  if (!input.models.contains(entity.model) &&
      std::find(reported_.begin(), reported_.end(), entity.model) == reported_.end()) {
    reported_.push_back(entity.model);
    io_notes.push_back(fmt::format("entity {} has unknown model {}. A placeholder is drawn instead",
                                   entity.number, entity.model));
  }
  const ClientModel& model = input.models.model(entity.model);
  if (const auto* brush_model = std::get_if<world::ModelIndex>(&model)) {
    // The world itself is always drawn.
    if (*brush_model == world::ModelIndex{0}) return;
    brush_models_.push_back(make_brush_model(*input.models.level(), *brush_model, entity));
  } else if (const auto* alias = input.models.alias_model(entity.model, input.prefers_md5)) {
    add_alias(input, entity, *alias);
  } else {
    add_sprite(input, entity, *std::get<SpritePtr>(model));
  }
}

render::AliasInstance& SceneBuilder::add_model(const render::AliasModel& model,
                                               const math::Vec3& origin_world, const math::Vec3& angles_deg) {
  render::AliasInstance& instance = alias_models_.emplace_back();
  instance.model = &model;
  instance.origin_world = origin_world;
  instance.angles_deg = angles_deg;
  return instance;
}

// Games without a model for a kind of beam or casing show nothing for it.
void SceneBuilder::add_beams(const SceneInput& input) {
  for (const BeamPiece& piece : input.effects.beams())
    if (const render::AliasModel* model = input.models.beam(piece.model, input.prefers_md5))
      add_model(*model, piece.origin_world, piece.angles_deg).full_bright = true;
}

void SceneBuilder::add_casings(const SceneInput& input) {
  for (const CasingPiece& piece : input.effects.casings())
    if (const render::AliasModel* model = input.models.casing(piece.model, input.prefers_md5))
      add_model(*model, piece.origin_world, piece.angles_deg).alpha = piece.alpha;
}

void SceneBuilder::add_puffs(const SceneInput& input) {
  for (const Puff& puff : input.effects.puffs()) {
    const formats::Spr* sprite = input.models.puff(puff.picture);
    if (sprite == nullptr) continue;
    const auto frame = static_cast<std::size_t>(puff.age * static_cast<float>(sprite->frames.size()));
    render::SpriteInstance instance;
    instance.sprite = sprite;
    instance.picture = &sprite->frames[std::min(frame, sprite->frames.size() - 1)].pictures.front();
    instance.origin_world = puff.origin_world;
    instance.angles_deg = puff.angles_deg;
    instance.scale = puff.scale;
    instance.alpha = puff.alpha;
    sprites_.push_back(instance);
  }
}

// Places the weapon in hand; returns false if none is shown.
bool SceneBuilder::place_weapon(const SceneInput& input) {
  const auto number = static_cast<std::size_t>(std::max(0, input.game.stat(Stat::kWeaponModel)));
  if (!input.show_weapon || !input.view.show_weapon || number == 0) return false;
  const render::AliasModel* model = input.models.alias_model(number, input.prefers_md5);
  if (model == nullptr || !input.models.contains(number)) return false;
  weapon_ = {};
  weapon_.model = model;
  weapon_.origin_world = input.view.weapon_origin_world;
  weapon_.angles_deg = input.view.weapon_angles_deg;
  weapon_.from_pose = render::pose_at(*model, input.weapon_frame.from, input.time_s);
  weapon_.to_pose = render::pose_at(*model, input.weapon_frame.to, input.time_s);
  weapon_.blend = input.weapon_frame.blend;
  weapon_.alpha = input.game.data.weapon_alpha;
  weapon_.min_light = kWeaponMinLight;
  return true;
}

render::Scene SceneBuilder::build(const SceneInput& input, std::vector<std::string>& io_notes) {
  brush_models_.clear();
  alias_models_.clear();
  sprites_.clear();
  for (const InterpolatedEntity& entity : input.entities) add_entity(input, entity, io_notes);
  add_beams(input);
  add_casings(input);
  add_puffs(input);

  render::Scene scene;
  scene.level = input.models.level().get();
  scene.camera = input.view.camera;
  scene.brush_models = brush_models_;
  scene.alias_models = alias_models_;
  scene.view_weapon = place_weapon(input) ? &weapon_ : nullptr;
  scene.sprites = sprites_;
  scene.particles = input.effects.particles();
  scene.lights = input.effects.lights();
  scene.marks = &input.effects.marks();
  scene.underwater = input.view.underwater;
  scene.tint = input.view.tint;
  scene.time_s = input.time_s;
  scene.light_styles = world::compute_light_styles(input.game.light_styles, input.time_s, input.light_styles);
  return scene;
}

}  // namespace temblor::client
