#include "net/transport/disconnect_resender.h"

#include <string>
#include <utility>

#include "base/check.h"
#include "base/text.h"
#include "net/protocol/message_writer.h"

namespace temblor::net {
namespace {

constexpr std::size_t kMaxReasonBytes = 200;

base::ByteVector farewell_message(std::string_view reason) {
  base::ByteWriter writer;
  const std::string text = base::printable(reason.substr(0, kMaxReasonBytes)) + "\n";
  if (!reason.empty()) CHECK(write_message(Print{text}, Dialect{}, writer).ok());
  CHECK(write_message(Disconnect{}, Dialect{}, writer).ok());
  return std::move(writer).take();
}

}  // namespace

void DisconnectResender::say(const platform::Address& peer, Channel channel, std::string_view reason,
                             double now_s, Channel::Sink sink) {
  if (disconnect_resender_.size() >= kMost) disconnect_resender_.pop_front();
  disconnect_resender_.push_back(
      {peer, std::move(channel), farewell_message(reason), now_s + kLife_s, now_s});
  send(disconnect_resender_.back(), now_s, sink);
}

void DisconnectResender::repeat(const platform::Address& peer, double now_s, Channel::Sink sink) {
  for (Farewell& farewell : disconnect_resender_)
    if (farewell.peer == peer && now_s - farewell.said_s >= kEvery_s) send(farewell, now_s, sink);
}

void DisconnectResender::forget(const platform::Address& peer) {
  std::erase_if(disconnect_resender_, [&](const Farewell& farewell) { return farewell.peer == peer; });
}

void DisconnectResender::update(double now_s) {
  std::erase_if(disconnect_resender_, [&](const Farewell& farewell) { return now_s > farewell.until_s; });
}

void DisconnectResender::send(Farewell& io_farewell, double now_s, Channel::Sink sink) {
  io_farewell.said_s = now_s;
  const base::Status sent = io_farewell.channel.send_unreliable(io_farewell.message, sink);
  CHECK(sent.ok());
}

}  // namespace temblor::net
