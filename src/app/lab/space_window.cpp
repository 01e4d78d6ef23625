#include "app/lab/space_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "app/bench/distribution.h"
#include "app/lab/space_pilot.h"
#include "platform/sdl2/window.h"

namespace temblor::app {
namespace {

// A pause of the program, such as a window that is moved, must not become a jump.
constexpr double kMaxFrameSeconds = 0.1;
// A display without vsync does not slow the loop down.
constexpr double kMinFrameSeconds = 1 / 120.0;

void wait_s(double seconds) {
  if (seconds > 0) std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

// The picture, in memory that is kept from frame to frame.
class SpaceScreen {
 public:
  explicit SpaceScreen(const SpaceScene& scene) : scene_(scene), battle_(scene.battle) {}

  const lab::space::Battle& battle() const { return battle_; }
  // Returns the milliseconds of drawing.
  double draw(const SpacePilot& pilot, platform::PixelSize size, double time_s,
              const platform::Window& window) {
    size_ = size;
    pixels_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    const double before_s = window.now_s();
    battle_.draw(
        lab::space::make_battle_view(pilot.place(), pilot.axes(), scene_.fov_deg, size.width, size.height),
        time_s, pixels_);
    return (window.now_s() - before_s) * 1000;
  }
  platform::Picture picture() const { return {pixels_, size_}; }

 private:
  const SpaceScene& scene_;
  lab::space::Battle battle_;
  std::vector<std::uint32_t> pixels_;
  platform::PixelSize size_;
};

}  // namespace

base::Status play_space_in(platform::Window& window, const SpaceScene& scene) {
  SpaceScreen screen(scene);
  SpacePilot pilot(screen.battle().lookout(), screen.battle().lookout_axes());
  base::Jobs jobs(1);
  std::vector<platform::InputEvent> events;
  std::vector<double> frame_ms;
  double time_s = 0, last_s = window.now_s();
  while (true) {
    events.clear();
    window.poll(events);
    for (const platform::InputEvent& event : events) pilot.handle(event);
    if (pilot.has_left()) break;
    const double now_s = window.now_s(), seconds = std::min(now_s - last_s, kMaxFrameSeconds);
    last_s = now_s;
    time_s += seconds;
    pilot.fly(seconds);
    const platform::PixelSize size = window.size();
    if (window.is_visible() && size.width > 0 && size.height > 0) {
      frame_ms.push_back(screen.draw(pilot, size, time_s, window));
      TRY_STATUS(window.present(screen.picture(), jobs));
    }
    wait_s(now_s + kMinFrameSeconds - window.now_s());
  }
  if (!frame_ms.empty())
    fmt::print("{} frames, median {:.2f} ms to draw\n", frame_ms.size(), compute_distribution(frame_ms).p50);
  return base::Ok{};
}

base::Status play_space(const SpaceScene& scene) {
  const std::string title = fmt::format("Space battle: {}", kSpaceKeys);
  platform::WindowSettings settings;
  settings.size = {scene.size.width, scene.size.height};
  base::Result<std::unique_ptr<platform::Window>> window = platform::sdl2::open_window(title, settings);
  if (!window.ok())
    return base::error(base::ErrorCode::kIo,
                       "no display for a window ({}); `temblor lab run space -o FILE.png` makes a picture "
                       "without one",
                       window.error().message());
  fmt::print("{} solids. Keys: {}.\n", scene.battle.solids, kSpaceKeys);
  std::fflush(stdout);
  return play_space_in(**window, scene);
}

}  // namespace temblor::app
