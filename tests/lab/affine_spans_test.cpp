// Textures without perspective: against the engine's own pictures, and the error by its definition.
#include <gtest/gtest.h>

#include "lab/registry.h"
#include "render/renderer.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

struct Drawn {
  FrameCopy picture;
  lab::Counts counts;
};

// `technique` may be empty for the engine's own stages.
Drawn draw_small_level(const std::string& technique, const render::Settings& settings,
                       render::PixelFormat format) {
  const DrawableLevel drawable = small_level();
  render::Renderer renderer(drawable.palette, drawable.colormap);
  lab::Counter counter;
  if (!technique.empty()) {
    const base::Result<lab::Choice> choice = lab::parse_choice(technique);
    CHECK(choice.ok(), "{}", technique);
    renderer.replace_stages(choice->make_stages(&counter));
  }
  render::FrameBuffer frame(320, 200, format);
  Viewpoint viewpoint{.camera = player_cameras(*drawable.level).front()};
  viewpoint.camera.angles_deg.x = 20;  // more of the floor
  renderer.render(viewpoint.scene(*drawable.level), settings, frame);
  return {copy_picture(frame), counter.take()};
}

TEST(AffineSpans, AreTheEnginesWithItsDistances) {
  for (const auto format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
    EXPECT_EQ(draw_small_level("affine-spans:pixels=1", {}, format).picture,
              draw_small_level("", {}, format).picture);
    EXPECT_EQ(draw_small_level("affine-spans:pixels=16", {}, format).picture,
              draw_small_level("", {.perspective = render::Perspective::kEvery16}, format).picture);
  }
}

TEST(AffineSpans, ErrorsGrowWithTheDistance) {
  lab::Counts before;
  for (const int pixels : {1, 8, 16, 32, 8192}) {
    const lab::Counts counts = draw_small_level(fmt::format("affine-spans:pixels={}", pixels),
                                                {.force_mip = 0}, render::PixelFormat::kIndexed)
                                   .counts;
    if (pixels == 1) {
      EXPECT_EQ(counts.pixels_off, 0u);
      EXPECT_EQ(counts.max_texel_error, 0.0);
    } else {
      EXPECT_GT(counts.pixels_off, before.pixels_off) << pixels;
      EXPECT_GE(counts.max_texel_error, before.max_texel_error) << pixels;
    }
    before = counts;
  }
  EXPECT_GT(before.max_texel_error, 5.0) << "the floor bends";
}

// The technique is the same for any number of threads.
TEST(AffineSpans, AreTheSameOnTwoThreads) {
  const render::Settings threads{.threads = 2, .job_backend = base::JobBackend::kStdThread, .band_rows = 7};
  for (const char* technique : {"affine-spans", "affine-spans:pixels=8"}) {
    const Drawn one = draw_small_level(technique, {}, render::PixelFormat::kRgb);
    const Drawn two = draw_small_level(technique, threads, render::PixelFormat::kRgb);
    EXPECT_EQ(one.picture, two.picture);
    EXPECT_EQ(one.counts.pixels_off, two.counts.pixels_off);
  }
}

}  // namespace
}  // namespace temblor::test
