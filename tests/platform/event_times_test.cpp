#include "platform/sdl2/events/event_times.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "platform/sdl2/window.h"

namespace temblor::platform::sdl2 {
namespace {

TEST(EventTimes, AgesWrapAround) {
  EXPECT_DOUBLE_EQ(compute_age_s(1000, 1250).value(), 0.25);
  EXPECT_DOUBLE_EQ(compute_age_s(0xffffff00u, 0x20u).value(), 0.288);
  EXPECT_DOUBLE_EQ(compute_age_s(1000, 1000).value(), 0);
}

// The server of another machine has a clock of its own.
TEST(EventTimes, AgesOfAnotherClockAreUnknown) {
  EXPECT_EQ(compute_age_s(1000, 2500), std::nullopt);
  EXPECT_EQ(compute_age_s(1001, 1000), std::nullopt);
}

struct Input {
  // Sends the input by XTEST.
  const char* command;
  // The window gets relative movement.
  bool captured = false;
  // Events of the kind, and how long after the start of the command the first happens.
  std::size_t count = 0;
  double first_s = 0;
  // xdotool's words for the X11 window that gets the input.
  const char* window = "--name Times";
};

// Sends input, and reads it 300 ms later. Expects events of this kind at the time of the command.
template <typename Kind>
void expect_times_of_input(const Input& input) {
  auto window = open_window("Times", {.size = {320, 200}});
  ASSERT_TRUE(window.ok()) << window.error().message();
  std::vector<InputEvent> events;
  const auto wait = [](int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); };
  // Wayland shows no window without a picture.
  const std::vector<std::uint32_t> pixels(320 * 200);
  base::Jobs jobs(1);
  for (int i = 0; i < 20; ++i) {  // until the window has the focus
    wait(50);
    (*window)->poll(events);
    ASSERT_TRUE((*window)->present({pixels, {320, 200}}, jobs).ok());
    if (i == 10) {
      const std::string focus = fmt::format("xdotool search {} windowfocus", input.window);
      ASSERT_EQ(std::system(focus.c_str()), 0);
    } else if (i == 15) {
      (*window)->capture_mouse(input.captured);
      // Weston locks the pointer to a window that is clicked.
      ASSERT_EQ(std::system("xdotool click 1"), 0);
    }
  }
  events.clear();
  const double before_s = (*window)->now_s();
  ASSERT_EQ(std::system(input.command), 0);
  const double sent_s = (*window)->now_s();
  wait(300);
  (*window)->poll(events);
  std::size_t found = 0;
  for (const InputEvent& event : events) {
    if (!std::holds_alternative<Kind>(event.what)) continue;
    ++found;
    EXPECT_GE(event.time_s, before_s + input.first_s - 0.002);
    EXPECT_LE(event.time_s, sent_s + 0.1) << "not when the window read it";
  }
  EXPECT_EQ(found, input.count);
}

// Runs the test again on a display of its own: X11 (""), or Weston, with this many of X11's pixels for one of
// its own, in an X11 window that gets XTEST's input.
#define RUN_ON_DISPLAY(weston_scale)                                          \
  if (std::system("command -v xvfb-run xauth xdotool >/dev/null") != 0)       \
    GTEST_SKIP() << "a display (xvfb, xauth) or xdotool is not installed";    \
  if (*weston_scale != 0 && std::system("command -v weston >/dev/null") != 0) \
    GTEST_SKIP() << "a Wayland display (weston) is not installed";            \
  if (std::getenv("TEMBLOR_TEST_DISPLAY") == nullptr) {                       \
    EXPECT_EQ(std::system(make_display_command(weston_scale).c_str()), 0);    \
    return;                                                                   \
  }

std::string make_display_command(std::string_view weston_scale) {
  const std::string scripts = TEMBLOR_SOURCE_DIR "/tests/support";
  std::string command = fmt::format("TEMBLOR_TEST_DISPLAY=1 '{}/on_display.sh' 1280x1024x24 ", scripts);
  if (!weston_scale.empty()) command += fmt::format("'{}/on_weston.sh' {} ", scripts, weston_scale);
  return command + fmt::format("'{}' --gtest_filter=EventTimes.{} >&2",
                               std::filesystem::read_symlink("/proc/self/exe").string(),
                               ::testing::UnitTest::GetInstance()->current_test_info()->name());
}

TEST(EventTimes, AKeyHappensWhenItIsPressed) {
  RUN_ON_DISPLAY("");
  expect_times_of_input<KeyChange>({.command = "xdotool key x", .count = 2});
}

TEST(EventTimes, RelativeMovementHappensWhenTheMouseMoves) {
  RUN_ON_DISPLAY("");
  expect_times_of_input<MouseMoved>(
      {.command = "xdotool mousemove_relative 20 5; xdotool mousemove_relative -- -7 3",
       .captured = true,
       .count = 2});
}

TEST(EventTimes, KeysAndButtonsOnWaylandHappenWhenTheyArePressed) {
  RUN_ON_DISPLAY("1");
  expect_times_of_input<KeyChange>(
      {.command = "xdotool key x click 1 key y click 4", .count = 8, .window = "--class Weston"});
}

TEST(EventTimes, RelativeMovementOnWaylandHappensWhenTheMouseMoves) {
  RUN_ON_DISPLAY("1");
  expect_times_of_input<MouseMoved>(
      {.command = "xdotool mousemove_relative 20 5; xdotool mousemove_relative -- -7 3",
       .captured = true,
       .count = 2,
       .window = "--class Weston"});
}

// A pixel of the X11 window is half a pixel of Weston's, so SDL sends the second movement only.
TEST(EventTimes, RelativeMovementOfHalfPixelsOnWaylandHappensAtTheSecondHalf) {
  RUN_ON_DISPLAY("2");
  expect_times_of_input<MouseMoved>(
      {.command = "xdotool mousemove_relative 1 0; sleep 0.2; xdotool mousemove_relative 1 0",
       .captured = true,
       .count = 1,
       .first_s = 0.2,
       .window = "--class Weston"});
}

}  // namespace
}  // namespace temblor::platform::sdl2
