// Packets of lockstep games from anybody. One that can be read can be written, and then reads as the same.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/check.h"
#include "fuzz/targets.h"
#include "lockstep/peers/packets.h"

using namespace temblor;

int temblor::fuzz::fuzz_lockstep_packet(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes = std::as_bytes(std::span(data, size));
  for (std::size_t players = 0; players <= lockstep::kMaxPlayers; ++players) {
    const std::optional<lockstep::Packet> packet = lockstep::read_packet(bytes, players);
    if (!packet) continue;
    const base::ByteVector written = lockstep::make_packet(*packet);
    // The last ticks of a long packet are left out.
    if (written.size() > lockstep::kMaxPacketBytes) continue;
    const std::optional<lockstep::Packet> again = lockstep::read_packet(written, players);
    CHECK(again && lockstep::make_packet(*again) == written, "a packet of kind {} changes", packet->index());
  }
  return 0;
}
