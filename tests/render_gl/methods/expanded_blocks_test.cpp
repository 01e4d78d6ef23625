// Surface blocks in 256 colors that the card expands (WorldMethod::kExpandedBlocks), next to the CPU's
// pictures in 256 colors.
#include <gtest/gtest.h>

#include <iostream>

#include "render_gl/methods/method_views.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/pictures/deferred_faces.h"
#include "support/pictures/frames.h"
#include "support/pictures/picture_file.h"

namespace temblor::render_gl {
namespace {

// The CPU's picture in 256 colors, as colors.
render::FrameBuffer draw_indexed(const test::DrawableLevel& drawable, const render::Scene& scene) {
  render::Renderer cpu(drawable.palette, drawable.colormap);
  render::FrameBuffer indexed(640, 480, render::PixelFormat::kIndexed),
      colors(640, 480, render::PixelFormat::kRgb);
  cpu.render(scene, {}, indexed);
  for (std::size_t i = 0; i < colors.pixel_count(); ++i)
    colors.rgb()[i] = render::to_rgb(drawable.palette[indexed.indexed()[i]]);
  return colors;
}

void check_expanded_blocks(const test::DrawableLevel& drawable, int views, const CacheOptions& cache,
                           int tolerance) {
  RENDERER_PAIR_OR_SKIP(pair, drawable, ClipControl::kIfSupported, cache);
  pair.gl().set_method(WorldMethod::kExpandedBlocks);
  double total = 0, worst = 1;
  for (int number = 0; number < views; ++number) {
    const NumberedView view(*drawable.level, number, {.with_marks = true, .with_turns = true});
    render::FrameBuffer frame(640, 480, render::PixelFormat::kRgb);
    const auto drawn = pair.gl().render(view.scene, {}, frame);
    ASSERT_TRUE(drawn.ok()) << drawn.error().what;
    const render::FrameBuffer wanted = draw_indexed(drawable, view.scene);
    const std::string name = drawable.name + "-expanded-" + std::to_string(number);
    test::show_picture(name + "-cpu", wanted, drawable.palette);
    test::show_picture(name + "-gl", frame, drawable.palette);
    const double share = test::equal_share(wanted.rgb(), frame.rgb(), tolerance);
    total += share / views;
    worst = std::min(worst, share);
  }
  std::cout << "[          ] " << drawable.name << ": equal " << total << ", worst view " << worst << ", "
            << pair.gl().cache_counts().portions << " portions\n";
  EXPECT_GE(total, 0.99);
  EXPECT_GE(worst, 0.97);
}

TEST(GlExpandedBlocks, ShowTheCpusPictureIn256Colors) {
  const test::DrawableLevel small = test::small_level();
  check_expanded_blocks(small, test::effort(10, 2), {}, 0);
  check_expanded_blocks(small, test::effort(10, 2), {.bytes = std::size_t{2} << 20}, 0);
  check_expanded_blocks(small, test::effort(10, 2), {.format = TexelFormat::k16Bit}, 5);
  check_expanded_blocks(test::small_level({.wide_faces = true}, "wide"), test::effort(10, 2), {}, 0);
}

TEST(GlExpandedBlocks, ShowFences) {
  const test::DrawableLevel fenced = test::with_fences(test::small_level());
  check_expanded_blocks(fenced, test::effort(10, 2), {}, 0);
  check_expanded_blocks(fenced, test::effort(10, 2), {.format = TexelFormat::k16Bit}, 5);
}

TEST(GlExpandedBlocks, ShowStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* name : {"start", "lq_e1m2"})
    check_expanded_blocks(test::stock_level(data, name), test::effort(20, 2), {}, 0);
}

// A quarter of the bytes of blocks in true color, and as often.
TEST(GlExpandedBlocks, UploadAByteForEachTexel) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  const NumberedView view(*drawable.level, 1, {});
  const auto draw = [&](WorldMethod method) {
    pair.gl().set_method(method);
    render::FrameBuffer frame(640, 480, render::PixelFormat::kRgb);
    EXPECT_TRUE(pair.gl().render(view.scene, {}, frame).ok());
    return pair.gl().cache_counts();
  };
  const CacheCounts expanded = draw(WorldMethod::kExpandedBlocks);
  EXPECT_EQ(draw(WorldMethod::kExpandedBlocks).bytes_uploaded, 0u);
  const CacheCounts blocks = draw(WorldMethod::kBlocks);
  EXPECT_GT(expanded.drawn, 10u);
  EXPECT_NEAR(static_cast<double>(expanded.bytes_uploaded) / static_cast<double>(blocks.bytes_uploaded), 0.25,
              0.05);
}

}  // namespace
}  // namespace temblor::render_gl
