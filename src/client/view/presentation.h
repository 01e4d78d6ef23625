// From the client's state to a frame: scene and 2-D. The same for a recording and for a game.
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
#include "client/hud/subtitles.h"
#include "client/prediction/level_environment.h"
#include "client/prediction/prediction.h"
#include "client/session/client_state.h"
#include "client/session/model_table.h"
#include "client/view/audio_scene.h"
#include "client/view/scene_builder.h"
#include "client/view/view.h"
#include "render/draw_list.h"
#include "render/scene.h"

namespace temblor::client {

struct PresentationSettings {
  bool interpolate = true;  // ClientSettings
  bool predict = true;      // the player's own moves, where the server takes part
  // Models that are not blended from frame to frame, by their names in the precache list; followed from the
  // next level on.
  std::vector<std::string> no_lerp_models = {"progs/flame.mdl", "progs/flame0.mdl", "progs/flame2.mdl"};
  EffectsSettings effects;
  ViewSettings view;
  HudSettings hud;
  bool show_weapon = true;
  // Of liquids whose level says nothing of its own.
  render::LiquidAlpha liquid_alpha;
  bool fog = true, skybox = true;
  bool sound = false;  // loads sounds and fills audio_scene(); followed from the next level on
  audio::Volumes volumes;
  bool subtitles = false;  // of sounds that come from where the player does not look
  // Where to look from instead of the player's eyes.
  std::optional<render::Camera> camera;
};

class Presentation {
 public:
  explicit Presentation(const assets::Library& library);

  // Time passes up to `time_s`, and the state's events are acted on and cleared. Loads the level's models
  // when a new one has begun; fails when the level cannot be loaded. Nothing is drawn before the state is in
  // a game.
  base::Status advance(ClientState& io_state, double time_s, const math::Vec3& view_angles_deg,
                       const PresentationSettings& settings);
  // The same, but there is nothing to draw after it until the next advance(): for moments between frames at
  // which something happens.
  base::Status pass(ClientState& io_state, double time_s, const math::Vec3& view_angles_deg,
                    const PresentationSettings& settings);
  // The game's 2-D pictures; for menus and the console.
  const assets::Pictures& pictures() const { return pictures_; }
  // The state has been put to another moment of its recording, `before` which that much had happened: all
  // that was under way ends, and time goes on from there. Loads the level if it is another one; what happens
  // in this moment is still to be acted on.
  base::Status resume(ClientState& io_state, const EffectCounts& before,
                      const PresentationSettings& settings);
  // From the next call on the player is shown where `prediction` has him, after its begin_frame(); null:
  // where the server has. It must live until then.
  void follow(Prediction* prediction) { prediction_ = prediction; }
  // Whether there is a level to draw.
  bool has_level() const { return models_.has_value(); }

  // What the last advance() led to. Valid until the next one, and while the state lives.
  const render::Scene& scene() const { return scene_; }
  const render::DrawList& draw_list(const ClientState& state, int width, int height,
                                    const PresentationSettings& settings);

  // What is heard, up to the last advance() or pass(). Its events are for whoever owns the mixer to take and
  // clear.
  AudioScene& audio_scene() { return audio_scene_; }

  // What was made do with since the last time it was asked for, a line each.
  std::vector<std::string> take_notes();

 private:
  base::Status begin_level(const Game& game, const PresentationSettings& settings);
  void begin_sound(const Game& game, const PresentationSettings& settings);
  void forget_past();
  struct Sight {
    std::span<const SeenEntity> entities;
    PlayerView view;
  };
  Sight look(ClientState& io_state, double time_s, const math::Vec3& view_angles_deg,
             const PresentationSettings& settings);
  void make_scene(const ClientState& state, double time_s, const Sight& sight,
                  const PresentationSettings& settings);
  void apply_environment(const Game& game, double time_s, const PresentationSettings& settings);

  const assets::Library& library_;
  std::vector<std::string> notes_;  // the pictures' too: made before them
  assets::Pictures pictures_;
  std::optional<ModelTable> models_;
  std::vector<std::string> model_names_;  // of those, as the server named them
  ClientSettings client_settings_;
  Effects effects_;
  View view_;
  Prediction* prediction_ = nullptr;
  Hud hud_;
  Subtitles subtitles_;
  SceneBuilder scene_builder_;
  AudioScene audio_scene_;
  bool has_sound_ = false;  // of this level
  LevelEnvironment environment_;
  std::string skybox_name_;
  render::Skybox skybox_;
  render::Scene scene_;
  std::vector<render::DynamicLight> lights_, lights_before_;  // of the scene, and of the one before it
  render::SceneLight light_before_;
  std::uint32_t frame_number_ = 0;
  render::DrawList draw_list_;
  double time_s_ = 0;
};

}  // namespace temblor::client
