#include "net/transport/server_description.h"

#include <algorithm>

namespace temblor::net {
namespace {

constexpr std::size_t kMaxTextBytes = 255;

std::string_view truncate_text(std::string_view text) {
  return text.substr(0, kMaxTextBytes);
}

std::uint8_t clamp_to_byte(std::size_t count) {
  return static_cast<std::uint8_t>(std::min<std::size_t>(count, 255));
}

// Visitor of a query that makes its reply.
class ReplyMaker {
 public:
  ReplyMaker(const ServerDescription& server, std::string_view own_address)
      : server_(server), own_address_(own_address) {}

  std::optional<ControlPacket> operator()(const ServerInfoRequest&) const {
    return ServerInfoReply{truncate_text(own_address_), truncate_text(server_.host_name),
                           truncate_text(server_.map), clamp_to_byte(server_.players.size()),
                           clamp_to_byte(static_cast<std::size_t>(std::max(server_.max_players, 0)))};
  }
  std::optional<ControlPacket> operator()(const PlayerInfoRequest& query) const {
    if (query.player >= server_.players.size()) return std::nullopt;
    const PlayerDescription& player = server_.players[query.player];
    const double seconds = std::clamp(player.connected_s, 0.0, 2e9);
    return PlayerInfoReply{query.player, truncate_text(player.name), player.colors,
                           player.frags, static_cast<int>(seconds),  truncate_text(player.address)};
  }
  // A client walks through the list: each query names the rule before the one that it wants.
  std::optional<ControlPacket> operator()(const RuleInfoRequest& query) const {
    auto next = server_.rules.begin();
    if (!query.previous.empty()) {
      next = std::find_if(next, server_.rules.end(),
                          [&](const RuleDescription& rule) { return rule.name == query.previous; });
      if (next == server_.rules.end()) return std::nullopt;
      ++next;
    }
    if (next == server_.rules.end()) return RuleInfoReply{};
    return RuleInfoReply{truncate_text(next->name), truncate_text(next->value)};
  }
  template <typename Other>
  std::optional<ControlPacket> operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  const ServerDescription& server_;
  std::string_view own_address_;
};

}  // namespace

bool is_query(const ControlPacket& packet) {
  return std::holds_alternative<ServerInfoRequest>(packet) ||
         std::holds_alternative<PlayerInfoRequest>(packet) || std::holds_alternative<RuleInfoRequest>(packet);
}

std::optional<ControlPacket> make_query_reply(const ControlPacket& query, const ServerDescription& server,
                                              std::string_view own_address) {
  return std::visit(ReplyMaker(server, own_address), query);
}

}  // namespace temblor::net
