// The server's data for one client slot: its progress into the level, its moves, and the messages that
// wait for its connection.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "base/bytes.h"
#include "net/delta/sent_snapshots.h"
#include "net/protocol/game_stat.h"
#include "net/protocol/numbered_moves.h"
#include "net/transport/server_endpoint.h"
#include "server/session/client_datagram.h"
#include "server/session/move_queue.h"

namespace temblor::server {

// How far a client is on its way into the level; see session/joining.cpp. The order matters: a client is in
// the game from kSpawned on.
//    kFree -> kLoading -> kPrespawned -> kSpawned -> kPlaying        (a new level: back to kLoading)
//    kFree -> kBot
enum class ClientStage {
  kFree,        // nobody uses this slot
  kLoading,     // was sent the level info, and loads the files
  kPrespawned,  // was sent the signon
  kSpawned,     // is in the game, and was sent names, frags and lights
  kPlaying,     // sends moves and gets snapshots
  kBot,         // is in the game without a connection: QuakeC plays it
};

// A reliable message that waits until the connection takes it.
struct QueuedMessage {
  base::ByteVector bytes;
  bool can_grow = false;     // the next message may be appended
  bool is_snapshot = false;  // sent reliably because of sv_reliableupdates
};

// Limits how many lines of text a client may send (a token bucket): `kBurst` at once, and `kPerSecond` in the
// long run, which is more than anybody types.
struct CommandLimit {
  static constexpr double kBurst = 60, kPerSecond = 20;
  double credit = 0;   // lines that it may still send at once
  double since_s = 0;  // when `credit` was computed

  // Grants a full burst.
  void refill(double now_s);
  // Counts one line. false: it is one too many.
  bool take(double now_s);
};

struct Client {
  static constexpr const char* kNoName = "unconnected";
  static constexpr std::size_t kMaxNameChars = 15;  // that the score boards of stock clients show

  ClientStage stage = ClientStage::kFree;
  net::ConnectionId connection{};
  std::string address;  // as text, for the host; "bot" for bots
  std::string name = kNoName;
  std::string wanted_name{};     // as the client sent it; `name` may have a number behind it
  std::uint8_t colors = 0;       // shirt << 4 | pants
  SpawnParameters parameters{};  // with which the player enters the next level
  double joined_at_s = 0;        // by the server's clock
  double loads_since_s = 0;      // when it was sent the level info
  double waits_since_s = 0;      // while it joins: since when it has all that it was sent
  std::int16_t sent_frags = 0;   // what the score boards show
  bool has_spawned = false;      // in any level since it connected
  bool loads_old_level = false;  // the level changed again before the client had loaded it
  // If not empty, drop_failed_clients() drops the client at the end of the step. Functions set it instead of
  // dropping the client, because their callers may still use the slot.
  std::string drop_reason;

  // Input.
  MoveQueue moves;
  std::optional<net::MoveParameters> sent_move_parameters{};  // in this level
  std::map<std::uint8_t, net::StatValue> sent_stats{};        // of the game's own, in this level
  std::map<std::uint8_t, float> sent_powerup_ends_s{};        // by bit of the items, in this level
  bool was_sent_combat = false;                               // the combat state, in this level
  double hunted_at_s = 0;                                     // the last tick, by the level's time
  CommandLimit commands;
  std::array<float, 16> pings_s{};  // a ring buffer
  std::size_t ping_count = 0;       // since the client joined

  // Reliable output. While the client loads a level, `held` collects what must follow the signon: stock
  // clients that read anything else before it give up.
  std::deque<QueuedMessage> queued, held;
  std::size_t queued_bytes = 0;        // in both; limited by Clients::kMaxQueuedBytes
  bool is_last_sent_snapshot = false;  // the last reliable message that was sent is a snapshot

  // Snapshots.
  PendingUpdates pending{};
  bool was_offered_deltas = false, accepts_deltas = false;
  std::optional<net::SentSnapshots> sent_snapshots{};  // if it accepts deltas
  DatagramCounts sent_counts{};                        // of the last datagram
  double rate_credit_bytes = 0;  // left of sv_maxrate; the client gets a snapshot while this is above 0

  bool is_free() const { return stage == ClientStage::kFree; }
  bool is_bot() const { return stage == ClientStage::kBot; }
  bool is_in_game() const { return stage >= ClientStage::kSpawned; }

  void add_ping(float ping_s) { pings_s[ping_count++ % pings_s.size()] = ping_s; }
  // The mean of the last pings, in seconds; 0 before the first.
  float mean_ping_s() const;
};

}  // namespace temblor::server
