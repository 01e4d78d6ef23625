#include "net/wire/packet_header.h"

#include <algorithm>

#include "base/check.h"

namespace temblor::net {
namespace {

// Flags and size as one big-endian word.
constexpr std::uint32_t kData = 0x00010000, kAck = 0x00020000, kEndOfMessage = 0x00080000,
                        kUnreliable = 0x00100000, kControl = 0x80000000, kLengthMask = 0x0000ffff;

std::uint32_t find_kind_flags(PacketKind kind) {
  switch (kind) {
    case PacketKind::kData:
      return kData;
    case PacketKind::kLastData:
      return kData | kEndOfMessage;
    case PacketKind::kAck:
      return kAck;
    case PacketKind::kUnreliable:
      break;
  }
  return kUnreliable;
}

}  // namespace

std::uint32_t read_big_endian(base::Bytes bytes) {
  CHECK(bytes.size() >= 4);
  std::uint32_t value = 0;
  for (const std::byte byte : bytes.first(4)) value = value << 8 | static_cast<std::uint32_t>(byte);
  return value;
}

std::array<std::byte, 4> big_endian_bytes(std::uint32_t value) {
  return {static_cast<std::byte>(value >> 24), static_cast<std::byte>(value >> 16),
          static_cast<std::byte>(value >> 8), static_cast<std::byte>(value)};
}

bool is_control_packet(base::Bytes packet) {
  return packet.size() >= 4 && (read_big_endian(packet) & kControl) != 0;
}

// Compares all flags at once, so unknown flags and combinations that no packet has are errors.
base::Result<PacketHeader> read_packet_header(base::Bytes packet) {
  if (packet.size() < kPacketHeaderBytes)
    return base::malformed("packet of {} bytes is shorter than its header", packet.size());
  const std::uint32_t word = read_big_endian(packet);
  if ((word & kLengthMask) != packet.size())
    return base::malformed("packet of {} bytes declares a size of {}", packet.size(), word & kLengthMask);
  PacketHeader header{{}, read_big_endian(packet.subspan(4))};
  for (const PacketKind kind :
       {PacketKind::kData, PacketKind::kLastData, PacketKind::kAck, PacketKind::kUnreliable}) {
    if ((word & ~kLengthMask) != find_kind_flags(kind)) continue;
    header.kind = kind;
    if (kind == PacketKind::kAck && packet.size() != kPacketHeaderBytes)
      return base::malformed("acknowledgment with {} bytes of content", packet.size() - kPacketHeaderBytes);
    return header;
  }
  return base::malformed("packet has invalid flags {:#x}", word & ~kLengthMask);
}

std::array<std::byte, kPacketHeaderBytes> packet_header_bytes(const PacketHeader& header,
                                                              std::size_t packet_bytes) {
  CHECK(packet_bytes >= kPacketHeaderBytes && packet_bytes <= kMaxPacketBytes);
  const auto word = big_endian_bytes(find_kind_flags(header.kind) | static_cast<std::uint32_t>(packet_bytes));
  const auto sequence = big_endian_bytes(header.sequence);
  std::array<std::byte, kPacketHeaderBytes> bytes{};
  std::copy(word.begin(), word.end(), bytes.begin());
  std::copy(sequence.begin(), sequence.end(), bytes.begin() + 4);
  return bytes;
}

}  // namespace temblor::net
