// The card's own times of frames.
#include <gtest/gtest.h>

#include <chrono>

#include "render_gl/gl_pictures.h"
#include "render_gl/scene_views.h"

namespace temblor::render_gl {
namespace {

TEST(CardTimer, ReportsTimesOfFrames) {
  const test::DrawableLevel level = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, level);
  GlRenderer& gl = pair.gl();
  EXPECT_FALSE(gl.card_seconds()) << "nothing has been drawn";
  test::Random random(1);
  const SceneView view = any_view(*level.level, random);
  render::FrameBuffer frame(640, 480, render::PixelFormat::kRgb);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(gl.draw(view.scene, {}, frame).ok());
    ASSERT_TRUE(gl.draw_overlay({{{.area = {0, 0, 9, 9}, .fill = 3}}}, frame).ok());
    ASSERT_TRUE(gl.read(frame).ok());
  }
  const double all_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!gl.card_seconds()) GTEST_SKIP() << "the card has no timer";
  EXPECT_GT(*gl.card_seconds(), 0.0);
  EXPECT_LT(*gl.card_seconds(), all_s);
}

}  // namespace
}  // namespace temblor::render_gl
