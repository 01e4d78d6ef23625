// What a server tells a client: one struct for each message of protocols 15, 666 and 999, in the same terms
// for all three. Text and lists refer to the bytes that they were read from.
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
constexpr int kStats = 32;

struct Nop {};
struct Disconnect {};
struct UpdateStat {
  std::uint8_t stat = 0;
  std::int32_t value = 0;
};
struct Version {
  std::int32_t version = 0;
};
struct SetView {
  std::uint16_t entity = 0;
};
struct Sound {
  std::uint8_t volume = 255;  // 0 to 255
  float attenuation = 1;      // 0 to 4
  std::uint16_t entity = 0;
  std::uint8_t channel = 0;
  std::uint16_t sound = 0;
  math::Vec3 origin{0.0f};
};
struct Time {
  float time_s = 0;
};
struct Print {
  std::string_view text;
};
struct StuffText {
  std::string_view text;
};
struct CenterPrint {
  std::string_view text;
};
struct SetAngle {
  math::Vec3 angles_deg{0.0f};
};
// Precache lists: numbers start at 1.
struct ServerInfo {
  Dialect dialect{};
  std::uint8_t max_clients = 1;
  std::uint8_t game_type = 0;  // 0 co-operative, 1 deathmatch
  std::string_view level_name{};
  std::span<const std::string_view> models{}, sounds{};  // valid until the reader's next message
};
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
// Everything that is not there is 0 but for view_height.
struct ClientData {
  float view_height = 22, ideal_pitch_deg = 0;
  math::Vec3 punch_deg{0.0f}, velocity{0.0f};  // units a second
  std::uint32_t items = 0;
  bool on_ground = false, in_water = false;
  std::uint16_t weapon_frame = 0, armor = 0, weapon_model = 0;
  std::int16_t health = 0;
  std::uint16_t ammo = 0, shells = 0, nails = 0, rockets = 0, cells = 0;
  std::uint8_t active_weapon = 0;
  float weapon_alpha = 1;
};
struct StopSound {
  std::uint16_t entity = 0;
  std::uint8_t channel = 0;
};
struct Particles {
  math::Vec3 origin{0.0f}, direction{0.0f};
  std::uint16_t count = 0;  // 1024: an explosion
  std::uint8_t color = 0;
};
struct Damage {
  std::uint8_t armor = 0, blood = 0;
  math::Vec3 from{0.0f};
};

// An entity as it begins. `alpha` 0 to 1, `scale` 1: as it is.
struct Baseline {
  std::uint16_t model = 0, frame = 0;
  std::uint8_t colormap = 0, skin = 0;
  math::Vec3 origin{0.0f}, angles_deg{0.0f};
  float alpha = 1, scale = 1;
};
struct SpawnStatic {
  Baseline entity;
};
struct SpawnBaseline {
  std::uint16_t number = 0;
  Baseline entity;
};
// What of an entity differs from its baseline.
struct EntityUpdate {
  std::uint16_t number = 0;
  std::optional<std::uint16_t> model{}, frame{};
  std::optional<std::uint8_t> colormap{}, skin{}, effects{};
  std::array<std::optional<float>, 3> origin{}, angles_deg{};
  std::optional<float> alpha{}, scale{};
  std::optional<float> next_think_s{};  // until its next frame, from now
  bool step = false;                    // moves by steps: not to be interpolated as a flight is
};

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
struct TempEntity {
  TempEntityKind kind{};
  math::Vec3 origin{0.0f};
  math::Vec3 end{0.0f};                           // beams: from origin to end
  std::uint16_t entity = 0;                       // beams: whose
  std::uint8_t color_start = 0, color_count = 0;  // kExplosion2
};
struct SetPause {
  bool paused = false;
};
struct SignonNumber {
  std::uint8_t number = 0;
};
struct KilledMonster {};
struct FoundSecret {};
struct SpawnStaticSound {
  math::Vec3 origin{0.0f};
  std::uint16_t sound = 0;
  std::uint8_t volume = 255;
  float attenuation = 1;
};
struct Intermission {};
struct SellScreen {};
struct Finale {
  std::string_view text;
};
struct CutScene {
  std::string_view text;
};
struct CdTrack {
  std::uint8_t track = 0, loop_track = 0;
};
struct Skybox {
  std::string_view name;  // empty: none
};
struct BonusFlash {};
struct Fog {
  float density = 0;       // 0 to 1
  math::Vec3 color{0.0f};  // 0 to 1
  float fade_s = 0;
};
// A message of the 2021 re-release that a recording may hold: read over.
struct Ignored {
  std::uint8_t id = 0;
};

using ServerMessage =
    std::variant<Nop, Disconnect, UpdateStat, Version, SetView, Sound, Time, Print, StuffText, CenterPrint,
                 SetAngle, ServerInfo, LightStyle, UpdateName, UpdateFrags, UpdateColors, ClientData,
                 StopSound, Particles, Damage, SpawnStatic, SpawnBaseline, EntityUpdate, TempEntity, SetPause,
                 SignonNumber, KilledMonster, FoundSecret, SpawnStaticSound, Intermission, SellScreen, Finale,
                 CutScene, CdTrack, Skybox, BonusFlash, Fog, Ignored>;

// The name of the kind of message, as in "svc_time".
const char* name_of(const ServerMessage& message);

}  // namespace temblor::net
