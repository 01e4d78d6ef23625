// The client's view of the game, built only from the server's messages. No window, files or clock.
//
// Messages go in through apply(), one packet at a time; end_packet() closes each packet. Lasting facts end up
// in Game, one-time happenings in Events, entities in the EntityTable:
//
//   packet -> MessageReader -> apply() -> Game      level, players, stats, fog: until the next message
//                                      -> Events    sounds, particles, prints: until the client clears them
//                                      -> entities  interpolated between the last two packets
//
// All times are the server's, in seconds.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "client/session/entity_table.h"
#include "client/session/interpolated_entity.h"
#include "client/session/interpolation.h"
#include "formats/game/localization.h"
#include "net/protocol/combat_state.h"
#include "net/protocol/game_stat.h"
#include "net/protocol/mark_request.h"
#include "net/protocol/powerup_end.h"
#include "net/protocol/server_message.h"
#include "net/protocol/team_captures.h"
#include "world/animation.h"

namespace temblor::client {

// Indices of stats; the numbers are the protocol's.
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

// A player of the scoreboard.
struct Player {
  std::string name;
  std::int16_t frags = 0;
  // Rows of the palette, 0 to 15.
  std::uint8_t shirt = 0, pants = 0;
  // Milliseconds, as the server last listed them; see ClientState::expect_pings().
  int ping_ms = 0;
};

// How the level has ended, if it has: with statistics, with a text under the finale's title, or with only a
// text.
enum class Ending { kNone, kIntermission, kFinale, kCutScene };

// The last stage of the signon: the client is in the game.
constexpr int kPlaying = 4;
// About half a year. Times travel as 32-bit floats, which have a precision of whole seconds by then.
constexpr float kMaxServerTime_s = 1 << 24;

// Fog as a mixture of two parts: a share of the level's own fog, which the messages do not contain, and an
// added constant.
struct FogMixture {
  float share_of_level = 1;
  float density = 0;  // added to the level's share
  math::Vec3 color{0.0f};
};

// Everything that stays true from one serverinfo to the next.
struct Game {
  net::Dialect dialect;
  bool deathmatch = false;
  std::string level_name;  // for people: "The Slipgate Complex"
  // By precache number: [0] is empty, [1] is the level, "maps/e1m1.bsp"; "*1" is a submodel of it.
  std::vector<std::string> models;
  std::vector<std::string> sounds;  // by precache number; [0] is empty
  std::vector<Player> players;      // max_clients of them
  // The stage of the signon, 0 to kPlaying. At kPlaying the first entities have arrived.
  int signon = 0;
  std::uint16_t view_entity = 0;
  bool is_dead = false;                   // as of the last packet
  std::optional<math::Vec3> death_place;  // where the player was when it last died in this level
  bool has_noted_unknown = false;         // a message that the client does not know
  std::array<std::int32_t, net::kStats> stats{};
  // Stats of the game's own that are not whole numbers, for HUD programs.
  std::map<std::uint8_t, net::StatValue> game_stats;
  // When power-ups end, by bit of the items. 0: the server has not sent it.
  std::array<float, net::PowerupEnd::kMaxBit + 1> powerup_ends_s{};
  net::ClientData data;  // from the last packet
  world::LightStylePatterns light_styles;
  // In capture the flag, by the color of a team's pants: its captures.
  std::array<std::optional<std::int16_t>, net::TeamCaptures::kMaxColor + 1> captures;
  // The angles that the server last set.
  math::Vec3 set_angles_deg{0.0f};
  // How often the server has set the angles, so that each time can be noticed. Goes on from level to level.
  std::uint32_t turns = 0;
  bool paused = false;
  Ending ending = Ending::kNone;
  // When the ending began; play time stops then.
  double ending_since_s = 0;
  std::string ending_text;
  std::string center_text;
  double center_text_since_s = 0;
  std::uint8_t music_track = 0;
  bool is_hunted = false;               // by monsters; only Temblor servers send it
  std::optional<double> last_damage_s;  // when the player was last hurt
  // Set by the server; if not set, the level's worldspawn decides.
  std::optional<std::string> skybox;
  // Set by the server; see compute_fog().
  std::optional<net::Fog> fog;
  // Start of the fade to `fog`, which takes fog->fade_s.
  double fog_since_s = 0;
  FogMixture fog_before;  // the fog at the start of the fade

