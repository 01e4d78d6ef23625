// `vid_renderer gl` in a window that OpenGL draws into: the CPU's picture, without a copy of it.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "formats/images/image.h"
#include "host/headless_host.h"
#include "host/video/window_gl.h"
#include "platform/egl/offscreen_context.h"
#include "support/game_data.h"
#include "support/pictures/frames.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

class GlWindow : public testing::Test {
 protected:
  void SetUp() override {
    SKIP_WITHOUT_QUAKEC();
    if (const auto context = platform::egl::make_offscreen_context(); !context.ok())
      GTEST_SKIP() << "no OpenGL: " << context.error().what;
    game_.emplace(std::vector<std::string>{"viewsize 100; con_notifylines 0", "map small"},
                  platform::PixelSize{640, 400});
    game_->window().set_open_gl(make_window_gl(game_->window(), shown_));
    ASSERT_TRUE(game_->run_until_playing());
    game_->run(1.5);  // until the console has closed
    game_->command("host_timescale 0.001");
    game_->run(0.05, 0.01);
  }
  void TearDown() override {
    game_.reset();
    EXPECT_EQ(shown_.contexts, 0);
  }

  void command(std::string_view line) {
    game_->command(line);
    game_->run(0.01, 0.01);
  }
  std::vector<std::uint32_t> show_on_cpu() {
    command("vid_renderer cpu");
    EXPECT_EQ(shown_.contexts, 0) << "the context must be gone before the window shows a picture";
    return game_->window().shown();
  }
  // The picture that OpenGL has drawn into the window.
  std::vector<std::uint32_t> show_on_card() {
    const int before = shown_.pictures;
    const std::uint64_t presented = game_->window().pictures();
    command("vid_renderer gl");
    EXPECT_GT(shown_.pictures, before);
    EXPECT_EQ(game_->window().pictures(), presented) << "nothing is copied to the window";
    return shown_.pixels;
  }
  // How much of the two is equal, up to rounding.
  double compare() {
    const std::vector<std::uint32_t> cpu = show_on_cpu();
    return equal_share(show_on_card(), cpu, 2);
  }

  ShownByGl shown_;
  std::optional<HeadlessHost> game_;
};

TEST_F(GlWindow, ShowsTheCpusPicture) {
  for (int round = 0; round < 3; ++round) EXPECT_GE(compare(), 0.99);
  EXPECT_EQ(shown_.opened, 3);
}

TEST_F(GlWindow, ShowsMenusAndTheConsole) {
  for (const char* const page : {"menu_main", "menu_video", "menu_keys", "menu_levels", "toggleconsole"}) {
    command(page);
    game_->run(1, 0.1);
    EXPECT_GE(compare(), 0.99) << page;
    game_->press(platform::Key::kEscape);
    game_->release(platform::Key::kEscape);
    game_->run(1, 0.1);
  }
}

// The console over all of the screen, without a game.
TEST_F(GlWindow, ShowsTheConsoleWithoutAView) {
  command("disconnect");
  game_->run(2);
  EXPECT_GE(compare(), 0.999);
}

TEST_F(GlWindow, HasTheToneAndTheColorsOfTheCpu) {
  for (const char* const settings : {"gamma 0.7; contrast 1.2; brightness 0.05", "vid_color indexed",
                                     "gamma 1; contrast 1; brightness 0"}) {
    command(settings);
    EXPECT_GE(compare(), 0.99) << settings;
  }
  command("bf");  // a tint, which indexed frames have in the palette
  EXPECT_GE(compare(), 0.98);
}

TEST_F(GlWindow, FillsWindowsOfAllSizes) {
  command("vid_renderer gl");
  for (const platform::PixelSize size :
       {platform::PixelSize{1, 1}, {1, 300}, {300, 1}, {1000, 700}, {333, 77}, {640, 400}})
    for (const char* const scale : {"1", "0.5"}) {
      ASSERT_TRUE(game_->window().apply({.size = size}).ok());
      command(std::string("vid_render_scale ") + scale);
      EXPECT_EQ(shown_.size, size);
    }
  command("vid_render_scale 1");
  EXPECT_GE(compare(), 0.99);
}

