// Control packets: connection requests and server queries, which travel outside of connections. This file
// describes both directions; texts refer to the bytes that they were read from.
//
//   +-----------------------------+------------+--------------------------------+
//   | 0x80000000 | size  u32 BE   | command u8 | fields: u8, i32 LE, text + '\0' |
//   +-----------------------------+------------+--------------------------------+
//
// Requests have the commands 0x01 to 0x05, replies 0x81 to 0x86. The packets are those of NetQuake; the
// remote command uses the numbers that other engines chose for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::net {

// Version of the packet layer, the same for all NetQuake games.
constexpr std::uint8_t kNetProtocol = 3;
// Largest packet that we write; packets that we read may be larger.
constexpr std::size_t kMaxControlBytes = 1400;

struct ConnectRequest {
  std::uint8_t net_protocol = kNetProtocol;
};
struct ServerInfoRequest {
  std::uint8_t net_protocol = kNetProtocol;
};
struct PlayerInfoRequest {
  std::uint8_t player = 0;  // index among the connected players, from 0
};
struct RuleInfoRequest {
  std::string_view previous;  // asks for the rule after this one; empty: the first rule
};
// A console line for the server; runs only with the right password.
struct RemoteCommandRequest {
  std::string_view password, command;
};
struct AcceptReply {
  std::int32_t port = 0;  // port for this connection
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
  std::string_view rule, value;  // both empty: end of the list
};
struct RemoteCommandReply {
  std::string_view text;
};

using ControlPacket = std::variant<ConnectRequest, ServerInfoRequest, PlayerInfoRequest, RuleInfoRequest,
                                   RemoteCommandRequest, AcceptReply, RejectReply, ServerInfoReply,
                                   PlayerInfoReply, RuleInfoReply, RemoteCommandReply>;

// Name for messages to people, such as "CCREQ_CONNECT".
const char* packet_name(const ControlPacket& packet);

// Parses a packet. Ignores extra bytes at the end, because other engines append fields of their own. Errors
// name the packet and the field: kUnsupported for an unknown command and for a game other than "QUAKE",
// otherwise kMalformed.
base::Result<ControlPacket> read_control_packet(base::Bytes packet);

// Makes a packet with its header. Returns kTooLarge if a text contains a zero byte or the packet exceeds
// kMaxControlBytes.
base::Result<base::ByteVector> write_control_packet(const ControlPacket& packet);

}  // namespace temblor::net
