// The protocols that servers speak, and how each writes numbers.
#pragma once

#include <cstdint>

namespace temblor::net {

enum class Protocol : std::int32_t { kNetQuake = 15, kFitzQuake = 666, kRmq = 999 };

// Of kRmq, sent after the protocol number; 0 for the others.
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

struct Dialect {
  Protocol protocol = Protocol::kNetQuake;
  std::uint32_t flags = 0;  // ProtocolFlags
  bool operator==(const Dialect&) const = default;
};

}  // namespace temblor::net
