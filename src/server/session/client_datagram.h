// What one player is told of one tick: the time, himself, what he sees, what he hears. Told whole each time,
// so that a datagram that gets lost costs one tick and nothing more.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "net/delta/snapshot_state.h"
#include "server/game.h"
#include "server/session/sight.h"
#include "server/session/snapshot.h"

namespace temblor::server {

struct DatagramScratch {
  Sight sight;
  std::vector<std::uint32_t> seen;  // into Snapshot::entities
  // Of the datagram that was written last: where each part begins in the writer's bytes, in this order.
  std::size_t time = 0, once = 0, client_data = 0, acknowledgement = 0, entities = 0, events = 0;
};

struct DatagramCounts {
  std::size_t entities_left_out = 0;  // seen, but no room
  bool events_left_out = false;       // sounds, particles and the like, alike
};

// Where a player is turned to by the game (fixangle). Told in several datagrams: nothing else of a datagram
// is missed for long when it is lost, but who went through a teleporter would go on looking at its wall.
struct TurnToTell {
  math::Vec3 angles_deg{0.0f};
  double until_s = -1;  // of the game's time; soon over, or who turns meanwhile would be turned back
  double told_at_s = 0;
};

// What a player has still to be told in the next datagrams.
struct PendingUpdates {
  TurnToTell turn{};
  // Of ticks of which he got no datagram, see keep_events(): bytes, and where each event ends.
  base::ByteWriter events{};
  std::vector<std::size_t> event_ends{};
  // Of the player's moves: a line for his console that is comment to stock ones; empty: none. Told once.
  std::string acknowledgement{};
};

// Status bar, weapon and view.
net::ClientData client_data_of(Game& io_game, std::size_t slot);

// Appends at most `max_bytes`. Told once is what hurt the player (dmg_take and dmg_save, which are then 0
// again), and a turn in the datagrams of the next moment: it is set from fixangle, which is then 0 again.
// Where not everything that is seen fits, the farthest is left out; what happened (kept events,
// Outbox::placed and broadcast) comes last and only as far as it fits, as in the original.
DatagramCounts write_datagram(Game& io_game, std::size_t slot, const Snapshot& snapshot,
                              std::size_t max_bytes, PendingUpdates& io_pending, DatagramScratch& io_scratch,
                              base::ByteWriter& io_writer);

// The datagram that was just written to `datagram`, and nothing else, taken apart. False: it holds what
// cannot be.
bool take_datagram_apart(base::Bytes datagram, const Snapshot& snapshot, const net::Dialect& dialect,
                         const DatagramScratch& scratch, net::SnapshotState& out_state);

// Instead of a datagram: what happened this tick, for the next one. At most `max_bytes` are kept.
DatagramCounts keep_events(Game& io_game, std::size_t slot, std::size_t max_bytes,
                           DatagramScratch& io_scratch, PendingUpdates& io_pending);

}  // namespace temblor::server
