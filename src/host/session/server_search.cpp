#include "host/session/server_search.h"

#include <algorithm>
#include <cmath>

#include "net/transport/control.h"

namespace temblor::host {
namespace {

constexpr double kSearchTime_s = 5;  // later replies are ignored

}  // namespace

base::Status ServerSearch::begin() {
  found_.clear();
  addresses_.clear();
  if (!services_.open_socket) return base::error(base::ErrorCode::kUsage, "no network is available");
  TRY(socket_, services_.open_socket(0));
  TRY(const base::ByteVector request, net::write_control_packet(net::ServerInfoRequest{}));
  request_s_ = services_.window.now_s();
  // A broadcast to the local network may not reach this machine, so send the request here, too.
  socket_->send(platform::ip4_address({255, 255, 255, 255}, kDefaultPort), request);
  socket_->send(platform::ip4_address({127, 0, 0, 1}, kDefaultPort), request);
  return base::Ok{};
}

bool ServerSearch::is_own(const platform::Address& address) const {
  return address.is_loopback() || (services_.is_own_host && services_.is_own_host(address));
}

// Names do not tell servers apart: most hosts never change them.
bool ServerSearch::is_known(const platform::Address& address) const {
  return std::any_of(addresses_.begin(), addresses_.end(), [&](const platform::Address& known) {
    return known == address || (known.port == address.port && is_own(known) && is_own(address));
  });
}

bool ServerSearch::update() {
  if (!socket_) return false;
  bool has_changed = false;
  while (const std::optional<platform::Datagram> datagram = socket_->receive()) {
    const double arrived_s = services_.window.now_s() - datagram->waited_s;
    const base::Result<net::ControlPacket> packet = net::read_control_packet(datagram->bytes);
    if (!packet.ok()) continue;
    const auto* const reply = std::get_if<net::ServerInfoReply>(&*packet);
    if (reply == nullptr || found_.size() >= kMaxServers || is_known(datagram->from)) continue;
    addresses_.push_back(datagram->from);
    found_.push_back(
        {.address = platform::to_text(datagram->from),
         .name = std::string(reply->host_name),
         .level = std::string(reply->map),
         .players = reply->players,
         .max_players = reply->max_players,
         .ping_ms = static_cast<int>(std::lround(std::max(arrived_s - request_s_, 0.0) * 1000))});
    has_changed = true;
  }
  if (services_.window.now_s() - request_s_ > kSearchTime_s) socket_.reset();
  return has_changed;
}

}  // namespace temblor::host
