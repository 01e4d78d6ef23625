#include "host/frame/debug_shapes.h"

#include "host/frame/host_parts.h"
#include "server/debug_shapes.h"

namespace temblor::host {

void update_debug_shapes(const Host& host, client::PresentationSettings& io_settings) {
  io_settings.lines.clear();
  io_settings.texts.clear();
  server::Server* const server = host.game.session->server();
  if (host.demos.session || server == nullptr || server->game == nullptr) return;
  const server::DebugShapes& shapes = server->game->context().debug_shapes;
  const formats::Palette& palette = host.game.data->look.palette;
  for (const auto& [line, look] : shapes.lines())
    io_settings.lines.push_back({line.from_world, line.to_world, palette[line.color], look.is_depth_tested});
  for (const auto& [text, look] : shapes.texts())
    io_settings.texts.push_back({text.text, text.origin_world, text.size, look.is_depth_tested});
}

}  // namespace temblor::host
