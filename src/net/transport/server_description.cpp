#include "net/transport/server_description.h"

#include <algorithm>

namespace temblor::net {
namespace {

std::string_view cut(std::string_view text) {
  return text.substr(0, 255);
}

std::uint8_t byte_of(std::size_t count) {
  return static_cast<std::uint8_t>(std::min<std::size_t>(count, 255));
}

class Answer {
 public:
  Answer(const ServerDescription& server, std::string_view own_address)
      : server_(server), own_address_(own_address) {}

  std::optional<ControlPacket> operator()(const ServerInfoRequest&) const {
    return ServerInfoReply{cut(own_address_), cut(server_.host_name), cut(server_.map),
                           byte_of(server_.players.size()),
                           byte_of(static_cast<std::size_t>(std::max(server_.max_players, 0)))};
  }
  std::optional<ControlPacket> operator()(const PlayerInfoRequest& query) const {
    if (query.player >= server_.players.size()) return std::nullopt;
    const PlayerDescription& player = server_.players[query.player];
    const double seconds = std::clamp(player.connected_s, 0.0, 2e9);
    return PlayerInfoReply{query.player, cut(player.name),          player.colors,
                           player.frags, static_cast<int>(seconds), cut(player.address)};
  }
  std::optional<ControlPacket> operator()(const RuleInfoRequest& query) const {
    auto next = server_.rules.begin();
    if (!query.previous.empty()) {
      next = std::find_if(next, server_.rules.end(),
                          [&](const RuleDescription& rule) { return rule.name == query.previous; });
      if (next == server_.rules.end()) return std::nullopt;
      ++next;
    }
    if (next == server_.rules.end()) return RuleInfoReply{};
    return RuleInfoReply{cut(next->name), cut(next->value)};
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

std::optional<ControlPacket> answer_to(const ControlPacket& query, const ServerDescription& server,
                                       std::string_view own_address) {
  return std::visit(Answer(server, own_address), query);
}

}  // namespace temblor::net
