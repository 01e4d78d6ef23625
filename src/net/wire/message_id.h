// The numbers of server messages, and their names.
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
  // Of FitzQuake.
  kSkybox = 37,
  kBonusFlash = 40,
  kFog = 41,
  kSpawnBaseline2 = 42,
  kSpawnStatic2 = 43,
  kSpawnStaticSound2 = 44,
  // Of the 2021 re-release, as far as their length is known.
  kAchievement = 52,
  kLocalSound = 56,
  // This and every number above: the low seven bits are an entity update's first flags.
  kEntityUpdate = 128,
};

// "svc_time"; null for a number that is no message. Also knows the re-release's messages that cannot be read.
const char* name_of(MessageId id);

// The number that the message is written with; of those that have two (a longer form), the original's.
MessageId id_of(const ServerMessage& message);

}  // namespace temblor::net
