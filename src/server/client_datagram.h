// What one player is told of one tick: the time, himself, what he sees, what he hears. Told whole each time,
// so that a datagram that gets lost costs one tick and nothing more.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "server/game.h"
#include "server/sight.h"
#include "server/snapshot.h"

namespace temblor::server {

struct DatagramScratch {
  Sight sight;
  std::vector<std::uint32_t> seen;  // into Snapshot::entities
};

struct DatagramCounts {
  std::size_t entities_left_out = 0;  // seen, but no room
  bool events_left_out = false;       // sounds, particles and the like, alike
};

// What happened to this player that is told once: where he is turned to (fixangle), what hurt him (dmg_take
// and dmg_save, which are then 0 again). Written to the datagram's beginning.
void write_own_events(Game& io_game, std::size_t slot, base::ByteWriter& io_writer);
// Status bar, weapon and view.
net::ClientData client_data_of(Game& io_game, std::size_t slot);

// Appends at most `max_bytes`. Where not everything that is seen fits, the farthest is left out; what
// happened (Outbox::placed and broadcast) comes last and only as far as it fits, as in the original.
DatagramCounts write_datagram(Game& io_game, std::size_t slot, const Snapshot& snapshot,
                              std::size_t max_bytes, DatagramScratch& io_scratch,
                              base::ByteWriter& io_writer);

}  // namespace temblor::server
