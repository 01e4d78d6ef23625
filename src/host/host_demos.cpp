// Recordings: made, watched, measured.
#include <fmt/format.h>

#include <algorithm>

#include "host/host.h"
#include "vfs/disk.h"

namespace temblor::host {
namespace {

using platform::Key;

constexpr double kSeekStep_s = 5;
constexpr float kFlightSpeed = 400, kFastFlight = 4;  // units a second; times, with the run key

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
  base::Result<base::ByteVector> bytes = vfs::read_disk_file(data.write_folder() / *name);
  if (bytes.ok()) return bytes;
  return data.library.files().read(*name);
}

}  // namespace

base::Status Host::play_demo(std::string_view name) {
  const std::string file = with_suffix(name);
  TRY(base::ByteVector bytes, read_demo(*data_, file));
  disconnect();
  TRY(demo_, client::DemoSession::open(std::move(bytes), file, data_->presentation));
  console_ui_.close();
  menu_->close();
  return base::Ok{};
}

base::Status Host::time_demo(std::string_view name) {
  TRY_STATUS(play_demo(name));
  timed_ = TimedDemo{std::string(name), services_.window.now_s(), 0};
  return base::Ok{};
}

void Host::stop_demo() {
  demo_.reset();
  timed_.reset();
  flies_ = false;
}

// Lets it go on by this frame's time, or while it is measured by an update.
base::Status Host::show_demo() {
  data_->presentation.follow(nullptr);
  presentation_settings_ = variables_.presentation();
  presentation_settings_.view.fov_deg = fov_deg_;
  base::Result<bool> goes_on =
      timed_ ? demo_->step(1, presentation_settings_)
             : demo_->advance(is_in_game() ? times_.frame_s : 0, presentation_settings_);
  for (const std::string& text : demo_->state().events().prints) print_part(text);
  for (const std::string& note : data_->presentation.take_notes()) print(note);
  if (!goes_on.ok()) return goes_on.error();
  if (timed_) ++timed_->frames;
  if (*goes_on) return base::Ok{};
  if (timed_) {
    const double seconds = services_.window.now_s() - timed_->began_s;
    print(fmt::format("{} frames {:.1f} seconds {:.1f} fps", timed_->frames, seconds,
                      timed_->frames / seconds));
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

// While a recording plays, some keys are its own. False: this one is not.
bool Host::take_demo_key(Key key) {
  switch (key) {
    case Key::kSpace:
      demo_->pause(!demo_->is_paused());
      return true;
    case Key::kLeftArrow:
    case Key::kRightArrow: {
      const double step_s = key == Key::kLeftArrow ? -kSeekStep_s : kSeekStep_s;
      if (const base::Status sought = seek_demo(demo_->time_s() + step_s); !sought.ok())
        print(sought.error().message());
      return true;
    }
    case Key::kUpArrow:
      demo_->set_speed(demo_->speed() * 2);
      return true;
    case Key::kDownArrow:
      demo_->set_speed(demo_->speed() / 2);
      return true;
    default:
      return false;
  }
}

void Host::toggle_camera() {
  if (!demo_ && !session_->is_playing()) return print("there is nothing to fly through");
  flies_ = !flies_;
  if (!flies_) return;
  free_camera_.place(data_->presentation.scene().camera);
  input_.set_view_angles(free_camera_.camera().angles_deg);
}

// Mouse and walking keys move the camera instead of the player.
void Host::fly(const client::InputSettings& settings) {
  const math::Vec3 before_deg = input_.view_angles_deg();
  input_.look({.time_s = now_s_}, settings);
  const math::Vec3 turned_deg = input_.view_angles_deg() - before_deg;
  free_camera_.turn(turned_deg.x, turned_deg.y);
  const client::Buttons& buttons = input_.buttons();
  const auto wish = [&](client::Button more, client::Button less) {
    return static_cast<float>(buttons[more].is_down()) - static_cast<float>(buttons[less].is_down());
  };
  using client::Button;
  const bool is_fast = buttons[Button::kSpeed].is_down();
  free_camera_.fly({.forward = wish(Button::kForward, Button::kBack),
                    .right = wish(Button::kMoveRight, Button::kMoveLeft),
                    .up = wish(Button::kJump, Button::kMoveDown)},
                   is_fast ? kFlightSpeed * kFastFlight : kFlightSpeed, times_.frame_s);
}

base::Status Host::record(std::string_view name) {
  if (session_->connection() == nullptr) return base::error(base::ErrorCode::kUsage, "record: not in a game");
  if (!vfs::normalized_name(name))
    return base::error(base::ErrorCode::kUsage, "\"{}\" is no name for a file", name);
  if (!recording_name_.empty()) return base::error(base::ErrorCode::kUsage, "a recording is running already");
  recording_name_ = with_suffix(name);
  // From its beginning on: what the level began with is not said again. The own server can begin it anew.
  if (session_->is_alone() && session_->is_playing()) return session_->server()->record(0, name);
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
  if (name.empty() || session_->connection() == nullptr) return base::Ok{};
  if (!session_->connection()->is_recording())
    return session_->server() != nullptr ? session_->server()->stop_recording() : base::Status(base::Ok{});
  const std::optional<base::ByteVector> recording = session_->connection()->finish_recording();
  if (!recording) return base::error(base::ErrorCode::kUsage, "{}: no level has begun since `record`", name);
  TRY_STATUS(services_.write_file(data_->write_folder() / name, *recording));
  print(fmt::format("recorded to {}", (data_->write_folder() / name).string()));
  return base::Ok{};
}

}  // namespace temblor::host
