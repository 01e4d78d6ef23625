// Delta-compressed snapshots between a Temblor server and a Temblor client. Each unreliable packet holds a
// complete snapshot, encoded against a reference snapshot that the client has acknowledged:
//
//   +----------+---------------+----------------------+-----------------------+
//   | 119 (u8) | number (u16)  | back (u8)            | delta (delta/delta.h) |
//   +----------+---------------+----------------------+-----------------------+
//
//   119     no stock message has this number
//   number  counts up from packet to packet, also across levels, and wraps around
//   back    reference = number - back; below kReferenceSnapshots; 0: no reference
//
// So a lost packet costs its own tick and nothing else. The reader restores the stock messages byte for byte.
// Packets of stock messages may come in between; they are not snapshots.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "net/delta/delta.h"

namespace temblor::net {

constexpr std::uint8_t kDeltaPacket = 119;       // first byte of the packet
constexpr std::size_t kReferenceSnapshots = 64;  // recent snapshots that both ends keep

// Server side: the snapshots sent to one client.
class SentSnapshots {
 public:
  // Forgets all snapshots, because a new level begins. Numbers continue.
  void reset();
  // Returns an empty snapshot for the caller to fill in.
  SnapshotState& begin_snapshot();
  // Appends the packet of the snapshot, encoded against the last acknowledged one. If the packet was sent,
  // call mark_sent(); otherwise begin_snapshot() starts again with the same number.
  void write(base::ByteWriter& io_writer);
  void mark_sent() { ++next_; }
  // The client received snapshot `number`. Ignores numbers that were not sent recently.
  void acknowledge(std::uint16_t number);

 private:
  struct Entry {
    std::optional<std::uint32_t> number;  // nullopt: unused, or not sent yet
    ReferenceSnapshot snapshot;
  };
  Entry& entry(std::uint32_t number) { return entries_[number % kReferenceSnapshots]; }

  std::vector<Entry> entries_ = std::vector<Entry>(kReferenceSnapshots);  // ring buffer
  std::uint32_t next_ = 0;
  std::optional<std::uint32_t> acknowledged_;
};

// Client side: the snapshots received from a server.
class ReceivedSnapshots {
 public:
  // Forgets all snapshots, because a new level or connection begins.
  void reset();
  // Decodes a packet and returns its stock messages, valid until the next call. Returns nullopt if the
  // reference snapshot is missing; ignore the packet then. Returns kMalformed if the packet is invalid.
  base::Result<std::optional<base::Bytes>> read(base::Bytes packet, const Dialect& dialect);
  // Number of the latest snapshot, to acknowledge it.
  std::optional<std::uint16_t> latest() const { return latest_; }

 private:
  struct Entry {
    std::optional<std::uint16_t> number;
    ReferenceSnapshot snapshot;
  };
  std::vector<Entry> entries_ = std::vector<Entry>(kReferenceSnapshots);  // ring buffer
  std::optional<std::uint16_t> latest_;
  SnapshotWriter writer_;
  base::ByteWriter bytes_;
};

inline bool is_delta_packet(base::Bytes packet) {
  return !packet.empty() && std::to_integer<std::uint8_t>(packet[0]) == kDeltaPacket;
}

}  // namespace temblor::net
