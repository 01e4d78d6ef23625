// Updates of the game between a server and a client of ours, told as differences to one that the client has
// said it has: a packet that begins with a byte which is no message's, then
//   u16  the update's number; they count up, and go on through levels
//   u8   how far back the update is that it is told against, at most kReferenceSnapshots - 1; 0: against
//   nothing
//   ...  the difference (net/delta/delta.h)
// So every packet tells all that matters, and one that is lost costs its own tick and nothing more. Who reads
// it gets the stock messages back, byte for byte. Packets of stock messages may come in between: they belong
// to no update.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "net/delta/delta.h"

namespace temblor::net {

constexpr std::uint8_t kDeltaPacket = 119;  // its first byte
constexpr std::size_t kReferenceSnapshots = 64;

// A server's, of one client.
class SentSnapshots {
 public:
  // What was told belongs to a level that is over.
  void forget();
  // The next one, to be filled in; empty.
  SnapshotState& next();
  // Appends its packet, against the last one that the client has. It may still be left untold: then next()
  // begins it anew; else tell() it.
  void write(base::ByteWriter& io_writer);
  void tell() { ++next_; }
  // The client has that one. Numbers that were not told lately are passed over.
  void acknowledge(std::uint16_t number);

 private:
  struct Told {
    std::optional<std::uint32_t> number;
    ReferenceSnapshot update;
  };
  Told& at(std::uint32_t number) { return kept_[number % kReferenceSnapshots]; }

  std::vector<Told> kept_ = std::vector<Told>(kReferenceSnapshots);
  std::uint32_t next_ = 0;
  std::optional<std::uint32_t> acknowledged_;
};

// A client's.
class ReceivedSnapshots {
 public:
  void forget();
  // The stock messages of a packet, valid until the next call; nothing for one told against an update that is
  // not here, which is to be passed over. kMalformed for what is no such packet.
  base::Result<std::optional<base::Bytes>> read(base::Bytes packet, const Dialect& dialect);
  // To be acknowledged.
  std::optional<std::uint16_t> latest() const { return latest_; }

 private:
  struct Known {
    std::optional<std::uint16_t> number;
    ReferenceSnapshot update;
  };
  std::vector<Known> kept_ = std::vector<Known>(kReferenceSnapshots);
  std::optional<std::uint16_t> latest_;
  UpdateWriter writer_;
  base::ByteWriter bytes_;
};

inline bool is_delta_packet(base::Bytes packet) {
  return !packet.empty() && std::to_integer<std::uint8_t>(packet[0]) == kDeltaPacket;
}

}  // namespace temblor::net
