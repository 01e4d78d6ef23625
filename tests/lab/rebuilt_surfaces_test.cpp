// Surfaces that are built again although they are in the cache.
#include <gtest/gtest.h>

#include "lab/lit_pictures.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

class RebuiltSurfaces : public testing::Test {
 protected:
  RebuiltSurfaces() : random_(5), view_(make_lit_view(*drawable_.level, PixelFormat::kRgb, random_)) {}

  // Draws the view again and again. Returns the texels that each frame builds.
  std::vector<std::uint64_t> draw_frames(const char* technique, int frames) {
    render::Renderer renderer(drawable_.palette, drawable_.colormap);
    if (technique != nullptr) renderer.replace_stages(lab::parse_choice(technique).value().make_stages());
    render::FrameBuffer frame(333, 203, PixelFormat::kRgb);
    std::vector<std::uint64_t> built;
    for (int i = 0; i < frames; ++i) {
      const render::FrameStats stats = renderer.render(view_.scene(*drawable_.level), {}, frame);
      built.push_back(stats.texels_built);
      texels_read_ = stats.texels_read;
    }
    return built;
  }

  const DrawableLevel drawable_ = small_level();
  Random random_;
  const Viewpoint view_;
  std::uint64_t texels_read_ = 0;
};

TEST_F(RebuiltSurfaces, AreAllBuiltInEachFrame) {
  const std::vector<std::uint64_t> engine = draw_frames(nullptr, 3), all = draw_frames("rebuilt-surfaces", 3);
  EXPECT_EQ(engine[1], 0u);
  EXPECT_EQ(engine[0], texels_read_);
  for (const std::uint64_t built : all) EXPECT_EQ(built, texels_read_);
}

TEST_F(RebuiltSurfaces, TakeTurns) {
  const std::vector<std::uint64_t> built = draw_frames("rebuilt-surfaces:every=3", 7);
  EXPECT_EQ(built[0], texels_read_);
  for (const std::size_t i : {1, 2, 3, 4}) {
    EXPECT_GT(built[i], 0u);
    EXPECT_EQ(built[i] + built[i + 1] + built[i + 2], texels_read_);
  }
}

TEST(RebuiltSurfacesPictures, AreTheEngines) {
  const DrawableLevel drawable = small_level();
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb})
    for (const char* const technique : {"rebuilt-surfaces", "rebuilt-surfaces:every=2"}) {
      LitPictures engine(drawable, nullptr, format), rebuilt(drawable, technique, format);
      for (int seed = 0; seed < effort(20, 3); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Viewpoint view = make_lit_view(*drawable.level, format, random);
        const render::Scene scene = view.scene(*drawable.level);
        render::Settings settings{.surface_cache = random.chance(0.8)};
        settings.caustics = random.chance(0.5);
        for (int frame = 0; frame < 2; ++frame)
          EXPECT_EQ(differing_pixels(engine.draw(scene, settings), rebuilt.draw(scene, settings)), 0u)
              << technique << ", seed " << seed;
      }
    }
}

TEST(RebuiltSurfacesPictures, AreTheSameForAnyThreadsAndBands) {
  expect_same_for_any_threads("rebuilt-surfaces:every=2");
}

TEST(RebuiltSurfacesPictures, AllocateNothingInAWarmFrame) {
  expect_no_allocations_in_a_warm_frame("rebuilt-surfaces");
}

}  // namespace
}  // namespace temblor::test
