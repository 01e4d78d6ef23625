// The picture of a frame: the view, what lies over it, the window.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "client/demo/demo_bar.h"
#include "client/hud/corner_text.h"
#include "host/host.h"

namespace temblor::host {
namespace {

constexpr std::uint8_t kBlack = 0;
constexpr double kSpeedShownFor_s = 0.5, kBarShownFor_s = 3;

}  // namespace

void Host::read_presentation_settings() {
  presentation_settings_ = variables_.presentation();
  presentation_settings_.view.fov_deg = fov_deg_;
  presentation_settings_.sound = sound_.has_value();
  presentation_settings_.hud.death_hint = death_hint();
  presentation_settings_.hud.shows_scores = input_.buttons()[client::Button::kScores].is_down();
}

// What the dead can do; the games all have it so.
std::string_view Host::death_hint() {
  if (demo_) return {};
  if (!session_->is_alone()) return "Fire: come back";
  return session_->server()->goes_on_from_save()
             ? "Fire: go on from the last save\nJump: begin the level again"
             : "Fire: begin the level again";
}

base::Status Host::make_scene() {
  if (!session_->is_playing()) return base::Ok{};
  read_presentation_settings();
  client::ClientState& state = session_->connection()->state();
  data_->presentation.follow(&prediction_);
  TRY_STATUS(data_->presentation.advance(state, session_->time_s(), input_.view_angles_deg(),
                                         presentation_settings_));
  for (const std::string& note : data_->presentation.take_notes()) print(note);
  return base::Ok{};
}

bool Host::has_view() const {
  return (demo_ || session_->is_playing()) && data_->presentation.has_level();
}

std::optional<render::Camera> Host::view() const {
  if (!has_view()) return std::nullopt;
  return data_->presentation.scene().camera;
}

void Host::draw() {
  const double began_s = services_.window.now_s();
  const ScreenSettings settings = variables_.screen();
  render::FrameBuffer& frame = screen_.begin(services_.window.size(), settings);
  const auto step = [this, halted = is_halted()] { session_->step_server(now_s_, halted); };
  // The game's code may set variables: what drawing needs of them is read before, and the menus, which show
  // them, are not drawn meanwhile.
  const DrawSettings drawing{variables_.render(), variables_.console(), variables_.shows_speed(),
                             variables_.shows_latency()};
  // Where a frame waits for its time the tick has it, too: the picture is shown sooner with all cores to
  // itself.
  const bool beside =
      variables_.is_parallel() && !has_time_to_spare_ && session_->server() != nullptr && is_in_game();
  if (beside) worker_.begin(step);
  draw_view(drawing, frame);
  times_.drawing_s = services_.window.now_s() - began_s;
  const base::Status shown = screen_.show(data_->look.palette, settings, times_.drawing_s, services_.window);
  const double presented_s = services_.window.now_s();
  times_.present_s = presented_s - began_s - times_.drawing_s;
  times_.latency_s = oldest_event_s_ ? presented_s - *oldest_event_s_ : 0;
  if (beside)
    worker_.wait();
  else
    step();
  // A window that is lost may stay so for long.
  if (const bool was_shown = std::exchange(is_shown_, shown.ok()); was_shown && !shown.ok())
    print(shown.error().message());
}

void Host::draw_view(const DrawSettings& settings, render::FrameBuffer& io_frame) {
  render::FrameStats stats;
  overlay_.clear();
  if (has_view() && !console_ui_.covers_frame()) {
    stats = data_->renderer.render(data_->presentation.scene(), settings.render, io_frame);
    if (!picture_wanted_.empty()) keep_picture(io_frame);
    const client::ClientState& state = demo_ ? demo_->state() : session_->connection()->state();
    overlay_ =
        data_->presentation.draw_list(state, io_frame.width(), io_frame.height(), presentation_settings_);
  } else {
    overlay_.commands.push_back({.area = {0, 0, io_frame.width(), io_frame.height()}, .fill = kBlack});
  }
  draw_over(settings, io_frame);
  data_->renderer.draw_overlay(overlay_, io_frame, stats);
}

// Console and menus, and what is measured.
void Host::draw_over(const DrawSettings& settings, const render::FrameBuffer& frame) {
  const bool menu_is_open = menu_->is_open();
  const client::ConsoleView view{.pictures = data_->presentation.pictures(),
                                 .time_s = now_s_,
                                 .game_runs = has_view() || menu_is_open,
                                 .version = options_.version,
                                 .settings = settings.console};
  if (demo_ && !timed_ && !is_attracting() &&
      (demo_->is_paused() || demo_controls_.idle_s() < kBarShownFor_s))
    client::draw_demo_bar(*demo_, data_->presentation.pictures(), frame.width(), frame.height(), 0, overlay_);
  console_ui_.draw(view, frame.width(), frame.height(), overlay_);
  menu_->draw(frame.width(), frame.height(), now_s_, overlay_);
  speed_.frames += 1;
  speed_.seconds += times_.frame_s;
  speed_.worst_latency_s = std::max(speed_.worst_latency_s, times_.latency_s);
  if (speed_.seconds >= kSpeedShownFor_s) {
    speed_text_ = fmt::format("{:.0f} fps", speed_.frames / speed_.seconds);
    latency_text_ = fmt::format("{:.1f} ms", speed_.worst_latency_s * 1000);
    speed_ = {};
  }
  int line = 0;
  for (const std::string* text :
       {settings.shows_speed ? &speed_text_ : nullptr, settings.shows_latency ? &latency_text_ : nullptr})
    if (text != nullptr)
      client::draw_corner_text(data_->presentation.pictures(), *text, line++, frame.width(), frame.height(),
                               overlay_);
}

// Time stands still for a single player who looks at something else.
bool Host::is_halted() const {
  return session_->is_alone() && session_->is_playing() && !is_in_game();
}

}  // namespace temblor::host
