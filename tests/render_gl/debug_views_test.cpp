// The debug views of `--show` over pictures of the graphics card.
#include <gtest/gtest.h>

#include <limits>

#include "render_gl/model_scenes.h"
#include "support/pictures/viewpoints.h"

namespace temblor::render_gl {
namespace {

// They come from the CPU's stages, so they are equal.
TEST(GlDebugViews, AreThoseOfTheCpu) {
  using render::Show;
  const test::DrawableLevel small = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, small);
  test::Random random(7);
  const test::Viewpoint viewpoint{.camera = test::random_camera(*small.level, random),
                                  .brush_models = test::shown_brush_models(*small.level)};
  for (const Show show :
       {Show::kFaces, Show::kEdges, Show::kSpans, Show::kSurfaces, Show::kMips, Show::kPvs, Show::kOverdraw})
    EXPECT_GE(pair.compare(viewpoint.scene(*small.level), {.show = show}), 0.999) << static_cast<int>(show);
}

// The share of pixels whose depth differs by less than a thousandth, or where nothing was drawn by both.
double compare_depth(const RendererPair& pair) {
  const auto cpu = pair.cpu_frame().depth(), card = pair.gl_frame().depth();
  std::size_t equal = 0;
  for (std::size_t i = 0; i < cpu.size(); ++i)
    equal += cpu[i] == card[i] || std::abs(cpu[i] - card[i]) < 1e-3f * std::abs(cpu[i]) ? 1 : 0;
  return static_cast<double>(equal) / static_cast<double>(cpu.size());
}

// The level, models, and a weapon; in both projections, and without glClipControl.
TEST(GlDebugViews, ShowTheDepth) {
  const test::DrawableLevel small = test::small_level();
  for (const ClipControl clip_control : {ClipControl::kIfSupported, ClipControl::kNo}) {
    RENDERER_PAIR_OR_SKIP(pair, small, clip_control);
    test::Random random(8);
    for (int view = 0; view < 8; ++view) {
      ModelScene scene = random_scene(make_small_models(), *small.level, 3, random);
      if (view % 2 == 1) scene.weapon = scene.instances.back();
      render::Scene drawn = scene.scene(*small.level);
      drawn.underwater = view == 2;  // the view of depth is not warped
      if (view == 3) drawn.camera.projection = render::Projection::kOrthographic;
      pair.set_format(view % 4 == 0 ? render::PixelFormat::kIndexed : render::PixelFormat::kRgb);
      EXPECT_GE(pair.compare(drawn, {.show = render::Show::kDepth}), 0.99) << view;
      EXPECT_GE(compare_depth(pair), 0.99) << view;
    }
  }
}

}  // namespace
}  // namespace temblor::render_gl
