// What a server knows of one player's client.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "base/bytes.h"
#include "net/delta/sent_snapshots.h"
#include "net/protocol/numbered_moves.h"
#include "net/transport/server_endpoint.h"
#include "server/session/client_datagram.h"
#include "server/session/move_queue.h"

namespace temblor::server {

enum class ClientStage {
  kFree,
  kTold,     // was told which level it is, and what files it needs; loads them
  kLoaded,   // was told how the level begins
  kSpawned,  // is in the game; was told of players and lights
  kPlaying,  // sends moves, gets updates
  kBot,      // is in the game, without a connection: the program plays it
};

// A reliable message that waits for its turn.
struct WaitingMessage {
  base::ByteVector bytes;
  bool may_grow = false;   // what comes next may be put behind it
  bool is_update = false;  // of the game's state (sv_reliableupdates)
};

struct Client {
  static constexpr const char* kNoName = "unconnected";

  ClientStage stage = ClientStage::kFree;
  net::ConnectionId connection{};
  std::string address;
  std::string name = kNoName;
  std::uint8_t colors = 0;  // shirt << 4 | pants
  SpawnParameters parameters{};
  PlayerInput input{};
  MoveQueue moves;                                            // in place of `input`, once they are numbered
  std::optional<net::MoveParameters> sent_move_parameters{};  // of this level
  // It was told that updates may be told as differences, and has said that it takes them.
  bool was_offered_deltas = false, accepts_deltas = false;
  std::optional<net::SentSnapshots> sent_snapshots{};  // once it has taken them
  std::int16_t sent_frags = 0;                         // what clients know
  double joined_at_s = 0;                              // of the server's clock
  std::deque<WaitingMessage> waiting;
  // While it loads: stock clients that read anything then give up. Sent behind the level's beginning.
  std::deque<WaitingMessage> held;
  std::size_t waiting_bytes = 0;
  bool loads_old_level = false;  // was told of one that is over before it had loaded it
  bool sent_update = false;      // what was sent last of them is one
  PendingUpdates untold{};
  double rate_credit_bytes = 0;     // of sv_maxrate; an update is sent when it is above 0
  std::array<float, 16> pings_s{};  // the last ones, in turn
  std::size_t ping_count = 0;
  double command_credit = 0;  // text commands that it may still give at once
  double credit_since_s = 0;
  std::string drop_reason;  // why it is to be dropped at the next chance; empty: it is not

  bool is_free() const { return stage == ClientStage::kFree; }
  bool is_bot() const { return stage == ClientStage::kBot; }
  bool is_in_game() const { return stage >= ClientStage::kSpawned; }

  void add_ping(float ping_s) { pings_s[ping_count++ % pings_s.size()] = ping_s; }
  // Mean of the last ones; 0 before the first.
  float ping() const;
};

}  // namespace temblor::server
