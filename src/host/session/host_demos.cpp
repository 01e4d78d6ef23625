// Recordings: made, watched, measured.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "command/text.h"
#include "host/commands/configuration.h"
#include "host/host.h"
#include "vfs/disk.h"

namespace temblor::host {
namespace {

constexpr double kMaxStep_s = 0.1;  // loading takes no time of the recording

std::string with_suffix(std::string_view name) {
  std::string file(name);
  if (!file.ends_with(".dem")) file += ".dem";
  return file;
}

// One that was just recorded is not in the tables of the game's files.
base::Result<base::ByteVector> read_demo(const GameData& data, const std::string& file) {
  const std::optional<std::string> name = vfs::normalized_name(file);
  if (!name)
    return base::error(base::ErrorCode::kUsage, "\"{}\" is no name of a file in the game folders", file);
  base::Result<base::ByteVector> bytes = vfs::read_disk_file(data.write_folder / file);
  if (bytes.ok()) return bytes;
  return data.library.files().read(*name);
}

}  // namespace

base::Status Host::play_demo(std::string_view name) {
  TRY_STATUS(open_demo(name));
  console_ui_.close();
  menu_->close();
  return base::Ok{};
}

base::Status Host::open_demo(std::string_view name) {
  const std::string file = with_suffix(name);
  TRY(base::ByteVector bytes, read_demo(*data_, file));
  disconnect();
  TRY(demo_, client::DemoSession::open(std::move(bytes), file, data_->presentation));
  demo_->set_listener([this](const client::Events& events, const client::Game&, double) {
    for (const std::string& text : events.prints) print_part(text);
  });
  demo_name_ = file;
  demo_controls_ = {};
  return base::Ok{};
}

std::vector<std::string> demos_to_attract(const GameData& data) {
  constexpr std::string_view kCommand = "startdemos";
  if (const base::Result<std::string> text = read_commands(data, "quake.rc"); text.ok()) {
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);)
      if (std::vector<std::string> words = command::split_words(line);
          words.size() > 1 && words.front() == kCommand)
        return {words.begin() + 1, words.end()};
  }
  std::vector<std::string> names;
  for (const char* const name : {"demo1", "demo2", "demo3"})
    if (data.library.files().contains(with_suffix(name))) names.emplace_back(name);
  return names;
}

void Host::attract(std::vector<std::string> demos) {
  attracting_ = std::move(demos);
  attract_next();
}

// Those that cannot be shown are tried once each.
void Host::attract_next() {
  std::vector<std::string> demos = std::move(attracting_);
  for (std::size_t tried = 0; tried < demos.size(); ++tried) {
    std::rotate(demos.begin(), demos.begin() + 1, demos.end());
    const base::Status opened = open_demo(demos.back());
    if (opened.ok()) {
      attracting_ = std::move(demos);
      return;
    }
    print(opened.error().message());
  }
}

base::Status Host::time_demo(std::string_view name) {
  TRY_STATUS(play_demo(name));
  timed_ = TimedDemo{std::string(name), services_.window.now_s(), 0};
  return base::Ok{};
}

void Host::stop_demo() {
  demo_.reset();
  timed_.reset();
  attracting_.clear();
}

// Lets it go on by this frame's time, or while it is measured by an update.
base::Status Host::show_demo() {
  data_->presentation.follow(nullptr);  // a recording's player goes where it says
  read_presentation_settings();
  const client::InputSettings input = variables_.input();
  const double passed_s = is_in_game() || is_attracting() ? std::min(times_.frame_s, kMaxStep_s) : 0;
  base::Result<bool> goes_on =
      timed_ ? demo_->step(1, presentation_settings_)
             : demo_controls_.advance(passed_s, presentation_settings_,
                                      {.turn_deg_per_count = input.sensitivity * input.mouse_yaw_deg},
                                      data_->presentation, *demo_);
  for (const std::string& note : data_->presentation.take_notes()) print(note);
  if (!goes_on.ok()) return goes_on.error();
  if (const int recordings = demo_controls_.take_recordings(); recordings != 0)
    return play_neighbor(recordings);
  if (timed_) ++timed_->frames;
  if (*goes_on) return base::Ok{};
  if (timed_) {
    const double seconds = services_.window.now_s() - timed_->began_s;
    print(fmt::format("{} frames {:.1f} seconds {:.1f} fps", timed_->frames, seconds,
                      timed_->frames / seconds));
  }
  if (is_attracting()) {
    attract_next();
    return base::Ok{};
  }
  stop_demo();
  open_menu(client::MenuPage::kMain);
  return base::Ok{};
}

base::Status Host::seek_demo(double time_s) {
  if (!demo_) return base::error(base::ErrorCode::kUsage, "no recording is playing");
  TRY([[maybe_unused]] const bool goes_on, demo_->seek(time_s, presentation_settings_));
  return base::Ok{};
}

// Another one of those that the menu lists.
base::Status Host::play_neighbor(int recordings) {
  const std::vector<client::MenuDemo> demos = menu_lists_->content().demos();
  const auto current = std::find_if(demos.begin(), demos.end(), [&](const client::MenuDemo& demo) {
    return with_suffix(demo.name) == demo_name_;
  });
  const std::ptrdiff_t wanted = current - demos.begin() + recordings;
  if (current == demos.end() || wanted < 0 || wanted >= std::ssize(demos)) return base::Ok{};
  return play_demo(demos[static_cast<std::size_t>(wanted)].name);
}

base::Status Host::record(std::string_view name) {
  if (session_->connection() == nullptr) return base::error(base::ErrorCode::kUsage, "record: not in a game");
  if (!vfs::normalized_name(name))
    return base::error(base::ErrorCode::kUsage, "\"{}\" is no name for a file", name);
  // The own server's ends with its level.
  if (session_->server() != nullptr && !session_->server()->is_recording() &&
      !session_->connection()->is_recording())
    recording_name_.clear();
  if (!recording_name_.empty()) return base::error(base::ErrorCode::kUsage, "a recording is running already");
  // From its beginning on: what the level began with is not said again. The own server can begin it anew.
  if (session_->is_alone() && session_->is_playing()) {
    TRY_STATUS(session_->server()->record(0, name));
    recording_name_ = with_suffix(name);
    return base::Ok{};
  }
  recording_name_ = with_suffix(name);
  session_->connection()->start_recording();
  print("recording from the next level on");
  return base::Ok{};
}

base::Status Host::stop_recording() {
  if (recording_name_.empty()) return base::error(base::ErrorCode::kUsage, "no recording is running");
  return stop_recording_if_any();
}

base::Status Host::stop_recording_if_any() {
  const std::string name = std::exchange(recording_name_, {});
  std::optional<base::ByteVector> recording = session_->take_lost_recording();
  if (name.empty()) return base::Ok{};
  if (server::Server* const server = session_->server(); server != nullptr && server->is_recording())
    return server->stop_recording();
  if (!recording && session_->connection() != nullptr && session_->connection()->is_recording())
    recording = session_->connection()->finish_recording();
  else if (!recording)
    return base::Ok{};
  if (!recording) return base::error(base::ErrorCode::kUsage, "{}: no level has begun since `record`", name);
  TRY_STATUS(services_.write_file(data_->write_folder / name, *recording));
  print(fmt::format("recorded to {}", (data_->write_folder / name).string()));
  return base::Ok{};
}

}  // namespace temblor::host
