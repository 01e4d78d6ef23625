// The network protocols that we speak, and the options of the newest one.
//
//   15   NetQuake, the original: 8-bit angles, 16-bit coordinates in eighths of a unit
//   666  FitzQuake: adds alpha, wide model and frame numbers, fog, sky boxes
//   999  RMQ: as 666, plus flags for the encodings of coordinates and angles (wire/encoding.h)
#pragma once

#include <cstdint>

namespace temblor::net {

// The values are the numbers in svc_serverinfo.
enum class Protocol : std::int32_t { kNetQuake = 15, kFitzQuake = 666, kRmq = 999 };

// Options of kRmq, sent after the protocol number. If several coordinate or angle flags are set, the widest
// wins.
enum ProtocolFlags : std::uint32_t {
  kShortAngle = 2,
  kFloatAngle = 4,
  k24BitCoord = 8,
  kFloatCoord = 16,
  kEdictScale = 32,
  kAlphaSanity = 64,
  kInt32Coord = 128,
};
constexpr std::uint32_t kKnownProtocolFlags = 2 | 4 | 8 | 16 | 32 | 64 | 128;

// A protocol with its options: everything that determines the encoding of a message.
struct Dialect {
  Protocol protocol = Protocol::kNetQuake;
  std::uint32_t flags = 0;  // ProtocolFlags; 0 for other protocols than kRmq
  bool operator==(const Dialect&) const = default;
};

}  // namespace temblor::net
