#include "client/view/presentation.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "assets/captions.h"
#include "client/lines/box_lines.h"
#include "client/view/held_gun.h"

namespace temblor::client {

Presentation::Presentation(const assets::Library& library)
    : library_(library),
      pictures_(library.pictures(notes_)),
      mark_pictures_(MarkPictures::load(library, notes_)),
      hud_(pictures_, assets::find_mission_pack(library.files())),
      subtitles_(assets::load_captions(library.files(), notes_)),
      audio_scene_(library) {}

base::Status Presentation::begin_level(const Game& game, const PresentationSettings& settings) {
  scene_ = {};
  models_.reset();
  pvs_leaf_.reset();
  missing_marks_.clear();
  TRY(ModelTable models, ModelTable::load(library_, game.models, settings.level, notes_));
  models_.emplace(std::move(models));
  model_names_ = game.models;
  client_settings_.no_lerp_models.clear();
  // The variable lists names, interpolation needs flags by precache number.
  for (const std::string& name : game.models)
    client_settings_.no_lerp_models.push_back(std::find(settings.no_lerp_models.begin(),
                                                        settings.no_lerp_models.end(),
                                                        name) != settings.no_lerp_models.end());
  if (hud_program_ != nullptr) hud_program_->begin_level();
  environment_.begin_level(*models_->level());
  scene_builder_.begin_level();
  reset_effects();
  begin_sound(game, settings);
  return base::Ok{};
}

// Ends everything that fades or moves, for a new level or a seek.
void Presentation::reset_effects() {
  scene_ = {};
  hud_.begin_level();
  subtitles_.begin_level();
  effects_.begin_level();
  view_.begin_level();
}

// Reloads models only if the demo is in another level than before.
base::Status Presentation::resume(ClientState& io_state, const EffectCounts& before,
                                  const PresentationSettings& settings) {
  if (!models_ || model_names_ != io_state.game().models)
    TRY_STATUS(begin_level(io_state.game(), settings));
  else
    reset_effects();
  effects_.resume(before);
  io_state.events().new_level = false;
  return base::Ok{};
}

// A level that began without sound stays silent: its sounds were not loaded.
void Presentation::begin_sound(const Game& game, const PresentationSettings& settings) {
  has_sound_ = settings.sound;
  if (has_sound_) audio_scene_.begin_level(game);
}

// Each name is noted once in a level, for at most as many names as there can be pictures.
void Presentation::note_missing_marks(const Events& events) {
  for (const net::MarkRequest& request : events.marks) {
    if (request.picture.starts_with('*') || mark_pictures_.find(request.picture) != nullptr) continue;
    if (missing_marks_.size() == MarkPictures::kMaxPictures ||
        std::find(missing_marks_.begin(), missing_marks_.end(), request.picture) != missing_marks_.end())
      continue;
    missing_marks_.push_back(request.picture);
    notes_.push_back(fmt::format(
        "the game asked for the mark \"{0}\", but no game directory has a usable gfx/marks/{0}.png",
        request.picture));
  }
}

// Finds the water of a Half-Life level, which may have risen.
void Presentation::place_liquids(const world::Level& level, std::span<const InterpolatedEntity> entities) {
  liquids_.clear();
  if (!level.is_half_life) return;
  const std::span<const world::ModelIndex> submodels = models_->submodels();
  for (const InterpolatedEntity& entity : entities) {
    const std::size_t number = entity.model;
    const world::ModelIndex model = number < submodels.size() ? submodels[number] : world::ModelIndex{0};
    if (level.brush_entities[base::to_size(model)].liquid != world::Contents::kEmpty)
      liquids_.push_back({model, entity.origin_world});
  }
}

// Advances effects, view and heads-up display to the time, and returns what there is to see. The order
// matters: the view starts at the predicted place, and effects at the gun in the view.
Presentation::FrameView Presentation::advance_parts(ClientState& io_state, double time_s,
                                                    const math::Vec3& view_angles_deg,
                                                    const PresentationSettings& settings) {
  const Game& game = io_state.game();
  client_settings_.interpolate = settings.interpolate;
  const std::span<const InterpolatedEntity> entities =
      io_state.interpolate_entities(time_s, client_settings_);
  const world::Level& level = *models_->level();
  ViewInput moment{time_s, view_angles_deg, find_entity(entities, game.view_entity), level};
  place_liquids(level, entities);
  moment.liquids = liquids_;
  if (prediction_ && settings.predict) moment.own = prediction_->advance(io_state, level, entities);
  std::optional<math::Vec3> predicted_origin_world;
  if (moment.own) predicted_origin_world = moment.own->origin_world;
  note_missing_marks(io_state.events());
  for (std::string& note : io_state.events().notes) notes_.push_back(std::move(note));
  PlayerView view = view_.advance(game, io_state.events(), moment, settings.view);
  if (settings.camera)
    view = make_camera_view(*settings.camera, level, settings.view);
  else if (settings.choices.chase && game.ending == Ending::kNone)
    chase_player(level, *settings.choices.chase, view);
  std::optional<HeldGun> held_gun;
  if (settings.show_weapon)
    held_gun = find_held_gun(game, *models_, view, settings.weapon_fov_deg, settings.choices.md5_models);
  effects_.advance(
      io_state.events(),
      {level, time_s, entities, models_->flags(), game.view_entity, predicted_origin_world,
       models_->submodels(), &mark_pictures_, game.models, models_->heights(), held_gun, liquids_},
      settings.effects);
  hud_.advance(game, io_state.events(), time_s);
  if (settings.subtitles) subtitles_.advance(game, io_state.events(), view.camera, time_s);
  if (has_sound_) audio_scene_.advance(game, io_state.events(), entities, level, view, settings.volumes);
  time_s_ = time_s;
  io_state.events().clear();
  return {entities, view};
}

// Keeps the lights of the previous scene too, for a renderer that relights only some of the faces in each
// frame (Settings::relight_alternate).
void Presentation::make_scene(const ClientState& state, double time_s, const FrameView& frame_view,
                              const PresentationSettings& settings) {
  const Game& game = state.game();
  const bool is_first_scene = scene_.level == nullptr;
  lights_before_.swap(lights_);
  light_before_ = {lights_before_, scene_.light_styles};
  scene_ = scene_builder_.build({*models_, game, frame_view.entities, effects_, frame_view.view,
                                 state.interpolate_weapon_frame(time_s, client_settings_), time_s,
                                 settings.show_weapon && game.ending == Ending::kNone,
                                 settings.camera.has_value() || settings.choices.chase.has_value(),
                                 settings.choices.light_styles, settings.choices.md5_models},
                                notes_);
  scene_.weapon_fov_deg = settings.weapon_fov_deg;
  apply_choices(settings.choices, scene_);
  make_box_lines(settings.boxes, lines_);
  lines_.insert(lines_.end(), settings.lines.begin(), settings.lines.end());
  for (const WorldText& text : settings.texts) append_text_lines(text, scene_.camera.angles_deg, lines_);
  scene_.lines = lines_;
  if (!settings.choices.locks_pvs)
    pvs_leaf_.reset();
  else if (!pvs_leaf_)
    pvs_leaf_ = frame_view.view.leaf;
  scene_.pvs_leaf = pvs_leaf_;
  lights_.assign(scene_.lights.begin(), scene_.lights.end());
  scene_.frame_number = ++frame_number_;
  scene_.light_before = is_first_scene ? nullptr : &light_before_;
  environment_.apply({library_, game, time_s}, settings.environment, notes_, scene_);
}

base::Status Presentation::advance(ClientState& io_state, double time_s, const math::Vec3& view_angles_deg,
                                   const PresentationSettings& settings) {
  if (io_state.events().new_level) TRY_STATUS(begin_level(io_state.game(), settings));
  if (!models_) return base::Ok{};
  make_scene(io_state, time_s, advance_parts(io_state, time_s, view_angles_deg, settings), settings);
  return base::Ok{};
}

base::Status Presentation::advance_unseen(ClientState& io_state, double time_s,
                                          const math::Vec3& view_angles_deg,
                                          const PresentationSettings& settings) {
  if (io_state.events().new_level) TRY_STATUS(begin_level(io_state.game(), settings));
  if (models_) advance_parts(io_state, time_s, view_angles_deg, settings);
  return base::Ok{};
}

std::vector<std::string> Presentation::take_notes() {
  std::vector<std::string> of_sound = audio_scene_.take_notes();
  std::move(of_sound.begin(), of_sound.end(), std::back_inserter(notes_));
  return std::exchange(notes_, {});
}

const render::DrawList& Presentation::draw_list(const ClientState& state, int width, int height,
                                                const PresentationSettings& settings) {
  draw_list_.clear();
  HudSettings hud = settings.hud;
  hud.par_s = environment_.level().par_s;
  hud.camera = scene_.camera;
  const HudDrawing* const program = hud_program_ != nullptr ? &hud_program_->drawing() : nullptr;
  const bool has_program = program != nullptr && program->is_active;
  if (has_program) {
    constexpr std::uint8_t kBlack = 0;
    hud.parts = program->parts;
    if (!program->shows_view) draw_list_.commands.push_back({.area = {0, 0, width, height}, .fill = kBlack});
  }
  hud_.draw(state.game(), time_s_, width, height, hud, draw_list_);
  if (has_program) {
    const std::vector<render::DrawCommand>& drawn = hud_program_->draw_list().commands;
    draw_list_.commands.insert(draw_list_.commands.end(), drawn.begin(), drawn.end());
  }
  if (settings.subtitles)
    subtitles_.draw(pictures_, width, height, settings.hud.size,
                    hud_.weapon_list_height_px(state.game(), time_s_, width, height, hud), draw_list_);
  return draw_list_;
}

}  // namespace temblor::client
