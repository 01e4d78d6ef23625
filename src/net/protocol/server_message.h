// Messages from server to client: one struct for each message of protocols 15, 666, and 999, independent of
// the protocol's encoding. message_reader.h and message_writer.h convert them from and to bytes. Texts and
// lists refer to the bytes that they were read from, and are valid as long as those.
//
// Units: coordinates in map units, velocities in units per second, angles in degrees (pitch, yaw, roll).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "math/vec.h"
#include "net/protocol/protocol.h"

namespace temblor::net {

constexpr int kMaxEntities = 32000;
constexpr int kMaxModels = 4096, kMaxSounds = 2048;  // names in a precache list
constexpr int kMaxClients = 255;
constexpr int kStats = 256;  // values in the client's status array; stock clients have 32

struct Nop {};
struct Disconnect {};  // the server ended the connection, or a demo ends
// Sets one entry of the status array.
struct UpdateStat {
  std::uint8_t stat = 0;
  std::int32_t value = 0;
};
// Protocol number; obsolete, as ServerInfo has it too.
struct Version {
  std::int32_t version = 0;
};
// The entity whose eyes the client sees through.
struct SetView {
  std::uint16_t entity = 0;
};
// Starts a sound.
struct Sound {
  std::uint8_t volume = 255;  // 0 to 255
  float attenuation = 1;      // 0 to 4; 0: heard everywhere
  std::uint16_t entity = 0;   // source
  std::uint8_t channel = 0;   // of the entity; a new sound replaces the old one, except on channel 0
  std::uint16_t sound = 0;    // number in the precache list
  math::Vec3 origin{0.0f};
};
// Server time of the messages that follow.
struct Time {
  float time_s = 0;
};
// Text for the console.
struct Print {
  std::string_view text;
};
// Text that the client executes as console commands.
struct StuffText {
  std::string_view text;
};
// Text for the middle of the screen.
struct CenterPrint {
  std::string_view text;
};
// Turns the player's view.
struct SetAngle {
  math::Vec3 angles_deg{0.0f};
};
// Starts a level. The names of the precache lists have numbers from 1.
struct ServerInfo {
  Dialect dialect{};
  std::uint8_t max_clients = 1;
  std::uint8_t game_type = 0;  // 0 co-operative, 1 deathmatch
  std::string_view level_name{};
  std::span<const std::string_view> models{}, sounds{};  // valid until the reader's next message
};
// Animates the lights of one style: brightness letters from a (dark) to z, ten per second.
struct LightStyle {
  std::uint8_t style = 0;
  std::string_view pattern;
};
struct UpdateName {
  std::uint8_t client = 0;
  std::string_view name;
};
struct UpdateFrags {
  std::uint8_t client = 0;
  std::int16_t frags = 0;
};
struct UpdateColors {
  std::uint8_t client = 0;
  std::uint8_t colors = 0;  // shirt << 4 | pants
};
// The player's own state for status bar, weapon, and view. Fields that a message omits have these defaults.
struct ClientData {
  float view_height = 22, ideal_pitch_deg = 0;  // eye height above the origin; pitch of the slope ahead
  math::Vec3 punch_deg{0.0f}, velocity{0.0f};   // units a second
  std::uint32_t items = 0;                      // bit set: weapons, ammo, armor, keys, powerups
  bool on_ground = false, in_water = false;
  std::uint16_t weapon_frame = 0, armor = 0, weapon_model = 0;
  std::int16_t health = 0;
  std::uint16_t ammo = 0, shells = 0, nails = 0, rockets = 0, cells = 0;
  std::uint8_t active_weapon = 0;
  float weapon_alpha = 1;  // 0 to 1
};
struct StopSound {
  std::uint16_t entity = 0;
  std::uint8_t channel = 0;
};
// A burst of particles.
struct Particles {
  math::Vec3 origin{0.0f}, direction{0.0f};
  std::uint16_t count = 0;  // 1024 stands for an explosion
  std::uint8_t color = 0;
};
// The player was hit: damage that the armor absorbed, and damage to the health, for the view kick and the
// flash.
struct Damage {
  std::uint8_t armor = 0, blood = 0;
  math::Vec3 from{0.0f};
};

// Initial state of an entity; updates omit fields that equal it. `alpha`: 0 to 1; `scale`: 1 is normal size.
struct Baseline {
  std::uint16_t model = 0, frame = 0;
  std::uint8_t colormap = 0, skin = 0;
  math::Vec3 origin{0.0f}, angles_deg{0.0f};
  float alpha = 1, scale = 1;
};
// An entity that never changes, such as a torch; it gets no updates and has no number.
struct SpawnStatic {
  Baseline entity;
};
// Baseline of entity `number`.
struct SpawnBaseline {
  std::uint16_t number = 0;
  Baseline entity;
};
// State of a visible entity, as its differences from the baseline (a "fast update").
struct EntityUpdate {
  std::uint16_t number = 0;
  std::optional<std::uint16_t> model{}, frame{};
  std::optional<std::uint8_t> colormap{}, skin{}, effects{};
  std::array<std::optional<float>, 3> origin{}, angles_deg{};
  std::optional<float> alpha{}, scale{};
  std::optional<float> next_think_s{};  // time from now until its next animation frame
  bool step = false;                    // moves in steps (monsters); clients interpolate it by its think time
};

// Kinds of short effects; the values are those on the wire.
enum class TempEntityKind : std::uint8_t {
  kSpike = 0,
  kSuperSpike = 1,
  kGunshot = 2,
  kExplosion = 3,
  kTarExplosion = 4,
  kLightning1 = 5,
  kLightning2 = 6,
  kWizSpike = 7,
  kKnightSpike = 8,
  kLightning3 = 9,
  kLavaSplash = 10,
  kTeleport = 11,
  kExplosion2 = 12,
  kBeam = 13
};
// An effect at a place, without an entity.
struct TempEntity {
  TempEntityKind kind{};
  math::Vec3 origin{0.0f};
  math::Vec3 end{0.0f};                           // of a beam, which starts at origin
  std::uint16_t entity = 0;                       // owner of a beam
  std::uint8_t color_start = 0, color_count = 0;  // palette range of kExplosion2
};
struct SetPause {
  bool paused = false;
};
// Progress of joining: 1 follows the server info, 2 the baselines, 3 the state of all players. The client
// answers them with the commands prespawn, spawn, and begin.
struct SignonNumber {
  std::uint8_t number = 0;
};
struct KilledMonster {};
struct FoundSecret {};
// A looping sound at a fixed place, such as wind.
struct SpawnStaticSound {
  math::Vec3 origin{0.0f};
  std::uint16_t sound = 0;
  std::uint8_t volume = 255;
  float attenuation = 1;
};
struct Intermission {};  // shows the score screen
struct SellScreen {};    // shows the order screen of the shareware game
// Text at the end of an episode.
struct Finale {
  std::string_view text;
};
// Like Finale, but during a cut scene.
struct CutScene {
  std::string_view text;
};
// Music.
struct CdTrack {
  std::uint8_t track = 0, loop_track = 0;
};
// Sky box images, by base name.
struct Skybox {
  std::string_view name;  // empty: none
};
struct BonusFlash {};  // flashes the screen after picking up an item
// Global fog.
struct Fog {
  float density = 0;       // 0 to 1
  math::Vec3 color{0.0f};  // 0 to 1
  float fade_s = 0;        // time of the transition
};
// A bot says something (2021 re-release): the first text is what it says, or the key of that text, and its
// places ({0}) take the others.
struct BotChat {
  std::uint8_t client = 0;
  std::span<const std::string_view> texts{};  // valid until the reader's next message
};
// A message of the 2021 re-release that demos may contain; skipped.
struct Ignored {
  std::uint8_t id = 0;
};

using ServerMessage =
    std::variant<Nop, Disconnect, UpdateStat, Version, SetView, Sound, Time, Print, StuffText, CenterPrint,
                 SetAngle, ServerInfo, LightStyle, UpdateName, UpdateFrags, UpdateColors, ClientData,
                 StopSound, Particles, Damage, SpawnStatic, SpawnBaseline, EntityUpdate, TempEntity, SetPause,
                 SignonNumber, KilledMonster, FoundSecret, SpawnStaticSound, Intermission, SellScreen, Finale,
                 CutScene, CdTrack, Skybox, BonusFlash, Fog, BotChat, Ignored>;

// Name for messages to people, such as "svc_time".
const char* message_name(const ServerMessage& message);

}  // namespace temblor::net
