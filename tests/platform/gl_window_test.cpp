// OpenGL that draws into windows of a real X server (Xvfb).
#include <GLES3/gl3.h>
#include <gtest/gtest.h>
#include <xcb/xcb.h>

#include <optional>

#include "platform/run_on_display.h"
#include "platform/sdl2/window.h"

namespace temblor::platform::sdl2 {
namespace {

constexpr PixelSize kGlSize{640, 400};

// A window, and what the test does with its context.
class ClearedWindow {
 public:
  explicit ClearedWindow(const WindowSettings& settings = {.size = kGlSize},
                         Presenter presenter = Presenter::kRenderer) {
    auto opened = open_window("OpenGL", settings, presenter);
    EXPECT_TRUE(opened.ok()) << opened.error().message();
    if (opened.ok()) window_ = std::move(*opened);
  }
  Window& window() { return *window_; }
  bool has_context() const { return context_ != nullptr; }

  base::Status open() {
    TRY(context_, window_->open_gl());
    clear_color_ = reinterpret_cast<PFNGLCLEARCOLORPROC>(context_->find_function("glClearColor"));
    clear_ = reinterpret_cast<PFNGLCLEARPROC>(context_->find_function("glClear"));
    return base::Ok{};
  }
  void close() { context_.reset(); }

  // Fills the window by OpenGL.
  void clear(float r, float g, float b) {
    poll();
    ASSERT_TRUE(context_->make_current().ok());
    clear_color_(r, g, b, 1);
    clear_(GL_COLOR_BUFFER_BIT);
    context_->show();
  }
  // Fills the window with a picture of one color.
  void present(std::uint32_t color) {
    poll();
    const PixelSize size = window_->size();
    const std::vector<std::uint32_t> pixels(static_cast<std::size_t>(size.width * size.height), color);
    const base::Status shown = window_->present({pixels, size}, jobs_);
    ASSERT_TRUE(shown.ok()) << shown.error().message();
  }

 private:
  void poll() {
    std::vector<InputEvent> events;
    window_->poll(events);
  }

  base::Jobs jobs_{1};
  std::unique_ptr<Window> window_;
  std::unique_ptr<WindowGlContext> context_;
  PFNGLCLEARCOLORPROC clear_color_ = nullptr;
  PFNGLCLEARPROC clear_ = nullptr;
};

#define OPEN_GL_OR_SKIP(cleared) \
  if (const base::Status opened = (cleared).open(); !opened.ok()) GTEST_SKIP() << opened.error().message()

using Colors = std::set<std::uint32_t>;
constexpr std::uint32_t kRed = 0xffff0000, kGreen = 0xff00ff00, kBlue = 0xff0000ff;

TEST(GlWindow, ShowsWhatOpenGlDraws) {
  RUN_ON_X11_DISPLAY("");
  ClearedWindow cleared;
  OPEN_GL_OR_SKIP(cleared);
  const ScreenReader screen;
  for (int i = 0; i < 3; ++i) {
    cleared.clear(1, 0, 0);
    EXPECT_EQ(screen.read_until({kRed}), Colors{kRed});
    cleared.clear(0, 0, 1);
    EXPECT_EQ(screen.read_until({kBlue}), Colors{kBlue});
  }
}

// The presenter and the context share the window in turns.
TEST(GlWindow, TakesTurnsWithPictures) {
  RUN_ON_X11_DISPLAY("");
  for (const Presenter presenter : {Presenter::kRenderer, Presenter::kAuto}) {
    ClearedWindow cleared({.size = kGlSize}, presenter);
    const ScreenReader screen;
    for (int i = 0; i < 3; ++i) {
      cleared.present(kGreen);
      EXPECT_EQ(screen.read_until({kGreen}), Colors{kGreen});
      OPEN_GL_OR_SKIP(cleared);
      cleared.clear(1, 0, 0);
      EXPECT_EQ(screen.read_until({kRed}), Colors{kRed});
      cleared.close();
    }
  }
}

TEST(GlWindow, KeepsItsContextWhenTheWindowChanges) {
  RUN_ON_X11_DISPLAY("");
  ClearedWindow cleared;
  OPEN_GL_OR_SKIP(cleared);
  const ScreenReader screen;
  const WindowMode modes[] = {WindowMode::kBorderless, WindowMode::kWindowed, WindowMode::kFullScreen,
                              WindowMode::kWindowed};
  for (const WindowMode mode : modes)
    for (const bool vsync : {false, true}) {
      ASSERT_TRUE(cleared.window().apply({.size = {700, 500}, .mode = mode, .vsync = vsync}).ok());
      cleared.clear(1, 0, 0);
      cleared.clear(0, 1, 0);
      EXPECT_EQ(screen.read_until({kGreen}), Colors{kGreen});
    }
  EXPECT_TRUE(cleared.has_context());
}

TEST(GlWindow, TwoWindowsHaveAContextEach) {
  RUN_ON_X11_DISPLAY("");
  ClearedWindow below;
  OPEN_GL_OR_SKIP(below);
  const ScreenReader screen;
  {
    ClearedWindow above;
    OPEN_GL_OR_SKIP(above);
    for (int i = 0; i < 3; ++i) {
      below.clear(1, 0, 0);
      above.clear(0, 0, 1);
      EXPECT_EQ(screen.read_until({kBlue}), Colors{kBlue});
    }
  }
  below.clear(0, 1, 0);
  EXPECT_EQ(screen.read_until({kGreen}), Colors{kGreen});
}

TEST(GlWindow, IsRefusedByWindowsForSharedMemory) {
  RUN_ON_X11_DISPLAY("");
  ClearedWindow cleared({.size = kGlSize}, Presenter::kSharedMemory);
  const base::Status opened = cleared.open();
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().code, base::ErrorCode::kUnsupported);
  cleared.present(kGreen);
  EXPECT_EQ(ScreenReader().read_until({kGreen}), Colors{kGreen});
}

}  // namespace
}  // namespace temblor::platform::sdl2
