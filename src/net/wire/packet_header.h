// The 8-byte header of every packet of a connection. Only this header and that of control packets are big
// endian; all other numbers of the protocol are little endian.
//
//   byte 0        2              4                            8
//   +-------------+--------------+----------------------------+
//   | flags       | size with    | sequence number            |
//   |             | the header   |                            |
//   +-------------+--------------+----------------------------+
//   flags: 0x0001 data, 0x0002 acknowledgment, 0x0008 end of message, 0x0010 unreliable, 0x8000 control
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::net {

constexpr std::size_t kPacketHeaderBytes = 8;
// Largest value of the size field.
constexpr std::size_t kMaxPacketBytes = 0xffff;

// kData: a fragment that others follow; kLastData: the last fragment of a reliable message.
enum class PacketKind : std::uint8_t { kData, kLastData, kAck, kUnreliable };

struct PacketHeader {
  PacketKind kind{};
  // Number of the fragment or unreliable message; for an acknowledgment, of the fragment that arrived.
  std::uint32_t sequence = 0;
};

// True if the control flag is set. Control packets have a different header (net/transport/control.h).
bool is_control_packet(base::Bytes packet);

// Parses the header. Returns kMalformed with the reason if the packet is too short, its size field is wrong,
// its flags are unknown, or it is an acknowledgment with content.
base::Result<PacketHeader> read_packet_header(base::Bytes packet);

// Makes a header. `packet_bytes`: size of header and content, at most kMaxPacketBytes (CHECKed).
std::array<std::byte, kPacketHeaderBytes> packet_header_bytes(const PacketHeader& header,
                                                              std::size_t packet_bytes);

// Big-endian conversion of four bytes. read_big_endian() CHECKs that there are four.
std::uint32_t read_big_endian(base::Bytes bytes);
std::array<std::byte, 4> big_endian_bytes(std::uint32_t value);

}  // namespace temblor::net
