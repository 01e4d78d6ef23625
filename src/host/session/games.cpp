#include "host/session/games.h"

#include <fmt/format.h>

#include "base/text.h"
#include "formats/images/png.h"
#include "host/frame/frame_painter.h"
#include "host/frame/host_parts.h"
#include "host/lockstep/lockstep_games.h"
#include "host/session/configure.h"
#include "host/session/demos.h"
#include "render/present.h"

namespace temblor::host {
namespace {

constexpr int kMaxScreenshots = 10000;

base::Status open_own_server(Host& io_host, std::uint32_t max_clients) {
  Session& session = *io_host.game.session;
  const bool leaves_other = session.server() == nullptr;
  TRY_STATUS(session.open_server(max_clients, io_host.variables.port(), io_host.variables.player(),
                                 io_host.timing.now_s));
  if (leaves_other) io_host.stuffed_text.restore(io_host);
  return base::Ok{};
}

// Finishes start_map() and load_game(). If the level could not be started, a new server has no game and is
// shut down; a server that ran before continues its level.
base::Status show_started_game(Host& io_host, base::Status started) {
  if (started.ok()) {
    io_host.console.ui.close();
    io_host.game.menu->close();
    io_host.saves.saved_s = io_host.timing.now_s;
  } else if (io_host.game.session->server()->game == nullptr) {
    io_host.game.session->disconnect("");
  }
  return started;
}

}  // namespace

base::Status start_map(Host& io_host, std::string_view map) {
  // Check this first: a mistyped name must not end the running game.
  const std::string file = fmt::format("maps/{}.bsp", map);
  if (!io_host.game.data->library.files().contains(file))
    return base::error(base::ErrorCode::kNotFound, "No level \"{}\". Type maps to list all levels.", map);
  const bool waits_to_record = host::waits_to_record(io_host);
  if (!waits_to_record) TRY_STATUS(finish_recording(io_host));
  stop_demo(io_host);
  TRY_STATUS(open_own_server(io_host, io_host.variables.max_players()));
  if (waits_to_record) io_host.game.session->connection()->start_recording();
  return show_started_game(io_host, server::start_map(*io_host.game.session->server(), map));
}

base::Status load_game(Host& io_host, std::string_view name) {
  std::string file(name);
  if (!file.ends_with(".sav")) file += ".sav";
  std::error_code ignored;
  if (!std::filesystem::exists(io_host.game.data->write_folder / file, ignored))
    return base::error(base::ErrorCode::kNotFound, "No saved game \"{}\".", name);
  const bool waits_to_record = host::waits_to_record(io_host);
  if (!waits_to_record) TRY_STATUS(finish_recording(io_host));
  stop_demo(io_host);
  TRY_STATUS(open_own_server(io_host, 1));
  if (waits_to_record) io_host.game.session->connection()->start_recording();
  return show_started_game(io_host, server::load_saved_game(*io_host.game.session->server(), name));
}

base::Status save_game(Host& io_host, std::string_view name, std::string_view title) {
  server::Server* const server = io_host.game.session->server();
  if (server == nullptr)
    return base::error(base::ErrorCode::kUsage, "save: no game is running on this machine");
  TRY_STATUS(server::save_game(*server, name, title));
  std::string stem(name);
  if (stem.ends_with(".sav")) stem.resize(stem.size() - 4);
  // The next frame becomes the picture: only draw_frame() has a view without menus.
  io_host.saves = {.saved_s = io_host.timing.now_s, .picture_request = std::move(stem)};
  return base::Ok{};
}

base::Status connect_to_server(Host& io_host, std::string_view address) {
  const bool waits_to_record = host::waits_to_record(io_host);
  if (!waits_to_record) TRY_STATUS(finish_recording(io_host));
  stop_demo(io_host);
  TRY_STATUS(io_host.game.session->connect(address, io_host.variables.player(), io_host.timing.now_s));
  if (waits_to_record) io_host.game.session->connection()->start_recording();
  io_host.stuffed_text.restore(io_host);
  io_host.game.session->connection()->state().set_texts(load_game_texts(io_host));
  io_host.game.last_server = address;
  io_host.console.ui.close();
  io_host.game.menu->close();
  print_line(io_host, fmt::format("Connecting to {}...", address));
  return base::Ok{};
}

void disconnect(Host& io_host) {
  print_if_error(io_host, finish_recording(io_host));
  stop_demo(io_host);
  io_host.game.session->disconnect("The host has left.");
  print_if_error(io_host, save_replay(io_host));
  io_host.stuffed_text.restore(io_host);
}

void leave_game(Host& io_host) {
  disconnect(io_host);
  print_if_error(io_host, save_configuration(io_host));
}

bool can_save(const Host& host) {
  Session& session = *host.game.session;
  if (!session.is_alone() || !session.is_playing()) return false;
  const client::Game& game = session.connection()->state().game();
  return game.stat(client::Stat::kHealth) > 0 && game.ending == client::Ending::kNone;
}

std::string find_unsaved_progress(const Host& host) {
  constexpr double kMinWorthAsking_s = 5;  // less progress is not worth a question
  if (!can_save(host) || host.timing.now_s - host.saves.saved_s < kMinWorthAsking_s) return {};
  if (server::autosaves_on_leave(*host.game.session->server())) return {};
  return "Unsaved progress will be lost.";
}

void write_save_picture(Host& io_host, const render::FrameBuffer& frame) {
  const std::string name = std::exchange(io_host.saves.picture_request, {});
  const formats::Palette& palette = io_host.game.data->look.palette;
  // One of the two is empty, depending on the frame's format.
  std::vector<std::uint32_t> rgb(frame.rgb().begin(), frame.rgb().end());
  const formats::Palette shown = render::shown_palette(frame, palette);
  for (const std::uint8_t index : frame.indexed()) rgb.push_back(render::to_rgb(shown[index]));
  Thumbnails& thumbnails = io_host.game.menu_lists->thumbnails();
  const formats::Picture picture = make_thumbnail(rgb, frame.width(), frame.height(), thumbnails.colors());
  const base::Result<base::ByteVector> png =
      formats::write_png(picture.pixels, kThumbnailWidth, kThumbnailHeight, palette);
  print_if_error(io_host, png.ok() ? io_host.services.write_file(thumbnails.save_picture_file(name), *png)
                                   : base::Status(png.error()));
  // Also after an error, because an older picture may be in the cache.
  thumbnails.forget_save(name);
}

base::Status write_screenshot(Host& io_host, std::string_view file) {
  const std::filesystem::path& folder = io_host.game.data->write_folder;
  std::filesystem::path path = folder / file;  // an absolute path stays as it is
  std::error_code ignored;
  for (int number = 0; file.empty(); ++number) {
    if (number == kMaxScreenshots)
      return base::error(base::ErrorCode::kUsage,
                         "screenshot: {} has {} of them; move some elsewhere, or type screenshot NAME",
                         folder.string(), kMaxScreenshots);
    path = folder / fmt::format("temblor{:04}.png", number);
    if (!std::filesystem::exists(path, ignored)) break;
  }
  if (!path.has_extension()) path += ".png";
  const auto pixels = find_shown_pixels(io_host);
  if (!pixels.ok()) return base::error(pixels.error().code, "screenshot: {}", pixels.error().what);
  const render::FrameBuffer& frame = io_host.video.screen.frame();
  TRY(const base::ByteVector png, formats::write_png(*pixels, frame.width(), frame.height()));
  TRY_STATUS(io_host.services.write_file(path, png));
  print_line(io_host, fmt::format("Screenshot saved: {}", io_host.game.data->shorten_path(path)));
  return base::Ok{};
}

base::Status dump_console(Host& io_host, std::string_view file) {
  const std::optional<std::string> name = vfs::normalize_name(file);
  if (!name) return base::error(base::ErrorCode::kUsage, "\"{}\" is not a valid file name", file);
  const std::filesystem::path path = io_host.game.data->write_folder / *name;
  TRY_STATUS(io_host.services.write_file(path, base::as_bytes(io_host.console.ui.text())));
  print_line(io_host, fmt::format("Console text saved: {}", io_host.game.data->shorten_path(path)));
  return base::Ok{};
}

void search_servers(Host& io_host) {
  io_host.listed_servers.reset();
  print_if_error(io_host, io_host.search.begin());
}

void list_servers(Host& io_host) {
  search_servers(io_host);
  if (!io_host.search.is_running()) return;
  print_line(io_host, "Looking for servers on the local network...");
  io_host.listed_servers = 0;
}

void update_server_search(Host& io_host) {
  if (io_host.search.update()) io_host.game.menu->refresh();
  if (!io_host.listed_servers) return;
  std::size_t& printed = *io_host.listed_servers;
  for (const std::vector<client::MenuServer>& found = io_host.search.found(); printed < found.size();
       ++printed) {
    const client::MenuServer& server = found[printed];
    print_line(io_host, fmt::format("{:<21} {:<15} {:<8} {:2}/{:<2} {} ms", server.address, server.name,
                                    server.level, server.players, server.max_players, server.ping_ms));
  }
  if (io_host.search.is_running()) return;
  print_line(io_host, printed == 0 ? "No servers found."
                                   : base::counted(printed, "server") + "; join with: connect ADDRESS");
  io_host.listed_servers.reset();
}

}  // namespace temblor::host