// Screenshots, and pictures of saved games, are read back.
TEST_F(GlWindow, ReadsPicturesThatFilesNeed) {
  command("gamma 0.8");
  command("vid_renderer cpu; screenshot cpu");
  command("vid_renderer gl");
  command("screenshot gl");
  const auto read = [&](const char* name) {
    return formats::read_png(read_file(game_->folder().path() / "id1" / name)).value();
  };
  const formats::Image cpu = read("cpu.png"), gl = read("gl.png");
  ASSERT_EQ(gl.pixels.size(), 640u * 400u);
  EXPECT_GE(equal_share(gl.pixels, cpu.pixels, 2), 0.99);
  command("save one");
  game_->run(0.1);
  EXPECT_TRUE(std::filesystem::exists(game_->folder().path() / "id1" / "one.png"));
}

TEST_F(GlWindow, DrawsDebugViewsAndTechniques) {
  for (const char* const settings : {"r_show faces", "r_show mips", "r_show picture"}) {
    command(settings);
    EXPECT_GE(compare(), 0.99) << settings;
  }
  show_on_card();
  command("r_technique z-buffer");
  EXPECT_EQ(shown_.contexts, 0) << "techniques draw on the CPU";
  command("r_technique bsp-edges");
  EXPECT_EQ(shown_.contexts, 1);
}

TEST_F(GlWindow, ChoosesTheWayToTheWindow) {
  game_->set_open_gl(platform::egl::make_offscreen_context);
  shown_.is_software = true;
  const auto draws_into_window = [&] {
    game_->run(0.02, 0.01);
    EXPECT_TRUE(game_->variables().uses_gl());
    return shown_.contexts == 1;
  };
  command("vid_renderer gl");
  EXPECT_FALSE(draws_into_window()) << "a software driver copies faster";
  command("vid_gl_window on");
  EXPECT_TRUE(draws_into_window());
  command("vid_gl_window off");
  EXPECT_FALSE(draws_into_window());
  shown_.is_software = false;
  command("vid_gl_window auto");
  EXPECT_TRUE(draws_into_window());
}

// Wherever the failure comes, the next frames are the CPU's, in the same window.
TEST_F(GlWindow, GoesOnWithTheCpuIfTheCardFails) {
  const std::vector<std::uint32_t> cpu = show_on_cpu();
  for (const int calls : {1, 3, 10, 15, 16, 17, 18, 19, 20, 21, 22, 30}) {
    shown_.calls_until_failure = calls;
    command("vid_renderer gl");
    game_->run(0.2, 0.01);
    EXPECT_FALSE(game_->variables().uses_gl()) << calls << " calls";
    EXPECT_EQ(shown_.contexts, 0) << calls << " calls";
    EXPECT_GE(equal_share(game_->window().shown(), cpu, 2), 0.99) << calls << " calls";
  }
  EXPECT_TRUE(game_->has_printed("the graphics card is out of memory; the CPU draws"));
  shown_.calls_until_failure = -1;
  EXPECT_GE(compare(), 0.99);
}

// A frame that fails has no pixels; the next one is the CPU's.
TEST_F(GlWindow, SavesNoPictureOfAFrameThatFailed) {
  show_on_card();
  shown_.calls_until_failure = 0;
  command("vid_renderer cpu; vid_renderer gl");
  ASSERT_TRUE(game_->window().apply({.size = {320, 200}}).ok());
  command("save x");
  game_->run(0.1, 0.01);
  const auto picture = formats::read_png(read_file(game_->folder().path() / "id1" / "x.png"));
  ASSERT_TRUE(picture.ok());
  EXPECT_GT(std::set<std::uint32_t>(picture->pixels.begin(), picture->pixels.end()).size(), 10u);
}

TEST_F(GlWindow, SaysWhyItCopies) {
  game_->set_open_gl(platform::egl::make_offscreen_context);
  game_->window().set_open_gl(nullptr);
  command("vid_gl_window on; vid_renderer gl");
  EXPECT_TRUE(game_->variables().uses_gl());
  EXPECT_TRUE(game_->has_printed("OpenGL's picture is copied to the window: there is no display"));
}

// Another mod has other data, and another context in the same window.
TEST_F(GlWindow, StaysWhenTheGameChanges) {
  game_->folder().write("mod/autoexec.cfg", std::string_view("con_notifylines 0\n"));
  show_on_card();
  command("game mod");
  game_->run(0.1);
  EXPECT_EQ(shown_.contexts, 1);
  EXPECT_EQ(shown_.opened, 2);
  const int before = shown_.pictures;
  game_->run(0.1);
  EXPECT_GT(shown_.pictures, before);
}

}  // namespace
}  // namespace temblor::test
