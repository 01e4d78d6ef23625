// What a player hears: from the server's messages and the place of his head to the mixer's scene and events.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "assets/library.h"
#include "audio/scene.h"
#include "client/session/client_state.h"
#include "client/session/sound_table.h"
#include "client/view/view.h"
#include "world/level.h"

namespace temblor::client {

class AudioScene {
 public:
  explicit AudioScene(const assets::Library& library) : sounds_(library) {}

  // All that sounded ends. The level's sounds begin to be loaded; those that are damaged or missing are
  // silent.
  void begin_level(const Game& game);
  // Another moment of the same level (a recording sought in): what sounded ends, and what has happened since
  // is not heard. The level's static sounds by then are these.
  void resume(std::span<const net::SpawnStaticSound> static_sounds);
  // The game is over: nothing of its places is heard any more.
  void end_level();
  // Hears what has happened, from where the eye is now.
  void advance(const Game& game, const Events& events, const world::Level& level, const PlayerView& view,
               const audio::Volumes& volumes);
  // Heard in full, whatever else happens: a menu's clicks. `name` as game code has it: "misc/menu1.wav".
  void play_local(const std::string& name);

  const audio::Scene& scene() const { return scene_; }
  // What has happened since whoever passes it on to a mixer has cleared it.
  audio::SoundEvents& events() { return events_; }

  // What was made do with, a line each, since the last time it was asked for.
  std::vector<std::string> take_notes();

 private:
  void hear(const net::TempEntity& what);
  void hear(const net::SpawnStaticSound& what);
  void begin_ambients();

  SoundTable sounds_;
  audio::Scene scene_;
  audio::SoundEvents events_;
  std::uint32_t hit_count_ = 0;
  std::vector<std::string> notes_;
  std::vector<std::uint16_t> noted_statics_;
};

}  // namespace temblor::client
