#include "net/transport/disconnect_resender.h"

#include <string>
#include <utility>

#include "base/check.h"
#include "base/text.h"
#include "net/protocol/message_writer.h"

namespace temblor::net {
namespace {

constexpr std::size_t kMaxReasonBytes = 200;

// The client shows the reason as one line, so a line end would become a visible character.
base::ByteVector make_disconnect_message(std::string_view reason) {
  while (reason.ends_with('\n')) reason.remove_suffix(1);
  base::ByteWriter writer;
  const std::string text = base::printable(reason.substr(0, kMaxReasonBytes)) + "\n";
  if (!reason.empty()) CHECK(write_message(Print{text}, Dialect{}, writer).ok());
  CHECK(write_message(Disconnect{}, Dialect{}, writer).ok());
  return std::move(writer).take();
}

}  // namespace

void DisconnectResender::send(const platform::Address& peer, Channel channel, std::string_view reason,
                              double now_s, Channel::Sink sink) {
  if (entries_.size() >= kMaxEntries) entries_.pop_front();
  entries_.push_back({peer, std::move(channel), make_disconnect_message(reason), now_s + kLifetime_s, now_s});
  send_entry(entries_.back(), now_s, sink);
}

void DisconnectResender::resend(const platform::Address& peer, double now_s, Channel::Sink sink) {
  for (Entry& entry : entries_)
    if (entry.peer == peer && now_s - entry.last_sent_s >= kMinInterval_s) send_entry(entry, now_s, sink);
}

void DisconnectResender::forget(const platform::Address& peer) {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.peer == peer; });
}

void DisconnectResender::update(double now_s) {
  std::erase_if(entries_, [&](const Entry& entry) { return now_s > entry.expires_s; });
}

void DisconnectResender::send_entry(Entry& io_entry, double now_s, Channel::Sink sink) {
  io_entry.last_sent_s = now_s;
  // Unreliable: the reliable stream may be blocked by a fragment that the peer never acknowledges.
  const base::Status sent = io_entry.channel.send_unreliable(io_entry.message, sink);
  CHECK(sent.ok());
}

}  // namespace temblor::net
