#include "host/frame/entity_boxes.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "host/frame/host_parts.h"
#include "server/entity_boxes.h"

namespace temblor::host {
namespace {

// Why there are no boxes; empty if there are.
std::string_view find_obstacle(const Host& host) {
  if (host.demos.session) return "a demo does not contain them";
  if (host.game.session->server() == nullptr) return "only the server knows them, and it is elsewhere";
  return host.game.session->is_alone() ? "" : "they show other players through walls; it works alone only";
}

}  // namespace

void update_entity_boxes(Host& io_host, client::PresentationSettings& io_settings) {
  io_settings.boxes.clear();
  bool& has_explained = io_host.video.has_explained_boxes;
  if (!io_settings.choices.boxes) {
    has_explained = false;
    return;
  }
  const std::string_view obstacle = find_obstacle(io_host);
  if (!obstacle.empty()) {
    if (!std::exchange(has_explained, true))
      print_line(io_host, fmt::format("r_showbboxes shows no boxes: {}", obstacle));
    return;
  }
  if (server::Game* const game = io_host.game.session->server()->game.get())
    io_settings.boxes = server::list_entity_boxes(*game, 0);
}

}  // namespace temblor::host
