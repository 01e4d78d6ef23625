// The datagram of one player in one tick. Each datagram is complete, so that a lost one costs one tick and
// nothing more:
//    time | damage, set angle | client data | acknowledged move | entities | events
//           (sent once)         (own state)                       (seen)     (sounds, particles; as far as
//                                                                             there is room)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "net/delta/snapshot_state.h"
#include "server/game.h"
#include "server/session/sight.h"
#include "server/session/snapshot.h"

namespace temblor::server {

// Buffers of write_datagram(), shared by all players, and the layout of the last datagram.
struct DatagramScratch {
  Sight sight;
  std::vector<std::uint32_t> seen;  // into Snapshot::entities
  // Where each part of the last written datagram begins in the writer's bytes.
  std::size_t time = 0, once = 0, client_data = 0, acknowledgment = 0, entities = 0, events = 0;
};

struct DatagramCounts {
  std::size_t entities = 0;
  std::size_t entities_left_out = 0;  // visible, but there was no room
  bool events_left_out = false;       // there was no room for a sound, particles or the like
};

// The angle to which the game turns a player (fixangle). It is sent in several datagrams: other parts of a
// lost datagram are replaced by the next one, but a player whose turn got lost in a teleporter would keep
// looking the wrong way.
struct PendingSetAngle {
  math::Vec3 angles_deg{0.0f};
  double until_s = -1;   // game time; short, because it undoes the player's own turns
  double sent_at_s = 0;  // game time, so that it is sent once while the game is paused
};

// When each entity was last sent to a player, for datagrams without room for all.
struct EntityTurns {
  std::vector<std::uint32_t> last{};  // by entity number; counts such datagrams
  std::uint32_t now = 0;
};

// Updates that the next datagrams must still bring to a player.
struct PendingUpdates {
  EntityTurns entity_turns{};
  PendingSetAngle set_angle{};
  // Events of ticks in which the player got no datagram (see keep_events()): their bytes, and where each
  // ends.
  base::ByteWriter events{};
  std::vector<std::size_t> event_ends{};
  // Acknowledges the player's moves: a console command that is a comment to stock clients. Sent once. Empty:
  // none.
  std::string acknowledgment{};
};

// The player's own state: status bar, weapon and view.
net::ClientData make_client_data(Game& io_game, std::size_t slot);

struct DatagramRequest {
  Game& game;
  std::size_t slot;
  const Snapshot& snapshot;
  std::size_t max_bytes;
  // Sees and hears instead of the player. Empty: the player's eye.
  std::optional<math::Vec3> camera_world{};
};
// Appends a datagram. Clears dmg_take, dmg_save and fixangle of the player's entity, because it sends them.
// If there is not enough room for all visible entities, some are left out: players, own missiles and what is
// near come first, and the rest takes turns. Events (kept ones,
// Outbox::placed() and broadcast()) come last, as far as there is room, as in the original.
DatagramCounts write_datagram(const DatagramRequest& request, PendingUpdates& io_pending,
                              DatagramScratch& io_scratch, base::ByteWriter& io_writer);

// Splits the last written datagram into the form that deltas compare. False: its values cannot be compared.
bool split_datagram(base::Bytes datagram, const Snapshot& snapshot, const net::Dialect& dialect,
                    const DatagramScratch& scratch, net::SnapshotState& out_state);

// Instead of a datagram: keeps this tick's events for the next one, at most `max_bytes`.
DatagramCounts keep_events(Game& io_game, std::size_t slot, std::size_t max_bytes,
                           DatagramScratch& io_scratch, PendingUpdates& io_pending);

}  // namespace temblor::server
