// Pictures in a window of a real X server (Xvfb, whose display refreshes 60 times per second).
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <xcb/xcb.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "platform/run_on_display.h"
#include "platform/sdl2/window.h"

namespace temblor::platform::sdl2 {
namespace {

using ::testing::HasSubstr;

constexpr PixelSize kSize{640, 400};
constexpr std::array<std::uint32_t, 3> kColors = {0xffcc2200, 0xff00bb33, 0xff1144dd};

std::unique_ptr<Window> open_shared(bool vsync) {
  auto window = open_window("Pictures", {.size = kSize, .vsync = vsync}, Presenter::kSharedMemory);
  EXPECT_TRUE(window.ok()) << window.error().message();
  return window.ok() ? std::move(*window) : nullptr;
}

struct Shower {
  base::Jobs jobs{1};
  std::vector<std::uint32_t> pixels;

  void show(Window& io_window, std::uint32_t color, PixelSize size = kSize) {
    pixels.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), color);
    std::vector<InputEvent> events;
    io_window.poll(events);
    const base::Status shown = io_window.present({pixels, size}, jobs);
    EXPECT_TRUE(shown.ok()) << shown.error().message();
  }

  // Returns how many pictures per second the window shows.
  double measure_rate(Window& io_window, int count) {
    for (int i = 0; i < 5; ++i) show(io_window, kColors[0]);
    const double began_s = io_window.now_s();
    for (int i = 0; i < count; ++i) show(io_window, kColors[static_cast<std::size_t>(i) % kColors.size()]);
    return count / (io_window.now_s() - began_s);
  }
};

TEST(X11Presenter, VsyncShowsAPicturePerRefresh) {
  RUN_ON_X11_DISPLAY("");
  const auto window = open_shared(true);
  ASSERT_NE(window, nullptr);
  EXPECT_THAT(window->describe(), HasSubstr("vsync by the Present extension"));
  Shower shower;
  double fastest = 0;
  for (int i = 0; i < 5 && fastest < 57; ++i)  // a busy machine misses some
    fastest = std::max(fastest, shower.measure_rate(*window, 60));
  EXPECT_NEAR(fastest, 60, 3);
  ASSERT_TRUE(window->apply({.size = kSize, .vsync = false}).ok());
  EXPECT_THAT(window->describe(), HasSubstr("vsync off"));
  EXPECT_GT(shower.measure_rate(*window, 90), 120);
}

// present() returns when the picture is in the window.
TEST(X11Presenter, APictureIsInTheWindowWhenPresentReturns) {
  RUN_ON_X11_DISPLAY("");
  const auto window = open_shared(true);
  ASSERT_NE(window, nullptr);
  ScreenReader screen;
  Shower shower;
  for (int i = 0; i < 5; ++i) shower.show(*window, kColors[0]);
  for (int i = 0; i < 30; ++i) {
    const std::uint32_t color = kColors[static_cast<std::size_t>(i) % kColors.size()];
    shower.show(*window, color);
    EXPECT_EQ(screen.read(), std::set<std::uint32_t>{color}) << i;
  }
}

// Another thread reads the screen while pictures of one color each are shown.
TEST(X11Presenter, TheScreenNeverShowsTwoPictures) {
  RUN_ON_X11_DISPLAY("");
  constexpr int kReads = 100;
  for (const bool vsync : {true, false}) {
    const auto window = open_shared(vsync);
    ASSERT_NE(window, nullptr);
    Shower shower;
    for (int i = 0; i < 5; ++i) shower.show(*window, kColors[0]);
    std::atomic<int> reads = 0;
    std::set<std::uint32_t> seen;
    int mixed = 0;
    std::thread reader([&] {
      ScreenReader screen;
      for (; reads < kReads; ++reads) {
        const std::set<std::uint32_t> colors = screen.read();
        mixed += colors.size() != 1;
        seen.insert(colors.begin(), colors.end());
      }
    });
    while (reads < kReads) shower.measure_rate(*window, 10);
    reader.join();
    EXPECT_EQ(mixed, 0) << "of " << kReads << " readings";
    EXPECT_EQ(seen, std::set<std::uint32_t>(kColors.begin(), kColors.end()));
  }
}

TEST(X11Presenter, PicturesFillAWindowOfAnotherSize) {
  RUN_ON_X11_DISPLAY("");
  const auto window = open_shared(true);
  ASSERT_NE(window, nullptr);
  ScreenReader screen;
  Shower shower;
  for (const PixelSize size : {PixelSize{700, 500}, PixelSize{620, 380}}) {
    ASSERT_TRUE(window->apply({.size = size}).ok());
    // Until the window has its new size.
    for (int i = 0; i < 20; ++i) shower.show(*window, kColors[0], {320, 200});
    EXPECT_EQ(window->size(), size);
    shower.show(*window, kColors[1], {320, 200});
    EXPECT_EQ(screen.read(), std::set<std::uint32_t>{kColors[1]});
  }
}

// Shows pictures through SDL's surface instead.
TEST(X11Presenter, AServerWithoutSharedMemoryHasNoVsync) {
  RUN_ON_X11_DISPLAY("-extension MIT-SHM");
  const auto window = open_shared(true);
  ASSERT_NE(window, nullptr);
  EXPECT_THAT(window->describe(), HasSubstr("without vsync"));
  ScreenReader screen;
  Shower shower;
  for (int i = 0; i < 5; ++i) shower.show(*window, kColors[i % 2 == 0 ? 0 : 2]);
  EXPECT_EQ(screen.read(), std::set<std::uint32_t>{kColors[0]});
}

}  // namespace
}  // namespace temblor::platform::sdl2
