// The eight bytes before the content of every packet of a connection: the only numbers of the game's protocol
// that are big-endian, beside the control packets'.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::net {

constexpr std::size_t kPacketHeaderBytes = 8;
// What the length's field can say.
constexpr std::size_t kMaxPacketBytes = 0xffff;

enum class PacketKind : std::uint8_t { kData, kLastData, kAck, kUnreliable };

struct PacketHeader {
  PacketKind kind{};
  std::uint32_t sequence = 0;
};

// Whether these bytes claim to be a control packet, which has a header of its own (net/transport/control.h).
bool is_control_packet(base::Bytes packet);

// kMalformed, naming what is wrong: too short, a length that is not the packet's, flags that no kind has, an
// acknowledgement with content.
base::Result<PacketHeader> read_packet_header(base::Bytes packet);

// `packet_bytes`: header and content, at most kMaxPacketBytes.
std::array<std::byte, kPacketHeaderBytes> packet_header_bytes(const PacketHeader& header,
                                                              std::size_t packet_bytes);

// Four bytes, highest first.
std::uint32_t read_big_endian(base::Bytes bytes);
std::array<std::byte, 4> big_endian_bytes(std::uint32_t value);

}  // namespace temblor::net