  std::int32_t stat(Stat stat) const { return stats[static_cast<std::size_t>(stat)]; }
};

// Whether the player fights at a time: monsters hunt it, or it was hurt in the last five seconds.
bool is_in_combat(const Game& game, double time_s);

// The server's fog at a time, with fading applied.
FogMixture compute_fog_mixture(const Game& game, double time_s);
// The fog to draw at a time, where `level_fog` is the level's own. The result's fade_s is 0.
net::Fog compute_fog(const Game& game, const net::Fog& level_fog, double time_s);

// Things that happen once. The client acts on them (effects, sounds, flashes), then clears them.
struct Events {
  std::vector<net::TempEntity> temp_entities;
  std::vector<net::Particles> particles;
  std::vector<net::Damage> damages;
  std::vector<net::Sound> sounds;
  std::vector<net::StopSound> stopped_sounds;  // take effect after all of `sounds`
  std::vector<net::SpawnStaticSound> static_sounds;
  std::vector<net::MarkRequest> marks;
  std::vector<math::Vec3> leak_path;  // corners of a line to show until the end of the level
  std::vector<std::string> prints;    // text for the console, byte for byte
  std::vector<std::string> notes;     // problems with the server's messages, for the player, a line each
  std::vector<std::string> commands;  // console lines that the server sent, without line ends
  int bonus_flashes = 0;              // svc_bonus messages and "bf" lines
  bool new_level = false;             // a serverinfo arrived; the old level's events are dropped
  // Keeps the capacity.
  void clear();
};

// How entities are interpolated.
struct ClientSettings {
  // False: entities stand where the last update put them, as the original played demos.
  bool interpolate = true;
  // By precache number: models whose frames are never blended, such as flames (r_nolerp_list).
  std::vector<bool> no_lerp_models;
};

// A copy is a complete snapshot: demos copy states to seek. Allocates nothing for a packet in the steady
// state, except for texts.
class ClientState {
 public:
  // Applies one message. Fails if it is impossible after the ones before it (an entity number out of range,
  // an update before serverinfo); the state is then unchanged. Model and sound numbers may be past the end of
  // their lists; readers must check.
  base::Status apply(const net::ServerMessage& message);
  // Call when a packet has a message that is_at_unknown() (net/protocol/message_reader.h). During the signon,
  // returns the error. Later, the game goes on without the rest of the packet, and the error is noted, once
  // in a level. Then do not call end_packet(): the entities that the rest of the packet named must stay.
  base::Status pass_over_unknown(const base::Error& error);
  // Call after the last message of a packet. Removes the entities that a packet with a time did not mention.
  void end_packet();

  // From now on replaces keys ("$map_start") in what the server sends for people to read; null: leaves them.
  // Servers that know the texts have replaced them before.
  void set_texts(std::shared_ptr<const formats::Localization> texts) { texts_ = std::move(texts); }

  // Call after sending the command "ping": the server answers with a print for each player, and the next such
  // list is not shown. Lists that the player has asked for set Player::ping_ms too.
  void expect_pings() { pings_ = {.is_expected = true}; }

  const Game& game() const { return game_; }
  Events& events() { return events_; }
  const Events& events() const { return events_; }

  // The approximate size of a copy, for memory limits.
  std::size_t memory_bytes() const;

  // The times of the last two packets; equal until there are two. Frames show a time between them.
  double time_s() const { return window_.end_s; }
  double previous_time_s() const { return previous_time_s_; }

  // The entities of the last packet and the static ones, interpolated at `time_s`, sorted by number. Valid
  // until the next call.
  std::span<const InterpolatedEntity> interpolate_entities(double time_s, const ClientSettings& settings);
  // The entities where the last packet put them, sorted by number, without static ones.
  void copy_latest_places(std::vector<EntityPlace>& out_places) const { entities_.copy_latest(out_places); }
  FrameBlend interpolate_weapon_frame(double time_s, const ClientSettings& settings) const;
  // Whether the last packet moved the view entity too far for a glide: a teleport.
  bool has_view_jumped() const { return entities_.has_jumped(game_.view_entity); }

 private:
  void note_death();
  struct Apply;  // one function per message type

  Game game_;
  Events events_;
  std::shared_ptr<const formats::Localization> texts_;
  std::string command_line_;  // text of an incomplete line
  double previous_time_s_ = 0;
  PacketWindow window_;
  bool has_time_ = false;  // a packet of this level had a time
  struct {
    bool is_expected = false;
    bool is_reading = false;  // the title has arrived, and only lines of the list since
    bool is_hidden = false;   // the list that is being read was expected
  } pings_;
  EntityTable entities_;
  FrameChanges weapon_;
};

}  // namespace temblor::client
