// Control packets: what is said outside of connections. Requests to connect and queries go to a server, the
// answers back. Both directions; texts refer to the bytes that they were read from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::net {

// The version of the packets themselves, which all NetQuake games share.
constexpr std::uint8_t kNetProtocol = 3;
// None of ours is longer; what comes may be.
constexpr std::size_t kMaxControlBytes = 1400;

struct ConnectRequest {
  std::uint8_t net_protocol = kNetProtocol;
};
struct ServerInfoRequest {
  std::uint8_t net_protocol = kNetProtocol;
};
struct PlayerInfoRequest {
  std::uint8_t player = 0;  // counting those who play, from 0
};
struct RuleInfoRequest {
  std::string_view previous;  // the next rule is asked for; empty: the first
};
// A line for a server's console from somebody who knows its password.
struct RemoteCommandRequest {
  std::string_view password, command;
};
struct AcceptReply {
  std::int32_t port = 0;  // where the server listens to this client
};
struct RejectReply {
  std::string_view reason;
};
struct ServerInfoReply {
  std::string_view address, host_name, map;
  std::uint8_t players = 0, max_players = 0, net_protocol = kNetProtocol;
};
struct PlayerInfoReply {
  std::uint8_t player = 0;
  std::string_view name;
  std::int32_t colors = 0;  // shirt << 4 | pants
  std::int32_t frags = 0, connected_s = 0;
  std::string_view address;
};
struct RuleInfoReply {
  std::string_view rule, value;  // both empty: there are no more
};
struct RemoteCommandReply {
  std::string_view text;
};

using ControlPacket = std::variant<ConnectRequest, ServerInfoRequest, PlayerInfoRequest, RuleInfoRequest,
                                   RemoteCommandRequest, AcceptReply, RejectReply, ServerInfoReply,
                                   PlayerInfoReply, RuleInfoReply, RemoteCommandReply>;

// "CCREQ_CONNECT".
const char* name_of(const ControlPacket& packet);

// Bytes behind what is known are passed over: other engines append words of their own. Errors name the packet
// and what is wrong: kUnsupported for a command that is not known and for another game than "QUAKE", else
// kMalformed.
base::Result<ControlPacket> read_control_packet(base::Bytes packet);

// A whole packet with its header. kTooLarge for a text with a zero in it and for more than kMaxControlBytes.
base::Result<base::ByteVector> write_control_packet(const ControlPacket& packet);

}  // namespace temblor::net
