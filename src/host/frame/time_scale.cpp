#include "host/frame/time_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "host/frame/host_parts.h"

namespace temblor::host {
namespace {

// Bots have no clock of their own, so they do not count.
bool has_other_players(const server::Server& server) {
  const auto clients = server.clients.all();
  return std::ranges::count_if(clients, [](const server::Client& client) {
           return client.stage != server::ClientStage::kFree && client.stage != server::ClientStage::kBot;
         }) > 1;
}

// Why time must run at its normal speed; empty if it need not.
std::string_view find_obstacle(Host& io_host) {
  Session& session = *io_host.game.session;
  if (io_host.demos.session || session.connection() == nullptr) return "";
  if (session.server() == nullptr) return "the server's clock is that of the game, and it is elsewhere";
  return has_other_players(*session.server()) ? "other players share this game, and their clocks run on" : "";
}

}  // namespace

double choose_time_scale(Host& io_host) {
  const double wanted = io_host.variables.time_scale();
  bool& has_explained = io_host.timing.has_explained_time_scale;
  if (wanted == 1) {
    has_explained = false;
    return 1;
  }
  const std::string_view obstacle = find_obstacle(io_host);
  if (obstacle.empty()) return wanted;
  if (!std::exchange(has_explained, true))
    print_line(io_host, fmt::format("host_timescale is ignored: {}", obstacle));
  return 1;
}

}  // namespace temblor::host
