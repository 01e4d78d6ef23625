#include "net/transport/client_endpoint.h"

#include <fmt/format.h>

#include <utility>

#include "base/check.h"
#include "base/text.h"
#include "net/transport/control.h"
#include "net/transport/send_to.h"
#include "net/wire/packet_header.h"

namespace temblor::net {
namespace {

base::ByteVector client_message_bytes(const ClientMessage& message) {
  base::ByteWriter writer;
  const base::Status status = write_client_message(message, Protocol::kNetQuake, writer);
  CHECK(status.ok());
  return std::move(writer).take();
}

base::Error not_connected() {
  return base::error(base::ErrorCode::kNotFound, "there is no connection");
}

// A server's text as one line.
std::string one_line(std::string_view text) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  return base::quotable(text, 200);
}

}  // namespace

ClientEndpoint::ClientEndpoint(std::unique_ptr<platform::DatagramSocket> socket,
                               const ClientEndpointSettings& settings)
    : socket_(std::move(socket)), settings_(settings), channel_(settings.channel) {
  CHECK(socket_ != nullptr);
}

void ClientEndpoint::connect(const platform::Address& server, double now_s) {
  disconnect();
  asked_ = server_ = server;
  state_ = State::kConnecting;
  channel_ = Channel(settings_.channel);
  heard_ = false;
  requests_ = 0;
  request(now_s);
}

void ClientEndpoint::disconnect() {
  // One of them may be lost, and nobody will ask for it again.
  constexpr int kTimes = 3;
  if (state_ == State::kConnected)
    for (int i = 0; i < kTimes; ++i) CHECK(send_unreliable(client_message_bytes(Disconnect{})).ok());
  state_ = State::kIdle;
  lost_.reset();
}

std::optional<ClientEvent> ClientEndpoint::next_event(double now_s) {
  now_s_ = now_s;
  while (true) {
    if (lost_) return std::exchange(lost_, std::nullopt);
    const std::optional<platform::Datagram> datagram = socket_->receive();
    if (!datagram) return std::nullopt;
    if (auto event = take(*datagram)) return event;
  }
}

void ClientEndpoint::update(double now_s) {
  now_s_ = now_s;
  if (state_ == State::kConnecting && now_s - requested_s_ >= settings_.request_every_s) {
    if (requests_ < settings_.requests) return request(now_s);
    return lose(fmt::format("{} does not answer", to_text(asked_)));
  }
  if (state_ != State::kConnected) return;
  if (!server_.is_local() && now_s - heard_s_ > settings_.timeout_s)
    return lose("the server has fallen silent");
  channel_.update(now_s, SendTo{*socket_, server_});
}

base::Status ClientEndpoint::send_reliable(base::Bytes message) {
  if (state_ != State::kConnected) return not_connected();
  return channel_.send_reliable(message, now_s_, SendTo{*socket_, server_});
}

base::Status ClientEndpoint::send_unreliable(base::Bytes message) {
  if (state_ != State::kConnected) return not_connected();
  return channel_.send_unreliable(message, SendTo{*socket_, server_});
}

void ClientEndpoint::set_protocol(Protocol protocol) {
  channel_.set_sent_limits(limits_of(protocol, server_.is_local()));
}

void ClientEndpoint::request(double now_s) {
  now_s_ = now_s;
  ++requests_;
  requested_s_ = now_s;
  const auto bytes = write_control_packet(ConnectRequest{});
  CHECK(bytes.ok());
  socket_->send(asked_, *bytes);
}

std::optional<ClientEvent> ClientEndpoint::take(const platform::Datagram& datagram) {
  if (state_ == State::kConnecting && datagram.from == asked_) return take_control(datagram.bytes);
  if (state_ != State::kConnected || !is_from_server(datagram.from)) return std::nullopt;
  const auto message = channel_.receive(datagram.bytes, now_s_, SendTo{*socket_, datagram.from});
  if (!message.ok()) {
    if (message.error().code == base::ErrorCode::kTooLarge) lose(message.error().what);
    return std::nullopt;  // else anybody's
  }
  server_ = datagram.from;
  heard_ = true;
  heard_s_ = now_s_;
  if (!message->has_value()) return std::nullopt;
  message_bytes_.assign((*message)->bytes.begin(), (*message)->bytes.end());
  return FromServer{message_bytes_, (*message)->reliable};
}

std::optional<ClientEvent> ClientEndpoint::take_control(base::Bytes packet) {
  const auto read = read_control_packet(packet);
  if (!read.ok()) return std::nullopt;
  if (const auto* refusal = std::get_if<RejectReply>(&*read)) lose(one_line(refusal->reason));
  const auto* accepted = std::get_if<AcceptReply>(&*read);
  if (accepted == nullptr) return std::nullopt;
  accept(accepted->port);
  return Connected{};
}

void ClientEndpoint::accept(std::int32_t port) {
  // A server that names no port means the one it was asked at.
  if (port > 0 && port <= 0xffff) server_.port = static_cast<std::uint16_t>(port);
  state_ = State::kConnected;
  heard_s_ = now_s_;
  // Opens the way back through a translation of addresses on our side, where the server's port is a new one.
  CHECK(send_unreliable(client_message_bytes(Nop{})).ok());
}

// Behind a translation of addresses a server may name a port that is not the one the world sees: until its
// first packet, the port that was asked is believed as well.
bool ClientEndpoint::is_from_server(const platform::Address& from) const {
  return from == server_ || (!heard_ && from == asked_);
}

void ClientEndpoint::lose(std::string reason) {
  disconnect();
  lost_ = ConnectionLost{std::move(reason)};
}

}  // namespace temblor::net
