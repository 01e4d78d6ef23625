// What a client knows of the game, from nothing but the server's messages: no window, no files, no clock.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "client/session/entity_table.h"
#include "client/session/interpolation.h"
#include "client/session/seen_entity.h"
#include "net/protocol/server_message.h"
#include "world/animation.h"

namespace temblor::client {

enum class Stat : std::uint8_t {
  kHealth = 0,
  kFrags = 1,
  kWeaponModel = 2,
  kAmmo = 3,
  kArmor = 4,
  kWeaponFrame = 5,
  kShells = 6,
  kNails = 7,
  kRockets = 8,
  kCells = 9,
  kActiveWeapon = 10,
  kTotalSecrets = 11,
  kTotalMonsters = 12,
  kSecrets = 13,
  kMonsters = 14
};

struct Player {
  std::string name;
  std::int16_t frags = 0;
  std::uint8_t shirt = 0, pants = 0;
};

enum class Ending { kNone, kIntermission, kFinale, kCutScene };

constexpr int kPlaying = 4;
// Half a year. Times are told as 32-bit floats: long before, they come in whole seconds.
constexpr float kMaxServerTime_s = 1 << 24;

// Fog as a mixture of the level's own, which the server's messages do not say, and what they have said.
struct FogMixture {
  float share_of_level = 1;
  float density = 0;  // to be added
  math::Vec3 color{0.0f};
};

// What holds from serverinfo on, until the next one.
struct Game {
  net::Dialect dialect;
  bool deathmatch = false;
  std::string level_name;           // "The Slipgate Complex"
  std::vector<std::string> models;  // [0] is empty; [1] is the level, "maps/e1m1.bsp"; "*1" a part of it
  std::vector<std::string> sounds;  // [0] is empty
  std::vector<Player> players;      // max_clients of them
  int signon = 0;                   // kPlaying: entities have come
  std::uint16_t view_entity = 0;
  std::array<std::int32_t, net::kStats> stats{};
  net::ClientData data;  // of the last update
  world::LightStylePatterns light_styles;
  math::Vec3 set_angles_deg{0.0f};  // as the server last turned the player
  std::uint32_t turns = 0;          // how often it did
  bool paused = false;
  Ending ending = Ending::kNone;
  double ending_since_s = 0;  // when the ending began: play time stands still
  std::string ending_text;
  std::string center_text;
  double center_text_since_s = 0;
  std::uint8_t music_track = 0;
  std::optional<std::string> skybox;  // as the server said; else as the level says
  std::optional<net::Fog> fog;        // alike; see fog_at()
  double fog_since_s = 0;             // when it began to come in, which takes fog->fade_s
  FogMixture fog_before;              // what it comes in over

  std::int32_t stat(Stat stat) const { return stats[static_cast<std::size_t>(stat)]; }
};

FogMixture fog_mixture_at(const Game& game, double time_s);
// The fog at that time, where the level's own is `of_level`. Its fade_s is 0: it is as it is.
net::Fog fog_at(const Game& game, const net::Fog& of_level, double time_s);

// What happened once. The client acts on it (effects, sounds, flashes) and clears it.
struct Events {
  std::vector<net::TempEntity> temp_entities;
  std::vector<net::Particles> particles;
  std::vector<net::Damage> damages;
  std::vector<net::Sound> sounds;
  std::vector<net::StopSound> stopped_sounds;  // after all of `sounds`
  std::vector<net::SpawnStaticSound> static_sounds;
  std::vector<std::string> prints;    // text for the console, as it came
  std::vector<std::string> commands;  // stuffed by the server: whole lines, without their ends
  int bonus_flashes = 0;              // messages, and lines "bf" of stuffed text
  bool new_level = false;  // a serverinfo came; what happened before it in the old level is left out
  // Keeps the memory.
  void clear();
};

struct ClientSettings {
  bool interpolate =
      true;  // false: entities stand where the last update put them, as the original played demos
  // Precache numbers of models that are not to be blended from frame to frame (flames): r_nolerp_list.
  std::vector<bool> no_lerp_models;
};

// Warm, it takes no memory for a packet but for text.
class ClientState {
 public:
  // Fails on what makes no sense after what came before (an entity number out of range, an update before
  // serverinfo); the state is then as if the message had not come. Model and sound numbers may be past the
  // end of their lists.
  base::Status apply(const net::ServerMessage& message);
  // After the last message of a packet or recorded message: entities that it left out are gone, if it had a
  // time.
  void end_packet();

  const Game& game() const { return game_; }
  Events& events() { return events_; }
  const Events& events() const { return events_; }

  // About what a copy of it takes.
  std::size_t memory_bytes() const;

  // The server's times of the last two packets, the same before there were two. Drawing happens between them.
  double time_s() const { return window_.end_s; }
  double previous_time_s() const { return previous_time_s_; }

  // All entities that the last packet showed, and the static ones, as they are at `time_s`, in order of
  // number. Valid until the next call.
  std::span<const SeenEntity> entities_at(double time_s, const ClientSettings& settings);
  // Where the last packet has put what it showed, in order of number. Static entities are not among them.
  void latest_places(std::vector<EntityPlace>& out_places) const { entities_.latest(out_places); }
  FrameBlend weapon_frame_at(double time_s, const ClientSettings& settings) const;
  // The last packet put the view somewhere else: what is drawn must not glide there.
  bool view_has_jumped() const { return entities_.has_jumped(game_.view_entity); }

 private:
  struct Apply;  // one function for each kind of message

  Game game_;
  Events events_;
  std::string command_line_;  // stuffed text whose line end has not come yet
  double previous_time_s_ = 0;
  PacketWindow window_;
  bool has_time_ = false;  // of this level
  EntityTable entities_;
  FrameChanges weapon_;
};

}  // namespace temblor::client
