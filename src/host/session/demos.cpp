#include "host/session/demos.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "command/text.h"
#include "host/commands/configuration.h"
#include "host/frame/host_parts.h"
#include "host/frame/hud_program_stage.h"
#include "host/frame/presentation_settings.h"
#include "host/menus/menus.h"
#include "host/session/games.h"
#include "vfs/disk.h"

namespace temblor::host {
namespace {

// A longer frame was spent on loading. The demo must not skip what happened in that time.
constexpr double kMaxStep_s = 0.1;

std::string with_suffix(std::string_view name) {
  std::string file(name);
  if (!file.ends_with(".dem")) file += ".dem";
  return file;
}

// Looks in the write folder first, because the file tables of the game folders do not contain a demo that was
// just recorded.
base::Result<base::ByteVector> read_demo(const GameData& data, const std::string& file) {
  const std::optional<std::string> name = vfs::normalize_name(file);
  if (!name) return base::error(base::ErrorCode::kUsage, "\"{}\" is not a valid file name", file);
  base::Result<base::ByteVector> bytes = vfs::read_disk_file(data.write_folder / file);
  if (bytes.ok()) return bytes;
  return data.library.files().read(*name);
}

// Ends the running game.
base::Status open_demo_bytes(Host& io_host, base::ByteVector bytes, const std::string& file) {
  DemoPlayback& demos = io_host.demos;
  disconnect(io_host);
  TRY(demos.session, client::DemoSession::open(std::move(bytes), file, io_host.game.data->presentation,
                                               load_game_texts(io_host)));
  demos.session->set_listener([&io_host](const client::Events& events, const client::Game&, double) {
    for (const std::string& text : events.prints) print_server_text(io_host, text);
  });
  demos.file = file;
  demos.controls = {};
  return base::Ok{};
}

// A file that cannot be read leaves the game running.
base::Status open_demo(Host& io_host, std::string_view name) {
  const std::string file = with_suffix(name);
  TRY(base::ByteVector bytes, read_demo(*io_host.game.data, file));
  return open_demo_bytes(io_host, std::move(bytes), file);
}

void close_console_and_menu(Host& io_host) {
  io_host.console.ui.close();
  io_host.game.menu->close();
}

// Opens the next demo of the loop and moves it to the end. Tries each demo once, so that a loop of damaged
// demos ends. The loop is taken out of the host meanwhile, because opening a demo stops the current one and
// clears it.
void attract_next(Host& io_host) {
  std::vector<std::string> demos = std::move(io_host.demos.attract_loop);
  for (std::size_t tried = 0; tried < demos.size(); ++tried) {
    std::rotate(demos.begin(), demos.begin() + 1, demos.end());
    const base::Status opened = open_demo(io_host, demos.back());
    if (opened.ok()) {
      io_host.demos.attract_loop = std::move(demos);
      return;
    }
    print_line(io_host, opened.error().message());
  }
}

// Plays the demo `offset` places after the current one (negative: before it) in the menu's list. Does nothing
// at the ends of the list.
base::Status play_neighbor(Host& io_host, int offset) {
  const std::vector<client::MenuDemo> demos = io_host.game.menu_lists->content().demos();
  const auto current = std::find_if(demos.begin(), demos.end(), [&](const client::MenuDemo& demo) {
    return with_suffix(demo.name) == io_host.demos.file;
  });
  const std::ptrdiff_t wanted = current - demos.begin() + offset;
  if (current == demos.end() || wanted < 0 || wanted >= std::ssize(demos)) return base::Ok{};
  return play_demo(io_host, demos[static_cast<std::size_t>(wanted)].name);
}

void finish_demo(Host& io_host) {
  if (const std::optional<TimedDemo>& timed = io_host.demos.timed) {
    const double seconds = io_host.services.window.now_s() - timed->start_s;
    print_line(io_host, fmt::format("{} frames, {:.1f} seconds, {:.1f} fps", timed->frames, seconds,
                                    timed->frames / seconds));
  }
  if (io_host.demos.is_attracting()) return attract_next(io_host);
  stop_demo(io_host);
  open_menu(io_host, client::MenuPage::kMain);
}

}  // namespace

base::Status play_demo(Host& io_host, std::string_view name) {
  TRY_STATUS(open_demo(io_host, name));
  close_console_and_menu(io_host);
  return base::Ok{};
}

base::Status play_demo_bytes(Host& io_host, base::ByteVector bytes, std::string file) {
  TRY_STATUS(open_demo_bytes(io_host, std::move(bytes), file));
  close_console_and_menu(io_host);
  return base::Ok{};
}

base::Status time_demo(Host& io_host, std::string_view name) {
  TRY_STATUS(play_demo(io_host, name));
  io_host.demos.timed = TimedDemo{std::string(name), io_host.services.window.now_s(), 0};
  return base::Ok{};
}

void stop_demo(Host& io_host) {
  io_host.demos.session.reset();
  io_host.demos.timed.reset();
  io_host.demos.attract_loop.clear();
}

base::Status seek_demo(Host& io_host, double time_s) {
  if (!io_host.demos.session) return base::error(base::ErrorCode::kUsage, "no demo is playing");
  TRY([[maybe_unused]] const bool continues,
      io_host.demos.session->seek(time_s, io_host.video.presentation_settings));
  return base::Ok{};
}

base::Status advance_demo(Host& io_host) {
  DemoPlayback& demos = io_host.demos;
  client::Presentation& presentation = io_host.game.data->presentation;
  presentation.set_prediction(nullptr);  // the demo holds its player's position
  update_presentation_settings(io_host);
  const client::PresentationSettings& settings = io_host.video.presentation_settings;
  const client::InputSettings input = io_host.variables.input();
  // A demo that the player watches stops while a menu is open. In attract mode the menu is always open.
  const bool is_running = is_in_game(io_host) || demos.is_attracting();
  const double passed_s = is_running ? std::min(io_host.timing.measured.frame_s, kMaxStep_s) : 0;
  base::Result<bool> continues =
      demos.timed ? demos.session->step(1, settings)
                  : demos.controls.advance(passed_s, settings,
                                           {.turn_deg_per_count = input.sensitivity * input.mouse_yaw_deg,
                                            .time_scale = io_host.timing.time_scale},
                                           presentation, *demos.session);
  for (const std::string& note : presentation.take_notes()) print_line(io_host, note);
  if (!continues.ok()) return continues.error();
  if (const int offset = demos.controls.take_demo_steps(); offset != 0) return play_neighbor(io_host, offset);
  if (demos.timed) ++demos.timed->frames;
  if (!*continues) finish_demo(io_host);
  return base::Ok{};
}

void attract(Host& io_host, std::vector<std::string> demos) {
  std::erase_if(demos, [&](const std::string& name) {
    return !io_host.game.data->library.files().contains(with_suffix(name));
  });
  io_host.demos.attract_loop = std::move(demos);
  attract_next(io_host);
}

base::Status record_demo(Host& io_host, std::string_view name) {
  Session& session = *io_host.game.session;
  std::string& recording_file = io_host.demos.recording_file;
  if (session.connection() == nullptr)
    return base::error(base::ErrorCode::kUsage, "record: start or join a game first");
  if (!vfs::normalize_name(name))
    return base::error(base::ErrorCode::kUsage, "\"{}\" is not a valid file name", name);
  // A demo that our own server recorded ended with its level, without a call of finish_recording().
  if (session.server() != nullptr && !session.server()->recorder.has_value() &&
      !session.connection()->is_recording())
    recording_file.clear();
  if (!recording_file.empty())
    return base::error(base::ErrorCode::kUsage, "A demo is being recorded already. Type stop to finish it.");
  // In single player the server records: it knows the whole level, so the demo can start at once. Connections
  // record the packets that they receive, which are complete only from the start of a level on.
  if (session.is_alone() && session.is_playing()) {
    TRY_STATUS(server::record_demo(*session.server(), 0, name));
    recording_file = with_suffix(name);
    return base::Ok{};
  }
  recording_file = with_suffix(name);
  session.connection()->start_recording();
  print_line(io_host, fmt::format("Recording demo to {} from the next level on. Type stop to finish.",
                                  recording_file));
  return base::Ok{};
}

base::Status stop_recording(Host& io_host) {
  if (io_host.demos.recording_file.empty())
    return base::error(base::ErrorCode::kUsage, "no demo is being recorded");
  return finish_recording(io_host);
}

base::Status finish_recording(Host& io_host) {
  Session& session = *io_host.game.session;
  const std::string name = std::exchange(io_host.demos.recording_file, {});
  std::optional<base::ByteVector> recording = session.take_lost_recording();
  if (name.empty()) return base::Ok{};
  if (server::Server* const server = session.server(); server != nullptr && server->recorder.has_value())
    return server::stop_demo(*server);
  if (session.connection() != nullptr && session.connection()->is_recording())
    recording = session.connection()->finish_recording().value_or(base::ByteVector());
  if (!recording) return base::Ok{};
  if (recording->empty())
    return base::error(base::ErrorCode::kUsage, "{}: nothing was recorded, because no new level has started",
                       name);
  const std::filesystem::path path = io_host.game.data->write_folder / name;
  TRY_STATUS(io_host.services.write_file(path, *recording));
  print_line(io_host, fmt::format("Demo saved: {}", path.string()));
  return base::Ok{};
}

bool waits_to_record(const Host& host) {
  const Session& session = *host.game.session;
  return session.connection() != nullptr && session.connection()->waits_to_record();
}

}  // namespace temblor::host
