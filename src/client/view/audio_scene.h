// The audio side of the presentation: turns the server's messages and the listener's place into a scene and
// events for the mixer.
//
//   svc_sound, svc_temp_entity, static sounds --> SoundEvents: started, stopped, statics --+--> mixer
//   camera, leaf, volumes ----------------------> Scene: listener, ambients, volumes ------+
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "assets/library.h"
#include "audio/scene.h"
#include "client/session/client_state.h"
#include "client/session/interpolated_entity.h"
#include "client/session/sound_table.h"
#include "client/view/view.h"
#include "world/level.h"

namespace temblor::client {

// Runs without a mixer or sound device too. The library must outlive it.
class AudioScene {
 public:
  explicit AudioScene(const assets::Library& library) : sounds_(library) {}

  // Ends all sounds and starts loading those of the level. Missing and damaged ones are silent.
  void begin_level(const Game& game);
  // Jumps to another time in the same level (a seek in a demo): ends all sounds, and skips what happened in
  // between. `static_sounds` are the level's static sounds at that time.
  void resume(std::span<const net::SpawnStaticSound> static_sounds);
  // Ends all sounds of the level.
  void end_level();
  // Starts the sounds of `events`, and moves the listener to the view's camera. `entities`: in view, sorted
  // by number.
  void advance(const Game& game, const Events& events, std::span<const InterpolatedEntity> entities,
               const world::Level& level, const PlayerView& view, const audio::Volumes& volumes);
  // Plays a sound that does not belong to the game, such as a menu click, at a volume of 0 to 1. `name` as in
  // game code: "misc/menu1.wav".
  void play_local(const std::string& name, float volume = 1);

  const audio::Scene& scene() const { return scene_; }
  // Sound events for the mixer. The owner passes them on and clears them.
  audio::SoundEvents& events() { return events_; }

  // Returns the problems since the last call, a line each.
  std::vector<std::string> take_notes();

 private:
  void add_sound(const net::TempEntity& what);
  void add_sound(const net::SpawnStaticSound& what);
  void begin_ambients();

  SoundTable sounds_;
  audio::Scene scene_;
  audio::SoundEvents events_;
  std::uint32_t hit_count_ = 0;
  std::vector<std::string> notes_;
  std::vector<std::uint16_t> reported_statics_;
};

}  // namespace temblor::client
