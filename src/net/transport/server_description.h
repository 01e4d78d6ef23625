// The public description of a server (name, map, players, rules) and the replies to queries for it, as server
// browsers such as `quakestat -qs -P -R` send them. Depends on the control packets only; the server fills in
// a ServerDescription on demand.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "net/transport/control.h"

namespace temblor::net {

// A connected player.
struct PlayerDescription {
  std::string name;
  int colors = 0;  // shirt << 4 | pants
  int frags = 0;
  double connected_s = 0;
  std::string address;  // what the public may see; a server may mask it
};
// A public console variable.
struct RuleDescription {
  std::string name, value;
};
struct ServerDescription {
  std::string host_name, map;
  int max_players = 0;
  std::vector<PlayerDescription> players;
  std::vector<RuleDescription> rules;
};

// True for requests of server, player, and rule info.
bool is_query(const ControlPacket& packet);

// Makes the reply to a query. Its texts refer to `server` and `own_address` (the server's address as text),
// and are truncated at 255 bytes. Returns nullopt if the packet is not a query, the player does not exist, or
// the previous rule is unknown. After the last rule, returns an empty RuleInfoReply.
std::optional<ControlPacket> make_query_reply(const ControlPacket& query, const ServerDescription& server,
                                              std::string_view own_address);

}  // namespace temblor::net
