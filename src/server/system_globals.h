// The globals that every Quake program begins with. Their offsets are fixed for programs with header CRC 5927
// (quake-facts.md, section 15):
//    word  0  reserved: return value and parameters       43  parm1 .. parm16, carried between levels
//         28  self, other, world, time, frametime ...     59  v_forward, v_up, v_right (makevectors)
//         35  deathmatch, coop, serverflags, totals       68  trace_* (traceline)
//                                                         82  functions that the engine calls
#pragma once

#include "base/result.h"
#include "vm/program.h"

namespace temblor::server {

namespace global {
using vm::GlobalIndex;
constexpr GlobalIndex kSelf{28}, kOther{29}, kWorld{30}, kTime{31}, kFrameTime{32}, kForceRetouch{33},
    kMapName{34}, kDeathmatch{35}, kCoop{36}, kTeamplay{37}, kServerFlags{38}, kTotalSecrets{39},
    kTotalMonsters{40}, kFoundSecrets{41}, kKilledMonsters{42};
constexpr GlobalIndex kParm1{43};  // to parm16, one after another
constexpr int kParmCount = 16;
constexpr GlobalIndex kForward{59}, kUp{62}, kRight{65};
constexpr GlobalIndex kTraceAllSolid{68}, kTraceStartSolid{69}, kTraceFraction{70}, kTraceEnd{71},
    kTracePlaneNormal{74}, kTracePlaneDistance{77}, kTraceEntity{78}, kTraceInOpen{79}, kTraceInWater{80};
constexpr GlobalIndex kMessageEntity{81};
constexpr GlobalIndex kMain{82}, kStartFrame{83}, kPlayerPreThink{84}, kPlayerPostThink{85}, kClientKill{86},
    kClientConnect{87}, kPutClientInServer{88}, kClientDisconnect{89}, kSetNewParms{90}, kSetChangeParms{91};
}  // namespace global

constexpr std::uint32_t kSystemGlobalWords = 92;

// The global of a parameter; parm1 is number 0.
constexpr vm::GlobalIndex parm(int number) {
  return vm::GlobalIndex{static_cast<std::uint32_t>(global::kParm1) + static_cast<std::uint32_t>(number)};
}

// Checks that a program's globals and fields are where this header and entity_fields.h expect them.
// kUnsupported if it was compiled with other system definitions than Quake's, or is too short to hold them.
base::Status check_system_definitions(const vm::Program& program);

}  // namespace temblor::server
