#include "server/session/clients.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "net/protocol/message_writer.h"

namespace temblor::server {
namespace {

// Stock clients cannot read a longer text in one message.
constexpr std::size_t kMaxPrintChars = 1000;

}  // namespace

void CommandLimit::refill(double now_s) {
  credit = kBurst;
  since_s = now_s;
}

bool CommandLimit::take(double now_s) {
  credit = std::min(kBurst, credit + (now_s - since_s) * kPerSecond);
  since_s = now_s;
  if (credit < 1) return false;
  credit -= 1;
  return true;
}

float Client::mean_ping_s() const {
  const std::size_t count = std::min(ping_count, pings_s.size());
  if (count == 0) return 0;
  return std::accumulate(pings_s.begin(), pings_s.begin() + static_cast<std::ptrdiff_t>(count), 0.0f) /
         static_cast<float>(count);
}

// Bots are skipped: their connection number is the default, which may be somebody else's.
std::optional<std::size_t> Clients::find_slot(net::ConnectionId connection) const {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot)
    if (!clients_[slot].is_free() && !clients_[slot].is_bot() && clients_[slot].connection == connection)
      return slot;
  return std::nullopt;
}

std::optional<std::size_t> Clients::find_free_slot() const {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot)
    if (clients_[slot].is_free()) return slot;
  return std::nullopt;
}

std::size_t Clients::connected_count() const {
  return static_cast<std::size_t>(std::count_if(clients_.begin(), clients_.end(),
                                                [](const Client& client) { return !client.is_free(); }));
}

// Appends to the last message where possible: one reliable message is in flight at a time, and each takes a
// round trip, so fewer and longer ones arrive sooner.
void Clients::queue(std::size_t slot, base::Bytes bytes) {
  Client& client = clients_[slot];
  if (bytes.empty() || client.is_free() || client.is_bot()) return;
  if (slot == recorded_slot_) recorded_.insert(recorded_.end(), bytes.begin(), bytes.end());
  std::deque<QueuedMessage>& target = client.stage == ClientStage::kLoading ? client.held : client.queued;
  const bool fits_last = !target.empty() && target.back().can_grow &&
                         target.back().bytes.size() + bytes.size() <= max_message_bytes_;
  if (fits_last) {
    base::ByteVector& last = target.back().bytes;
    last.insert(last.end(), bytes.begin(), bytes.end());
  } else {
    target.push_back({base::ByteVector(bytes.begin(), bytes.end()), true});
  }
  client.queued_bytes += bytes.size();
  if (client.queued_bytes > kMaxQueuedBytes || bytes.size() > max_message_bytes_)
    client.drop_reason = "its connection is too slow for the messages that wait";
}

void Clients::queue_alone(std::size_t slot, base::ByteVector message) {
  Client& client = clients_[slot];
  if (client.is_free()) return;
  client.queued_bytes += message.size();
  client.queued.push_back({std::move(message), false});
}

bool Clients::is_loading(std::size_t slot) const {
  const Client& client = clients_[slot];
  // In this stage nothing but the level info is queued.
  return client.stage == ClientStage::kLoading && client.queued.empty();
}

bool Clients::has_unacknowledged(std::size_t slot) const {
  const Client& client = clients_[slot];
  return !client.queued.empty() || !endpoint_.can_send_reliable(client.connection);
}

void Clients::clear_queue(std::size_t slot) {
  Client& client = clients_[slot];
  client.queued.clear();
  client.held.clear();
  client.queued_bytes = 0;
}

void Clients::queue_held(std::size_t slot) {
  Client& client = clients_[slot];
  std::move(client.held.begin(), client.held.end(), std::back_inserter(client.queued));
  client.held.clear();
}

void Clients::send(std::size_t slot, const net::ServerMessage& message) {
  base::ByteWriter writer;
  if (net::write_message(message, dialect_, writer).ok()) queue(slot, writer.view());
}

void Clients::send_to_all(const net::ServerMessage& message) {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) send(slot, message);
}

void Clients::record_slot(std::optional<std::size_t> slot) {
  recorded_slot_ = slot;
  recorded_.clear();
}

// Splits the text by length only, because clients join the parts again.
void Clients::print(std::size_t slot, std::string_view text) {
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), kMaxPrintChars)))
    send(slot, net::Print{text.substr(0, kMaxPrintChars)});
}

void Clients::print_to_all(std::string_view text) {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) print(slot, text);
}

void Clients::set_dialect(const net::Dialect& dialect, std::size_t max_message_bytes) {
  dialect_ = dialect;
  max_message_bytes_ = max_message_bytes;
}

// A failed send drops the client: a reliable message must not be lost.
void Clients::send_queued() {
  for (Client& client : clients_) {
    if (client.is_free() || client.queued.empty() || !endpoint_.can_send_reliable(client.connection))
      continue;
    const QueuedMessage& next = client.queued.front();
    const base::Status sent = endpoint_.send_reliable(client.connection, next.bytes);
    if (!sent.ok()) client.drop_reason = sent.error().message();
    client.is_last_sent_snapshot = next.is_snapshot;
    client.queued_bytes -= next.bytes.size();
    client.queued.pop_front();
  }
}

void Clients::queue_snapshot(std::size_t slot, base::Bytes snapshot) {
  Client& client = clients_[slot];
  client.queued_bytes += snapshot.size();
  client.queued.push_back({base::ByteVector(snapshot.begin(), snapshot.end()), false, true});
}

// Either it waits in the queue, or it was sent and not acknowledged.
bool Clients::has_snapshot_in_flight(std::size_t slot) const {
  const Client& client = clients_[slot];
  if (client.is_last_sent_snapshot && !endpoint_.can_send_reliable(client.connection)) return true;
  return std::any_of(client.queued.begin(), client.queued.end(),
                     [](const QueuedMessage& message) { return message.is_snapshot; });
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
