// The debug views of `--show` over pictures of the graphics card.
#include <gtest/gtest.h>

#include "render_gl/gl_pictures.h"
#include "support/pictures/viewpoints.h"

namespace temblor::render_gl {
namespace {

// They come from the CPU's stages, so they are equal, except for the depth, which the card keeps.
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

}  // namespace
}  // namespace temblor::render_gl
