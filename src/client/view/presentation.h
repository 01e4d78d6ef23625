// From the client's state to a frame: everything between network messages and the renderer, the same for
// demos and games.
//
//                               /  Prediction, View, Effects -> SceneBuilder -> render::Scene
//   ClientState --advance()-->    Hud, Subtitles ----------------------------> render::DrawList
//                               \  AudioScene -------------------------------> audio::Scene, SoundEvents
//
// One Presentation lives for the whole session; it loads models and pictures when a level begins.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assets/library.h"
#include "audio/scene.h"
#include "base/result.h"
#include "client/effects/effects.h"
#include "client/hud/hud.h"
#include "client/hud_program/hud_program.h"
#include "client/lines/world_text.h"
#include "client/prediction/prediction.h"
#include "client/session/client_state.h"
#include "client/session/model_table.h"
#include "client/subtitles/subtitles.h"
#include "client/view/audio_scene.h"
#include "client/view/scene_builder.h"
#include "client/view/scene_choices.h"
#include "client/view/scene_environment.h"
#include "client/view/view.h"
#include "render/draw_list.h"
#include "render/scene.h"

namespace temblor::client {

// The values of the client's console variables, read once a frame.
struct PresentationSettings {
  // See ClientSettings.
  bool interpolate = true;
  // Predict the player's own motion if the server supports it.
  bool predict = true;
  // For the next level that is loaded.
  assets::LevelOptions level{.external_textures = true};
  // Models that are not blended from frame to frame, by name in the precache list. Takes effect at the next
  // level.
  std::vector<std::string> no_lerp_models = {"progs/flame.mdl", "progs/flame0.mdl", "progs/flame2.mdl"};
  EffectsSettings effects;
  ViewSettings view;
  HudSettings hud;
  // Let the game's own program draw the HUD, if there is one.
  bool runs_hud_program = true;
  bool show_weapon = true;
  // The weapon's field of view; 0: the view's.
  float weapon_fov_deg = 90;
  EnvironmentSettings environment;
  SceneChoices choices;
  // Load sounds and fill audio_scene(). Takes effect at the next level.
  bool sound = false;
  audio::Volumes volumes;
  // Captions for sounds from outside the view.
  bool subtitles = false;
  // Drawn as lines over the view: the boxes of the local server's entities, and the shapes of its game code.
  std::vector<math::Bounds> boxes;
  std::vector<render::Line> lines;
  std::vector<WorldText> texts;
  // A camera that replaces the player's view.
  std::optional<render::Camera> camera;
};

// Owns everything that the client loads to draw a level. The library must outlive it.
class Presentation {
 public:
  explicit Presentation(const assets::Library& library);

  // Advances to `time_s`, acts on the state's events and clears them. Loads the level's models if a new level
  // has begun; fails if the level cannot be loaded. There is nothing to draw before the state is in a game.
  base::Status advance(ClientState& io_state, double time_s, const math::Vec3& view_angles_deg,
                       const PresentationSettings& settings);
  // Like advance(), but makes no scene to draw: for times between frames at which something happens.
  base::Status advance_unseen(ClientState& io_state, double time_s, const math::Vec3& view_angles_deg,
                              const PresentationSettings& settings);
  // The game's 2-D pictures, also for menus and the console.
  const assets::Pictures& pictures() const { return pictures_; }
  // Call after the state was moved to another time of its demo; `before` counts the effects up to there. Ends
  // all effects and loads the level if it is another one. The events at that time are still to be acted on by
  // advance().
  base::Status resume(ClientState& io_state, const EffectCounts& before,
                      const PresentationSettings& settings);
  // From now on shows the player where `prediction` predicts it, after its begin_frame(); null: where the
  // server's packets place it. The object must stay alive until replaced.
  void set_prediction(Prediction* prediction) { prediction_ = prediction; }
  // From now on shows what this program drew, where it has drawn; null: the built-in HUD. The object must
  // stay alive until replaced.
  void set_hud_program(HudProgram* program) { hud_program_ = program; }
  // Whether a level is loaded.
  bool has_level() const { return models_.has_value(); }

  // Results of the last advance(). Valid until the next one, and while the state lives.
  const render::Scene& scene() const { return scene_; }
  // The fog of the level or server, also if the player turned it off.
  const render::Fog& fog() const { return environment_.fog(); }
  // The skybox in this level; empty: the level's sky texture.
  const std::string& skybox_name(const Game& game) const { return environment_.skybox_name(game); }
  const render::DrawList& draw_list(const ClientState& state, int width, int height,
                                    const PresentationSettings& settings);

  // The sounds up to the last advance() or advance_unseen(). The owner of the mixer passes its events on and
  // clears them.
  AudioScene& audio_scene() { return audio_scene_; }

  // Returns the problems since the last call, a line each.
  std::vector<std::string> take_notes();

 private:
  base::Status begin_level(const Game& game, const PresentationSettings& settings);
  void begin_sound(const Game& game, const PresentationSettings& settings);
  void reset_effects();
  void note_missing_marks(const Events& events);
  // The entities and the view of a frame, for make_scene().
  struct FrameView {
    std::span<const InterpolatedEntity> entities;
    PlayerView view;
  };
  FrameView advance_parts(ClientState& io_state, double time_s, const math::Vec3& view_angles_deg,
                          const PresentationSettings& settings);
  void place_liquids(const world::Level& level, std::span<const InterpolatedEntity> entities);
  void make_scene(const ClientState& state, double time_s, const FrameView& frame_view,
                  const PresentationSettings& settings);

  const assets::Library& library_;
  std::vector<std::string> notes_;  // declared before pictures_, which adds to it
  assets::Pictures pictures_;
  MarkPictures mark_pictures_;
  std::vector<world::PlacedLiquid> liquids_;  // at the time of the frame
  // The missing pictures of marks that were noted in this level.
  std::vector<std::string> missing_marks_;
  std::optional<ModelTable> models_;
  // The server's names of models_.
  std::vector<std::string> model_names_;
  ClientSettings client_settings_;
  Effects effects_;
  View view_;
  Prediction* prediction_ = nullptr;
  Hud hud_;
  HudProgram* hud_program_ = nullptr;
  Subtitles subtitles_;
  SceneBuilder scene_builder_;
  AudioScene audio_scene_;
  // Whether this level has sound: the setting at its start.
  bool has_sound_ = false;
  SceneEnvironment environment_;
  // The leaf whose potentially visible set is locked (SceneChoices::locks_pvs).
  std::optional<world::LeafIndex> pvs_leaf_;
  render::Scene scene_;
  // The lights of this scene and of the previous one.
  std::vector<render::DynamicLight> lights_, lights_before_;
  std::vector<render::Line> lines_;
  render::SceneLight light_before_;
  std::uint32_t frame_number_ = 0;
  render::DrawList draw_list_;
  double time_s_ = 0;
};

}  // namespace temblor::client
