// All client slots, and the output to clients. Slots are numbered from 0; the player of slot n is entity n +
// 1.
// Reliable messages are queued here until the connection accepts them, one at a time:
//    queue()        ---> held (while the client loads a level) ---> queued ---> connection
//    queue_alone()  ----------------------------------------------> queued
//    send_unreliable() --------------------------------------------------------> connection
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "net/protocol/server_message.h"
#include "net/transport/server_endpoint.h"
#include "server/session/client.h"

namespace temblor::server {

class Clients {
 public:
  // A client with more than this in its queue has stopped listening, and is dropped.
  static constexpr std::size_t kMaxQueuedBytes = std::size_t{1} << 20;

  // `io_endpoint` must outlive this object.
  Clients(net::ServerEndpoint& io_endpoint, std::size_t count) : endpoint_(io_endpoint), clients_(count) {}

  std::size_t size() const { return clients_.size(); }
  // Only while all slots are free.
  void set_size(std::size_t count) { clients_ = std::vector<Client>(count); }
  Client& operator[](std::size_t slot) { return clients_[slot]; }
  const Client& operator[](std::size_t slot) const { return clients_[slot]; }
  std::span<Client> all() { return clients_; }
  std::span<const Client> all() const { return clients_; }
  // The slot of this connection. Empty: it has none (any more).
  std::optional<std::size_t> find_slot(net::ConnectionId connection) const;
  std::optional<std::size_t> find_free_slot() const;
  // Slots that are not free, including those of bots.
  std::size_t connected_count() const;

  // --- Reliable messages. Free slots and bots ignore them.

  // Whether the client has not acknowledged all of them.
  bool has_unacknowledged(std::size_t slot) const;
  // Appends to the last queued message up to the size that set_dialect() allows. Held back while the client
  // loads.
  void queue(std::size_t slot, base::Bytes bytes);
  // Queues a message that nothing else is appended to, even while the client loads.
  void queue_alone(std::size_t slot, base::ByteVector message);
  // Queues what was held back, when the client has loaded the level.
  void queue_held(std::size_t slot);
  // Forgets all messages that were not sent yet.
  void clear_queue(std::size_t slot);
  // Whether the client was sent everything that it needs to load the level, and has not asked for more yet.
  bool is_loading(std::size_t slot) const;
  // A message that the dialect cannot express is skipped.
  void send(std::size_t slot, const net::ServerMessage& message);
  void send_to_all(const net::ServerMessage& message);
  // Shows text in the client's console, in as many messages as stock clients need.
  void print(std::size_t slot, std::string_view text);
  void print_to_all(std::string_view text);
  // Sets the dialect of all messages from now on. A longer message than `max_message_bytes` is an error of
  // game code, and gives the client a `drop_reason`.
  void set_dialect(const net::Dialect& dialect, std::size_t max_message_bytes);
  const net::Dialect& dialect() const { return dialect_; }
  // Passes each connection its next message, if it is ready for one.
  void send_queued();

  // --- Demos: keeps a copy of what is queued for this client (except alone) until it is taken.
  void record_slot(std::optional<std::size_t> slot);
  base::ByteVector take_recorded() { return std::exchange(recorded_, {}); }

  // --- Snapshots.
  void send_unreliable(std::size_t slot, base::Bytes bytes);
  // Sends a snapshot reliably (sv_reliableupdates).
  void queue_snapshot(std::size_t slot, base::Bytes snapshot);
  // Whether a snapshot from queue_snapshot() has not arrived yet.
  bool has_snapshot_in_flight(std::size_t slot) const;

  // Closes the connection, showing the client `reason`, and frees the slot.
  void release(std::size_t slot, std::string_view reason);

 private:
  net::ServerEndpoint& endpoint_;
  std::vector<Client> clients_;
  net::Dialect dialect_{};
  std::size_t max_message_bytes_ = 8000;
  std::optional<std::size_t> recorded_slot_;
  base::ByteVector recorded_;
};

}  // namespace temblor::server
