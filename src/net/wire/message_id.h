// Numbers and names of server messages (svc_*). The first byte of a message is its number.
#pragma once

#include <cstdint>

#include "net/protocol/server_message.h"

namespace temblor::net {

enum class MessageId : std::uint8_t {
  kNop = 1,
  kDisconnect = 2,
  kUpdateStat = 3,
  kVersion = 4,
  kSetView = 5,
  kSound = 6,
  kTime = 7,
  kPrint = 8,
  kStuffText = 9,
  kSetAngle = 10,
  kServerInfo = 11,
  kLightStyle = 12,
  kUpdateName = 13,
  kUpdateFrags = 14,
  kClientData = 15,
  kStopSound = 16,
  kUpdateColors = 17,
  kParticles = 18,
  kDamage = 19,
  kSpawnStatic = 20,
  kSpawnBaseline = 22,
  kTempEntity = 23,
  kSetPause = 24,
  kSignonNumber = 25,
  kCenterPrint = 26,
  kKilledMonster = 27,
  kFoundSecret = 28,
  kSpawnStaticSound = 29,
  kIntermission = 30,
  kFinale = 31,
  kCdTrack = 32,
  kSellScreen = 33,
  kCutScene = 34,
  // FitzQuake.
  kSkybox = 37,
  kBonusFlash = 40,
  kFog = 41,
  kSpawnBaseline2 = 42,
  kSpawnStatic2 = 43,
  kSpawnStaticSound2 = 44,
  // 2021 re-release; only the messages whose length is known.
  kBotChat = 38,
  kAchievement = 52,
  kLevelCompleted = 54,
  kBackToLobby = 55,
  kLocalSound = 56,
  // 128 to 255: an entity update, whose low seven bits are flags.
  kEntityUpdate = 128,
};

// Returns a name such as "svc_time", or null for an unknown number. Includes messages of the re-release that
// we cannot read.
const char* message_name(MessageId id);

// Returns the number of a message. For messages with an original and an extended form, the original's.
MessageId message_id(const ServerMessage& message);

}  // namespace temblor::net
