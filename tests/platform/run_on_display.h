// Tests of windows on a real X server (Xvfb).
#pragma once

#include <gtest/gtest.h>
#include <xcb/xcb.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

// Runs the test that uses this again on a display of its own, and returns.
#define RUN_ON_X11_DISPLAY(server_options)                                                              \
  if (std::system("command -v xvfb-run xauth >/dev/null") != 0)                                         \
    GTEST_SKIP() << "a display (xvfb, xauth) is not installed";                                         \
  if (std::getenv("TEMBLOR_TEST_DISPLAY") == nullptr) {                                                 \
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();                  \
    const ::testing::TestInfo& info = *::testing::UnitTest::GetInstance()->current_test_info();         \
    const std::string line = "TEMBLOR_TEST_DISPLAY=1 '" TEMBLOR_SOURCE_DIR                              \
                             "/tests/support/on_display.sh"                                             \
                             "' '1024x768x24 " +                                                        \
                             std::string(server_options) + "' '" + self +                               \
                             "' --gtest_filter=" + info.test_suite_name() + "." + info.name() + " >&2"; \
    EXPECT_EQ(std::system(line.c_str()), 0);                                                            \
    return;                                                                                             \
  }

namespace temblor::platform::sdl2 {

// Reads the pixels in the middle of the screen, where the window is, through a connection of its own.
class ScreenReader {
 public:
  static constexpr std::uint16_t kWidth = 600, kHeight = 360;

  ~ScreenReader() { xcb_disconnect(connection_); }

  // Returns each color that the screen shows there.
  std::set<std::uint32_t> read() const {
    const xcb_screen_t& screen = *xcb_setup_roots_iterator(xcb_get_setup(connection_)).data;
    const auto left = static_cast<std::int16_t>((screen.width_in_pixels - kWidth) / 2);
    const auto top = static_cast<std::int16_t>((screen.height_in_pixels - kHeight) / 2);
    const auto asked =
        xcb_get_image(connection_, XCB_IMAGE_FORMAT_Z_PIXMAP, screen.root, left, top, kWidth, kHeight, ~0u);
    const std::unique_ptr<xcb_get_image_reply_t, decltype(&std::free)> image(
        xcb_get_image_reply(connection_, asked, nullptr), &std::free);
    if (!image) return {};
    std::vector<std::uint32_t> pixels(std::size_t{kWidth} * kHeight);
    std::memcpy(pixels.data(), xcb_get_image_data(image.get()), pixels.size() * sizeof(std::uint32_t));
    std::set<std::uint32_t> colors;
    for (const std::uint32_t pixel : pixels) colors.insert(pixel | 0xff000000);
    return colors;
  }

  // Reads until the screen shows these colors, for at most two seconds.
  std::set<std::uint32_t> read_until(const std::set<std::uint32_t>& wanted) const {
    std::set<std::uint32_t> colors = read();
    for (int i = 0; i < 100 && colors != wanted; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      colors = read();
    }
    return colors;
  }

 private:
  xcb_connection_t* connection_ = xcb_connect(nullptr, nullptr);
};

}  // namespace temblor::platform::sdl2
