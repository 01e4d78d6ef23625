#include "host/frame/host_parts.h"

#include <fmt/format.h>

#include <utility>

namespace temblor::host {

bool is_in_game(const Host& host) {
  return !host.console.ui.takes_text() && !(host.game.menu && host.game.menu->is_open());
}

bool has_view(const Host& host) {
  return (host.demos.session || host.game.session->is_playing()) && host.game.data->presentation.has_level();
}

bool is_halted(const Host& host) {
  if (!host.game.session->is_alone() || !host.game.session->is_playing()) return false;
  return !is_in_game(host) || (!host.input.has_focus && host.variables.pauses_unfocused());
}

std::optional<render::Camera> current_camera(const Host& host) {
  if (!has_view(host)) return std::nullopt;
  return host.game.data->presentation.scene().camera;
}

void print_line(Host& io_host, std::string_view line) {
  io_host.services.print_line(line);
  io_host.console.ui.print_utf8(fmt::format("{}\n", line), io_host.timing.now_s);
}

void print_if_error(Host& io_host, const base::Status& status) {
  if (!status.ok()) print_line(io_host, status.error().message());
}

void report_unknown_names(Host& io_host) {
  const std::string line = io_host.console.foreign_names.take_report();
  if (!line.empty()) print_line(io_host, line);
}

// The terminal prints whole lines only, so the rest of a line waits for its newline.
void print_game_text(Host& io_host, std::string_view text) {
  io_host.console.ui.print(text, io_host.timing.now_s);
  std::string& line = io_host.console.unfinished_line;
  for (const char c : text) {
    if (c == '\n')
      io_host.services.print_line(std::exchange(line, {}));
    else
      line += c;
  }
}

}  // namespace temblor::host
