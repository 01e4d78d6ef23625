#include "platform/sdl2/event_times.h"

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
  EXPECT_DOUBLE_EQ(compute_age_s(1000, 1250), 0.25);
  EXPECT_DOUBLE_EQ(compute_age_s(0xffffff00u, 0x20u), 0.288);
  EXPECT_DOUBLE_EQ(compute_age_s(1000, 1000), 0);
}

// The server of another machine has a clock of its own.
TEST(EventTimes, AgesOfAnotherClockAreZero) {
  EXPECT_EQ(compute_age_s(1000, 2500), 0);
  EXPECT_EQ(compute_age_s(1001, 1000), 0);
}

// Sends input by XTEST, and reads it 300 ms later. Expects `count` events of this kind, at the time of the
// command.
template <typename Kind>
void expect_times_of_input(const char* command, bool captured, std::size_t count) {
  auto window = open_window("Times", {.size = {320, 200}});
  ASSERT_TRUE(window.ok()) << window.error().message();
  std::vector<InputEvent> events;
  const auto wait = [](int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); };
  for (int i = 0; i < 20; ++i) {  // until the window has the focus
    wait(50);
    (*window)->poll(events);
    if (i == 10) {
      ASSERT_EQ(std::system("xdotool search --name Times windowfocus"), 0);
    } else if (i == 15) {
      (*window)->capture_mouse(captured);
    }
  }
  events.clear();
  const double before_s = (*window)->now_s();
  ASSERT_EQ(std::system(command), 0);
  const double sent_s = (*window)->now_s();
  wait(300);
  (*window)->poll(events);
  std::size_t found = 0;
  for (const InputEvent& event : events) {
    if (!std::holds_alternative<Kind>(event.what)) continue;
    ++found;
    EXPECT_GE(event.time_s, before_s - 0.002);
    EXPECT_LE(event.time_s, sent_s + 0.1) << "not when the window read it";
  }
  EXPECT_EQ(found, count);
}

#define RUN_ON_DISPLAY()                                                                      \
  if (std::system("command -v xvfb-run xauth xdotool >/dev/null") != 0)                       \
    GTEST_SKIP() << "a display (xvfb, xauth) or xdotool is not installed";                    \
  if (std::getenv("DISPLAY") == nullptr) {                                                    \
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();        \
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name(); \
    const std::string line = "'" TEMBLOR_SOURCE_DIR                                           \
                             "/tests/support/on_display.sh"                                   \
                             "' 1280x1024x24 '" +                                             \
                             self + "' --gtest_filter=EventTimes." + name;                    \
    EXPECT_EQ(std::system((line + " >&2").c_str()), 0);                                       \
    return;                                                                                   \
  }

TEST(EventTimes, AKeyHappensWhenItIsPressed) {
  RUN_ON_DISPLAY();
  expect_times_of_input<KeyChange>("xdotool key x", false, 2);
}

TEST(EventTimes, RelativeMovementHappensWhenTheMouseMoves) {
  RUN_ON_DISPLAY();
  expect_times_of_input<MouseMoved>("xdotool mousemove_relative 20 5; xdotool mousemove_relative -- -7 3",
                                    true, 2);
}

}  // namespace
}  // namespace temblor::platform::sdl2
