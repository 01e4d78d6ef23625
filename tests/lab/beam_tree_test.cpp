// The beam tree against the engine: the world's faces are at the same pixels, for any trees, threads, and
// bands.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "lab/registry.h"
#include "render/renderer.h"
#include "support/allocation_counter.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"

namespace temblor::lab {
namespace {

// Also a tree that is too large at once, and trees that get too large in the middle of a picture.
constexpr auto kTrees = {"beam-tree", "beam-tree:bands=0", "beam-tree:nodes=0", "beam-tree:bands=0,nodes=40",
                         "beam-tree:nodes=200"};

// The height leaves a band with fewer rows than the others.
constexpr int kWidth = 333, kHeight = 203;

// A picture, its depth, and the faces at its pixels.
struct DrawnView {
  std::vector<std::uint8_t> pixels;
  std::vector<float> depth;
  std::vector<render::PixelFace> faces;
  std::vector<std::uint8_t> writes;
};

// Draws one view of the world. The engine compares fragments of brush models where an edge begins, so it need
// not find the same order as the laboratory.
DrawnView draw_view(render::Renderer& renderer, const world::Level& level, int number,
                    const render::Settings& settings) {
  test::Random random(static_cast<std::uint64_t>(number));
  const test::Viewpoint viewpoint{.camera = test::random_camera(level, random)};
  render::FrameBuffer frame(kWidth, kHeight, render::PixelFormat::kIndexed);
  DrawnView view;
  view.faces.resize(frame.pixel_count());
  view.writes.resize(frame.pixel_count());
  renderer.render(viewpoint.scene(level), settings, frame);
  renderer.pixel_faces(view.faces, view.writes);
  view.pixels.assign(frame.indexed().begin(), frame.indexed().end());
  view.depth.assign(frame.depth().begin(), frame.depth().end());
  return view;
}

bool shows_same(const render::PixelFace& a, const render::PixelFace& b) {
  return a.instance == b.instance && a.face == b.face;
}

// Draws one view of each tree, on one and two threads and with bands of several heights. The faces must be
// the engine's. Pixels and depths must be the first tree's: the engine has two spans where an edge that
// covers no pixel splits one, and a span's last bits depend on its first pixel.
void expect_equal_views(const test::DrawableLevel& drawable, int number) {
  const world::Level& level = *drawable.level;
  const bool use_pvs = number % 2 == 0;
  render::Renderer engine(drawable.palette, drawable.colormap);
  const DrawnView right = draw_view(engine, level, number, {.use_pvs = use_pvs});
  DrawnView first;
  for (const char* const tree : kTrees) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    renderer.replace_stages(parse_choice(tree).value().make_stages());
    for (const int threads : {1, 2}) {
      for (const int band_rows : {1, 7, 64}) {
        SCOPED_TRACE(testing::Message() << tree << ", " << threads << " threads, bands of " << band_rows
                                        << " rows, view " << number << " of " << drawable.name);
        const DrawnView view = draw_view(renderer, level, number,
                                         {.threads = threads,
                                          .job_backend = base::JobBackend::kStdThread,
                                          .use_pvs = use_pvs,
                                          .band_rows = band_rows});
        if (first.pixels.empty()) first = view;
        EXPECT_TRUE(std::ranges::equal(view.faces, right.faces, shows_same));
        EXPECT_TRUE(std::ranges::all_of(view.writes, [](int writes) { return writes == 1; }));
        EXPECT_TRUE(view.pixels == first.pixels);
        EXPECT_TRUE(view.depth == first.depth);
      }
    }
  }
}

TEST(BeamTree, ShowsTheSmallLevelLikeTheEngine) {
  for (int number = 0; number < test::effort(10, 2); ++number)
    expect_equal_views(test::small_level(), number);
}

TEST(BeamTree, ShowsStockLevelsLikeTheEngine) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* const name : {"start", "lq_e0m1", "lq_e1m2"}) {
    const test::DrawableLevel level = test::stock_level(data, name);
    for (int number = 0; number < test::effort(10, 2); ++number) expect_equal_views(level, number);
  }
}

TEST(BeamTree, CountsSpansOnlyIfATreeIsTooLarge) {
  const test::DrawableLevel drawable = test::small_level();
  const auto count = [&](const char* tree) {
    Counter counter;
    render::Renderer renderer(drawable.palette, drawable.colormap);
    renderer.replace_stages(parse_choice(tree).value().make_stages(&counter));
    draw_view(renderer, *drawable.level, 1, {});
    return counter.take();
  };
  const Counts whole = count("beam-tree"), cut_short = count("beam-tree:nodes=20"),
               none = count("beam-tree:nodes=0");
  EXPECT_EQ(whole.spans_sorted, 0u);
  EXPECT_GT(whole.comparisons, cut_short.comparisons);
  EXPECT_GT(cut_short.spans_sorted, 0u);
  EXPECT_GT(none.spans_sorted, cut_short.spans_sorted);
}

TEST(BeamTree, AllocatesNothingInAWarmFrame) {
  const test::DrawableLevel drawable = test::small_level();
  test::Random random(1);
  const test::Viewpoint viewpoint{.camera = test::random_camera(*drawable.level, random)};
  const render::Scene scene = viewpoint.scene(*drawable.level);
  render::FrameBuffer frame(kWidth, kHeight, render::PixelFormat::kIndexed);
  for (const char* const tree : kTrees) {
    render::Renderer renderer(drawable.palette, drawable.colormap);
    renderer.replace_stages(parse_choice(tree).value().make_stages());
    for (int i = 0; i < 3; ++i) renderer.render(scene, {}, frame);
    const std::size_t before = test::allocation_count();
    renderer.render(scene, {}, frame);
    EXPECT_EQ(test::allocation_count(), before) << tree;
  }
}

}  // namespace
}  // namespace temblor::lab
