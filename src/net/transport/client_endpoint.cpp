#include "net/transport/client_endpoint.h"

#include <fmt/format.h>

#include <utility>

#include "base/check.h"
#include "base/text.h"
#include "net/transport/control.h"
#include "net/transport/quakeworld.h"
#include "net/transport/send_to.h"
#include "net/wire/packet_header.h"

namespace temblor::net {
namespace {

base::ByteVector make_client_message_bytes(const ClientMessage& message) {
  base::ByteWriter writer;
  const base::Status status = write_client_message(message, Protocol::kNetQuake, writer);
  CHECK(status.ok());
  return std::move(writer).take();
}

base::Error make_not_connected_error() {
  return base::error(base::ErrorCode::kNotFound, "not connected");
}

// Makes a server's text printable, as one line of at most 200 characters.
std::string make_one_line(std::string_view text) {
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
  requested_server_ = server_ = server;
  state_ = State::kConnecting;
  channel_ = Channel(settings_.channel);
  has_received_ = false;
  is_darkplaces_ = false;
  requests_ = 0;
  request(now_s);
}

void ClientEndpoint::disconnect() {
  // Packets may be lost, and nothing repeats this one after we have left.
  constexpr int kCopies = 3;
  if (state_ == State::kConnected)
    for (int i = 0; i < kCopies; ++i) CHECK(send_unreliable(make_client_message_bytes(Disconnect{})).ok());
  state_ = State::kIdle;
  lost_.reset();
}

std::optional<ClientEvent> ClientEndpoint::next_event(double now_s) {
  now_s_ = now_s;
  while (true) {
    if (lost_) return std::exchange(lost_, std::nullopt);
    const std::optional<platform::Datagram> datagram = socket_->receive();
    if (!datagram) return std::nullopt;
    if (auto event = handle_datagram(*datagram)) return event;
  }
}

void ClientEndpoint::update(double now_s) {
  now_s_ = now_s;
  if (state_ == State::kConnecting && now_s - requested_s_ >= settings_.request_every_s) {
    if (requests_ < settings_.requests) return request(now_s);
    return drop(is_darkplaces_
                    ? fmt::format("{} is a DarkPlaces server with a protocol of its own; its host can set "
                                  "sv_protocolname to QUAKE",
                                  to_text(requested_server_))
                    : fmt::format("No response from {}.", to_text(requested_server_)));
  }
  if (state_ != State::kConnected) return;
  if (!server_.is_local() && now_s - last_received_s_ > settings_.timeout_s)
    return drop("the server stopped responding");
  channel_.update(now_s, SendTo{*socket_, server_});
}

std::optional<ServerSilence> ClientEndpoint::silence() const {
  if (state_ != State::kConnected || server_.is_local()) return std::nullopt;
  const double lasts_s = now_s_ - last_received_s_;
  return ServerSilence{lasts_s, settings_.timeout_s - lasts_s};
}

base::Status ClientEndpoint::send_reliable(base::Bytes message) {
  if (state_ != State::kConnected) return make_not_connected_error();
  return channel_.send_reliable(message, now_s_, SendTo{*socket_, server_});
}

base::Status ClientEndpoint::send_unreliable(base::Bytes message) {
  if (state_ != State::kConnected) return make_not_connected_error();
  return channel_.send_unreliable(message, SendTo{*socket_, server_});
}

void ClientEndpoint::set_protocol(Protocol protocol) {
  channel_.set_sent_limits(message_limits_for(protocol, find_peer_place(server_)));
}

void ClientEndpoint::request(double now_s) {
  now_s_ = now_s;
  ++requests_;
  requested_s_ = now_s;
  const auto bytes = write_control_packet(ConnectRequest{});
  CHECK(bytes.ok());
  socket_->send(requested_server_, *bytes);
  // Servers with other protocols ignore that; ask a silent server whether it is one of them.
  if (requests_ == 1) return;
  socket_->send(requested_server_, make_quakeworld_status_request());
  socket_->send(requested_server_, make_darkplaces_status_request());
}

std::optional<ClientEvent> ClientEndpoint::handle_datagram(const platform::Datagram& datagram) {
  if (state_ == State::kConnecting && datagram.from == requested_server_)
    return handle_control(datagram.bytes);
  if (state_ != State::kConnected || !is_from_server(datagram.from)) return std::nullopt;
  const auto message = channel_.receive(datagram.bytes, now_s_, SendTo{*socket_, datagram.from});
  if (!message.ok()) {
    if (message.error().code == base::ErrorCode::kTooLarge) drop(message.error().what);
    return std::nullopt;  // anybody may have forged a malformed packet: ignore it
  }
  // From now on only the port that the server really sends from counts.
  server_ = datagram.from;
  has_received_ = true;
  last_received_s_ = now_s_;
  if (!message->has_value()) return std::nullopt;
  message_bytes_.assign((*message)->bytes.begin(), (*message)->bytes.end());
  return FromServer{message_bytes_, (*message)->reliable};
}

std::optional<ClientEvent> ClientEndpoint::handle_control(base::Bytes packet) {
  if (is_quakeworld_status(packet)) {
    drop(fmt::format("{} is a QuakeWorld server. Temblor plays on Quake servers (NetQuake) only.",
                     to_text(requested_server_)));
    return std::nullopt;
  }
  if (is_darkplaces_status(packet)) is_darkplaces_ = true;
  const auto read = read_control_packet(packet);
  if (!read.ok()) return std::nullopt;
  if (const auto* rejected = std::get_if<RejectReply>(&*read)) drop(make_one_line(rejected->reason));
  const auto* accepted = std::get_if<AcceptReply>(&*read);
  if (accepted == nullptr) return std::nullopt;
  accept(accepted->port);
  return Connected{};
}

void ClientEndpoint::accept(std::int32_t port) {
  // Without a valid port, the server keeps the port that received the request.
  if (port > 0 && port <= 0xffff) server_.port = static_cast<std::uint16_t>(port);
  state_ = State::kConnected;
  last_received_s_ = now_s_;
  // Lets packets from a new server port pass our NAT.
  CHECK(send_unreliable(make_client_message_bytes(Nop{})).ok());
}

// A server behind NAT may announce a port that differs from its public one. Until its first packet arrives,
// we also accept packets from the port that received the request.
bool ClientEndpoint::is_from_server(const platform::Address& from) const {
  return from == server_ || (!has_received_ && from == requested_server_);
}

void ClientEndpoint::drop(std::string reason) {
  disconnect();
  lost_ = ConnectionLost{std::move(reason)};
}

}  // namespace temblor::net
