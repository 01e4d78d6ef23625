#include "net/wire/message_id.h"

#include <array>
#include <variant>

namespace temblor::net {
namespace {

// Index: message number. Null: no message has the number.
constexpr std::array<const char*, 57> kNames = {
    nullptr,
    "svc_nop",
    "svc_disconnect",
    "svc_updatestat",
    "svc_version",
    "svc_setview",
    "svc_sound",
    "svc_time",
    "svc_print",
    "svc_stufftext",
    "svc_setangle",
    "svc_serverinfo",
    "svc_lightstyle",
    "svc_updatename",
    "svc_updatefrags",
    "svc_clientdata",
    "svc_stopsound",
    "svc_updatecolors",
    "svc_particle",
    "svc_damage",
    "svc_spawnstatic",
    nullptr,
    "svc_spawnbaseline",
    "svc_temp_entity",
    "svc_setpause",
    "svc_signonnum",
    "svc_centerprint",
    "svc_killedmonster",
    "svc_foundsecret",
    "svc_spawnstaticsound",
    "svc_intermission",
    "svc_finale",
    "svc_cdtrack",
    "svc_sellscreen",
    "svc_cutscene",
    nullptr,
    nullptr,
    "svc_skybox",
    "svc_botchat",
    nullptr,
    "svc_bf",
    "svc_fog",
    "svc_spawnbaseline2",
    "svc_spawnstatic2",
    "svc_spawnstaticsound2",
    "svc_setviews",
    "svc_updateping",
    "svc_updatesocial",
    "svc_updateplinfo",
    "svc_rawprint",
    "svc_servervars",
    "svc_seq",
    "svc_achievement",
    "svc_chat",
    "svc_levelcompleted",
    "svc_backtolobby",
    "svc_localsound",
};

// In the order of the ServerMessage variant, without its last type: Ignored stores its own number.
constexpr std::array kIds = {
    MessageId::kNop,
    MessageId::kDisconnect,
    MessageId::kUpdateStat,
    MessageId::kVersion,
    MessageId::kSetView,
    MessageId::kSound,
    MessageId::kTime,
    MessageId::kPrint,
    MessageId::kStuffText,
    MessageId::kCenterPrint,
    MessageId::kSetAngle,
    MessageId::kServerInfo,
    MessageId::kLightStyle,
    MessageId::kUpdateName,
    MessageId::kUpdateFrags,
    MessageId::kUpdateColors,
    MessageId::kClientData,
    MessageId::kStopSound,
    MessageId::kParticles,
    MessageId::kDamage,
    MessageId::kSpawnStatic,
    MessageId::kSpawnBaseline,
    MessageId::kEntityUpdate,
    MessageId::kTempEntity,
    MessageId::kSetPause,
    MessageId::kSignonNumber,
    MessageId::kKilledMonster,
    MessageId::kFoundSecret,
    MessageId::kSpawnStaticSound,
    MessageId::kIntermission,
    MessageId::kSellScreen,
    MessageId::kFinale,
    MessageId::kCutScene,
    MessageId::kCdTrack,
    MessageId::kSkybox,
    MessageId::kBonusFlash,
    MessageId::kFog,
    MessageId::kBotChat,
};
static_assert(kIds.size() + 1 == std::variant_size_v<ServerMessage>);

}  // namespace

// Entity updates use half of all numbers, so they are not in the table.
const char* message_name(MessageId id) {
  if (id >= MessageId::kEntityUpdate) return "fast update";
  const auto number = static_cast<std::size_t>(id);
  return number < kNames.size() ? kNames[number] : nullptr;
}

MessageId message_id(const ServerMessage& message) {
  if (const auto* ignored = std::get_if<Ignored>(&message)) return MessageId{ignored->id};
  return kIds[message.index()];
}

}  // namespace temblor::net
