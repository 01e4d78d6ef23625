#include "server/session/clients.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "net/protocol/message_writer.h"

namespace temblor::server {
namespace {

// Stock clients read no longer text in one message.
constexpr std::size_t kMaxPrintChars = 1000;

}  // namespace

float Client::ping() const {
  const std::size_t count = std::min(ping_count, pings_s.size());
  if (count == 0) return 0;
  return std::accumulate(pings_s.begin(), pings_s.begin() + static_cast<std::ptrdiff_t>(count), 0.0f) /
         static_cast<float>(count);
}

std::optional<std::size_t> Clients::slot_of(net::ConnectionId connection) const {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot)
    if (!clients_[slot].is_free() && !clients_[slot].is_bot() && clients_[slot].connection == connection)
      return slot;
  return std::nullopt;
}

std::optional<std::size_t> Clients::free_slot() const {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot)
    if (clients_[slot].is_free()) return slot;
  return std::nullopt;
}

std::size_t Clients::connected() const {
  return static_cast<std::size_t>(std::count_if(clients_.begin(), clients_.end(),
                                                [](const Client& client) { return !client.is_free(); }));
}

void Clients::queue(std::size_t slot, base::Bytes bytes) {
  Client& client = clients_[slot];
  if (bytes.empty() || client.is_free() || client.is_bot()) return;
  if (slot == listened_to_) heard_.insert(heard_.end(), bytes.begin(), bytes.end());
  std::deque<WaitingMessage>& line = client.stage == ClientStage::kTold ? client.held : client.waiting;
  const bool joins =
      !line.empty() && line.back().may_grow && line.back().bytes.size() + bytes.size() <= max_message_bytes_;
  if (joins) {
    base::ByteVector& last = line.back().bytes;
    last.insert(last.end(), bytes.begin(), bytes.end());
  } else {
    line.push_back({base::ByteVector(bytes.begin(), bytes.end()), true});
  }
  client.waiting_bytes += bytes.size();
  if (client.waiting_bytes > kMaxWaitingBytes || bytes.size() > max_message_bytes_)
    client.drop_reason = "more waits to be told than the connection takes";
}

void Clients::queue_alone(std::size_t slot, base::ByteVector message) {
  Client& client = clients_[slot];
  if (client.is_free()) return;
  client.waiting_bytes += message.size();
  client.waiting.push_back({std::move(message), false});
}

bool Clients::is_loading(std::size_t slot) const {
  const Client& client = clients_[slot];
  // While it does not listen, nothing else waits than the level that it is to load.
  return client.stage == ClientStage::kTold && client.waiting.empty();
}

void Clients::forget_waiting(std::size_t slot) {
  Client& client = clients_[slot];
  client.waiting.clear();
  client.held.clear();
  client.waiting_bytes = 0;
}

void Clients::queue_held(std::size_t slot) {
  Client& client = clients_[slot];
  std::move(client.held.begin(), client.held.end(), std::back_inserter(client.waiting));
  client.held.clear();
}

void Clients::tell(std::size_t slot, const net::ServerMessage& message) {
  base::ByteWriter writer;
  // What the dialect cannot say is not said.
  if (net::write_message(message, dialect_, writer).ok()) queue(slot, writer.view());
}

void Clients::tell_everyone(const net::ServerMessage& message) {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) tell(slot, message);
}

void Clients::listen_to(std::optional<std::size_t> slot) {
  listened_to_ = slot;
  heard_.clear();
}

void Clients::print(std::size_t slot, std::string_view text) {
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), kMaxPrintChars)))
    tell(slot, net::Print{text.substr(0, kMaxPrintChars)});
}

void Clients::print_everyone(std::string_view text) {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) print(slot, text);
}

void Clients::set_dialect(const net::Dialect& dialect, std::size_t max_message_bytes) {
  dialect_ = dialect;
  max_message_bytes_ = max_message_bytes;
}

void Clients::send_waiting() {
  for (Client& client : clients_) {
    if (client.is_free() || client.waiting.empty() || !endpoint_.can_send_reliable(client.connection))
      continue;
    const WaitingMessage& next = client.waiting.front();
    const base::Status sent = endpoint_.send_reliable(client.connection, next.bytes);
    if (!sent.ok()) client.drop_reason = sent.error().message();
    client.sent_update = next.is_update;
    client.waiting_bytes -= next.bytes.size();
    client.waiting.pop_front();
  }
}

void Clients::queue_update(std::size_t slot, base::Bytes update) {
  Client& client = clients_[slot];
  client.waiting_bytes += update.size();
  client.waiting.push_back({base::ByteVector(update.begin(), update.end()), false, true});
}

bool Clients::has_update_under_way(std::size_t slot) const {
  const Client& client = clients_[slot];
  if (client.sent_update && !endpoint_.can_send_reliable(client.connection)) return true;
  return std::any_of(client.waiting.begin(), client.waiting.end(),
                     [](const WaitingMessage& message) { return message.is_update; });
}

void Clients::send_unreliable(std::size_t slot, base::Bytes bytes) {
  const base::Status sent = endpoint_.send_unreliable(clients_[slot].connection, bytes);
  if (!sent.ok()) clients_[slot].drop_reason = sent.error().message();
}

void Clients::release(std::size_t slot, std::string_view reason) {
  if (!clients_[slot].is_bot()) endpoint_.disconnect(clients_[slot].connection, reason);
  clients_[slot] = Client{};
}

}  // namespace temblor::server
