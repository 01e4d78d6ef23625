// All clients' places, and the way to them: messages wait here until the connection takes them.
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
  // Bytes that may wait for one client; more than it can need unless it has stopped listening.
  static constexpr std::size_t kMaxWaitingBytes = std::size_t{1} << 20;

  Clients(net::ServerEndpoint& io_endpoint, std::size_t count) : endpoint_(io_endpoint), clients_(count) {}

  std::size_t size() const { return clients_.size(); }
  Client& operator[](std::size_t slot) { return clients_[slot]; }
  std::span<Client> all() { return clients_; }
  std::span<const Client> all() const { return clients_; }
  std::optional<std::size_t> slot_of(net::ConnectionId connection) const;
  std::optional<std::size_t> free_slot() const;
  std::size_t connected() const;

  // Reliable; what is queued for a client that loads a level is held until queue_held(). Messages are put
  // together up to `max_message_bytes`; one that is queued alone is not, nor are later ones put behind it. A
  // client for which too much waits is doomed.
  void queue(std::size_t slot, base::Bytes bytes);
  void queue_alone(std::size_t slot, base::ByteVector message);
  // It was sent what to load, and has not asked for more.
  bool is_loading(std::size_t slot) const;
  void queue_held(std::size_t slot);
  void forget_waiting(std::size_t slot);
  void tell(std::size_t slot, const net::ServerMessage& message);
  void tell_everyone(const net::ServerMessage& message);
  void print(std::size_t slot, std::string_view text);
  void print_everyone(std::string_view text);
  // From now on; messages are written in it.
  void set_dialect(const net::Dialect& dialect, std::size_t max_message_bytes);
  const net::Dialect& dialect() const { return dialect_; }

  // Keeps what is queued for this client, but for what is queued alone, until it is taken: for recordings.
  void listen_to(std::optional<std::size_t> slot);
  base::ByteVector take_heard() { return std::exchange(heard_, {}); }

  // Gives each connection its next message if it is ready for one.
  void send_waiting();
  // An update of the game's state, reliably; has_update_under_way() until it has arrived.
  void queue_update(std::size_t slot, base::Bytes update);
  bool has_update_under_way(std::size_t slot) const;
  void send_unreliable(std::size_t slot, base::Bytes bytes);
  // Makes the place free again and lets go of the connection, with the reason for the client's eyes.
  void release(std::size_t slot, std::string_view reason);

 private:
  net::ServerEndpoint& endpoint_;
  std::vector<Client> clients_;
  net::Dialect dialect_{};
  std::size_t max_message_bytes_ = 8000;
  std::optional<std::size_t> listened_to_;
  base::ByteVector heard_;
};

}  // namespace temblor::server
