// What a server tells whoever asks (`quakestat -qs -P -R`), and the answers made of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "net/transport/control.h"

namespace temblor::net {

struct PlayerDescription {
  std::string name;
  int colors = 0;  // shirt << 4 | pants
  int frags = 0;
  double connected_s = 0;
  std::string address;  // as far as the world may know it
};
struct RuleDescription {
  std::string name, value;
};
struct ServerDescription {
  std::string host_name, map;
  int max_players = 0;
  std::vector<PlayerDescription> players;
  std::vector<RuleDescription> rules;
};

// Whether it asks for one of these descriptions.
bool is_query(const ControlPacket& packet);

// The answer to a query; its texts are those of the description and `own_address`, cut at 255 bytes. Nothing
// for a packet that is none, for a player there is not, and for the rule behind one that is not known.
std::optional<ControlPacket> answer_to(const ControlPacket& query, const ServerDescription& server,
                                       std::string_view own_address);

}  // namespace temblor::net
