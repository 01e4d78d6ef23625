// Several renderers in one process, each with its own context.
#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <thread>

#include "platform/egl/offscreen_context.h"
#include "render_gl/gl_renderer.h"
#include "render_gl/scene_views.h"
#include "support/effort.h"
#include "support/levels/drawable_level.h"

namespace temblor::render_gl {
namespace {

using Picture = std::vector<std::uint32_t>;

// A renderer and its context, as a window would have them.
class OwnContext {
 public:
  // CHECKs that there is OpenGL.
  explicit OwnContext(const test::DrawableLevel& level)
      : context_(platform::egl::make_offscreen_context().value()),
        renderer_(GlRenderer::make([this](const char* name) { return context_->find_function(name); },
                                   level.palette, level.colormap)
                      .value()),
        level_(level) {}
  ~OwnContext() { CHECK(context_->make_current().ok()); }

  Picture draw(std::uint64_t number) {
    CHECK(context_->make_current().ok());
    test::Random random(number);
    SceneView view = any_view(*level_.level, random);
    view.scene.underwater = number % 3 == 0;
    render::FrameBuffer frame(160, 120, render::PixelFormat::kRgb);
    CHECK(renderer_.render(view.scene, {}, frame).ok());
    return {frame.rgb().begin(), frame.rgb().end()};
  }

 private:
  std::unique_ptr<platform::GlContext> context_;
  GlRenderer renderer_;
  const test::DrawableLevel& level_;
};

class Contexts : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto context = platform::egl::make_offscreen_context(); !context.ok())
      GTEST_SKIP() << "no OpenGL: " << context.error().what;
    for (const test::DrawableLevel& level : levels_) {
      OwnContext alone(level);
      for (std::uint64_t number = 0; number < kPictures; ++number) alone_.push_back(alone.draw(number));
    }
  }

  // The picture that level `level` shows without another context.
  const Picture& alone(std::size_t level, std::uint64_t number) const {
    return alone_[level * kPictures + number];
  }

  static constexpr std::uint64_t kPictures = test::effort(20, 4);
  const std::vector<test::DrawableLevel> levels_ = {test::small_level(),
                                                    test::small_level({.seed = 2}, "other")};
  std::vector<Picture> alone_;
};

TEST_F(Contexts, DrawInTurns) {
  OwnContext first(levels_[0]);
  OwnContext second(levels_[1]);
  for (std::uint64_t number = 0; number < kPictures; ++number) {
    EXPECT_EQ(first.draw(number), alone(0, number));
    EXPECT_EQ(second.draw(number), alone(1, number));
  }
}

// The end of one does not take the other's context away.
TEST_F(Contexts, OutliveOthers) {
  const std::unique_ptr<platform::GlContext> other = platform::egl::make_offscreen_context().value();
  std::unique_ptr<platform::GlContext> brief = platform::egl::make_offscreen_context().value();
  ASSERT_TRUE(other->make_current().ok());
  brief.reset();
  const auto get_string = reinterpret_cast<decltype(&glGetString)>(other->find_function("glGetString"));
  EXPECT_NE(get_string(GL_VERSION), nullptr);
}

TEST_F(Contexts, DrawOnTwoThreadsAtOnce) {
  std::vector<std::vector<Picture>> drawn(levels_.size());
  std::vector<std::thread> threads;
  for (std::size_t level = 0; level < levels_.size(); ++level)
    threads.emplace_back([&, level] {
      OwnContext own(levels_[level]);
      for (std::uint64_t number = 0; number < kPictures; ++number) drawn[level].push_back(own.draw(number));
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t level = 0; level < levels_.size(); ++level)
    for (std::uint64_t number = 0; number < kPictures; ++number)
      EXPECT_EQ(drawn[level][number], alone(level, number)) << level << ", " << number;
}

}  // namespace
}  // namespace temblor::render_gl
