// `vid_renderer gl` in a game: the same picture, and the CPU's if OpenGL fails, at any time.
#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "host/headless_host.h"
#include "platform/egl/offscreen_context.h"
#include "support/pictures/frames.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

// No test can go on without OpenGL.
#define SKIP_WITHOUT_OPENGL()                                                      \
  if (const auto context = platform::egl::make_offscreen_context(); !context.ok()) \
  GTEST_SKIP() << "no OpenGL: " << context.error().what

std::string renderer(const HeadlessHost& game) {
  return game.variables().uses_gl() ? "gl" : "cpu";
}

// Starts a game whose picture does not move.
void start_still_game(HeadlessHost& io_game) {
  ASSERT_TRUE(io_game.run_until_playing());
  io_game.run(1.5);  // until the console has closed
  io_game.command("host_timescale 0.001");
  io_game.run(0.05, 0.01);
}

TEST(GlView, ShowsTheCpusPictureInAGame) {
  SKIP_WITHOUT_QUAKEC();
  SKIP_WITHOUT_OPENGL();
  HeadlessHost game({"viewsize 120; con_notifylines 0", "map small"}, {640, 400});
  game.set_open_gl(platform::egl::make_offscreen_context);
  start_still_game(game);
  const std::vector<std::uint32_t> cpu = game.window().shown();
  for (int round = 0; round < 3; ++round) {
    game.command("vid_renderer gl");
    game.run(0.01, 0.01);
    EXPECT_GE(equal_share(game.window().shown(), cpu, 2), 0.99);
    EXPECT_EQ(renderer(game), "gl");
    game.command("vid_renderer cpu");
    game.run(0.01, 0.01);
    EXPECT_GE(equal_share(game.window().shown(), cpu, 2), 0.999);
  }
}

TEST(GlView, ShowsTheCpusPictureIn256Colors) {
  SKIP_WITHOUT_QUAKEC();
  SKIP_WITHOUT_OPENGL();
  HeadlessHost game({"viewsize 120; con_notifylines 0", "map small"}, {640, 400});
  game.set_open_gl(platform::egl::make_offscreen_context);
  start_still_game(game);
  const auto show = [&](const char* name, const char* color) {
    game.command(std::string("vid_renderer ") + name + "; vid_color " + color);
    game.run(0.01, 0.01);
    EXPECT_EQ(renderer(game), name);
    return game.window().shown();
  };
  const std::vector<std::uint32_t> indexed = show("cpu", "indexed"), rgb = show("cpu", "rgb");
  EXPECT_LT(equal_share(indexed, rgb, 2), 0.9);
  for (int round = 0; round < 2; ++round) {
    EXPECT_GE(equal_share(show("gl", "indexed"), indexed, 0), 0.99);
    EXPECT_GE(equal_share(show("gl", "rgb"), rgb, 2), 0.99);
  }
}

TEST(GlView, DrawsInWindowsOfAllSizes) {
  SKIP_WITHOUT_QUAKEC();
  SKIP_WITHOUT_OPENGL();
  HeadlessHost game({"vid_renderer gl", "map small"});
  game.set_open_gl(platform::egl::make_offscreen_context);
  ASSERT_TRUE(game.run_until_playing());
  for (const platform::PixelSize size :
       {platform::PixelSize{1, 1}, {1, 300}, {300, 1}, {640, 480}, {333, 77}}) {
    ASSERT_TRUE(game.window().apply({.size = size}).ok());
    game.run(0.03);
    EXPECT_EQ(game.window().shown_size(), size);
  }
  EXPECT_EQ(renderer(game), "gl");
}

// Both windows of one process have a context, and one of them ends first.
TEST(GlView, DrawsInTwoWindowsAtOnce) {
  SKIP_WITHOUT_QUAKEC();
  SKIP_WITHOUT_OPENGL();
  const std::vector<std::string> settings = {"viewsize 120; con_notifylines 0", "map small"};
  HeadlessHost first(settings);
  first.set_open_gl(platform::egl::make_offscreen_context);
  start_still_game(first);
  const std::vector<std::uint32_t> cpu = first.window().shown();
  const auto shows_the_game = [&](HeadlessHost& game) {
    game.run(0.01, 0.01);
    return renderer(game) == "gl" && equal_share(game.window().shown(), cpu, 2) >= 0.99;
  };
  first.command("vid_renderer gl");
  {
    HeadlessHost second(settings);
    second.set_open_gl(platform::egl::make_offscreen_context);
    start_still_game(second);
    second.command("vid_renderer gl");
    for (int round = 0; round < 3; ++round) {
      EXPECT_TRUE(shows_the_game(first)) << round;
      EXPECT_TRUE(shows_the_game(second)) << round;
    }
  }
  EXPECT_TRUE(shows_the_game(first));
}

TEST(GlView, LeavesTheCpuWhereOpenGlIsMissing) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.command("vid_renderer gl");
  game.run(0.05);
  EXPECT_TRUE(game.has_printed("OpenGL is missing; the CPU draws"));
  EXPECT_EQ(renderer(game), "cpu");
}

// The number of calls of glGetError until the card reports that it has no memory left; negative: never.
std::atomic<int> calls_until_failure = -1;

GLenum GL_APIENTRY fail_later() {
  const int left = calls_until_failure;
  if (left < 0) return GL_NO_ERROR;
  if (left == 0) return GL_OUT_OF_MEMORY;
  --calls_until_failure;
  return GL_NO_ERROR;
}

// A context whose glGetError is fail_later().
class FailingContext final : public platform::GlContext {
 public:
  explicit FailingContext(std::unique_ptr<platform::GlContext> real) : real_(std::move(real)) {}
  base::Status make_current() override { return real_->make_current(); }
  void* find_function(const char* name) const override {
    if (std::string_view(name) == "glGetError") return reinterpret_cast<void*>(fail_later);
    return real_->find_function(name);
  }

 private:
  std::unique_ptr<platform::GlContext> real_;
};

base::Result<std::unique_ptr<platform::GlContext>> open_failing_context() {
  TRY(std::unique_ptr<platform::GlContext> real, platform::egl::make_offscreen_context());
  return std::unique_ptr<platform::GlContext>(std::make_unique<FailingContext>(std::move(real)));
}

// Wherever the failure comes, at the start or in the middle of a game, every frame shows the game.
TEST(GlView, GoesOnWithTheCpuIfTheCardFails) {
  SKIP_WITHOUT_QUAKEC();
  SKIP_WITHOUT_OPENGL();
  HeadlessHost game({"viewsize 120; con_notifylines 0", "map small"});
  game.set_open_gl(open_failing_context);
  start_still_game(game);
  const std::vector<std::uint32_t> cpu = game.window().shown();
  for (const int calls : {0, 1, 2, 3, 5, 8, 13, 21}) {
    calls_until_failure = calls;
    game.command("vid_renderer gl");
    for (int frame = 0; frame < 20; ++frame) {
      game.run(0.01, 0.01);
      EXPECT_GE(equal_share(game.window().shown(), cpu, 2), 0.99) << calls << " calls, frame " << frame;
    }
    EXPECT_EQ(renderer(game), "cpu") << calls << " calls";
  }
  EXPECT_TRUE(game.has_printed("the graphics card is out of memory; the CPU draws"));
}

}  // namespace
}  // namespace temblor::test
