// Joined faces against the definition, and pictures of the unsplit world against the engine's.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "lab/registry.h"
#include "lab/unsplit_world/joined_faces.h"
#include "render/renderer.h"
#include "support/allocation_counter.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/viewpoints.h"

namespace temblor::lab {
namespace {

bool can_be_one(const world::Level& level, const world::Face& a, const world::Face& b) {
  const world::TextureAxes &axes = level.texture_axes[a.axes], &other = level.texture_axes[b.axes];
  return a.plane == b.plane && a.back_side == b.back_side && a.texture == b.texture &&
         axes.s_axis == other.s_axis && axes.s_offset == other.s_offset && axes.t_axis == other.t_axis &&
         axes.t_offset == other.t_offset;
}

void expect_first_parts(const world::Level& level) {
  const std::vector<world::FaceIndex> first_parts = find_first_parts(level);
  ASSERT_EQ(first_parts.size(), level.faces.size());
  std::size_t joined = 0;
  for (std::uint32_t number = 0; number < first_parts.size(); ++number) {
    std::uint32_t wanted = 0;
    while (!can_be_one(level, level.faces[wanted], level.faces[number])) ++wanted;
    EXPECT_EQ(base::to_size(first_parts[number]), wanted);
    joined += wanted != number;
  }
  EXPECT_GT(joined, 0u);
}

TEST(UnsplitWorld, JoinsFacesInOnePlaneWithOneTexture) {
  expect_first_parts(*test::small_level().level);
}

TEST(UnsplitWorld, JoinsFacesOfAStockLevel) {
  DATA_FOLDER_OR_SKIP(data);
  expect_first_parts(*test::stock_level(data, "start").level);
}

std::vector<render::PixelFace> find_pixel_faces(render::Renderer& io_renderer, const render::Scene& scene,
                                                const render::Settings& settings) {
  render::FrameBuffer frame(320, 200, render::PixelFormat::kIndexed);
  io_renderer.render(scene, settings, frame);
  std::vector<render::PixelFace> faces(frame.pixel_count());
  std::vector<std::uint8_t> writes(frame.pixel_count());
  io_renderer.pixel_faces(faces, writes);
  EXPECT_TRUE(std::ranges::all_of(writes, [](int count) { return count == 1; }));
  return faces;
}

// Parts begin at the engine's pixels: a wrong cut would show another part of the same face.
void expect_engine_faces(const test::DrawableLevel& drawable, int views) {
  render::Renderer engine(drawable.palette, drawable.colormap), unsplit(drawable.palette, drawable.colormap);
  unsplit.replace_stages(parse_choice("unsplit-edges").value().make_stages());
  std::size_t different = 0, different_parts = 0, pixels = 0;
  const std::vector<world::FaceIndex> first_parts = find_first_parts(*drawable.level);
  for (int number = 0; number < views; ++number) {
    test::Random random(static_cast<std::uint64_t>(number));
    const test::Viewpoint viewpoint{.camera = test::random_camera(*drawable.level, random)};
    const render::Scene scene = viewpoint.scene(*drawable.level);
    const auto wanted = find_pixel_faces(engine, scene, {});
    const auto drawn = find_pixel_faces(
        unsplit, scene,
        {.threads = 2, .job_backend = base::JobBackend::kStdThread, .band_rows = 1 + 13 * (number % 5)});
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const std::uint32_t face = drawn[i].face, wanted_face = wanted[i].face;
      if (face == wanted_face) continue;
      ++different;
      if (face != render::PixelFace::kNothing && wanted_face != render::PixelFace::kNothing)
        different_parts += first_parts[face] == first_parts[wanted_face];
    }
    pixels += wanted.size();
  }
  EXPECT_EQ(different_parts, 0u) << drawable.name;
  EXPECT_LE(static_cast<double>(different), 0.001 * static_cast<double>(pixels)) << drawable.name;
}

TEST(UnsplitWorld, ShowsThePartsThatTheEngineShows) {
  for (const test::SmallLevelVariant& variant : test::small_level_variants())
    expect_engine_faces(test::small_level(variant.options, variant.name), test::effort(10, 2));
}

// "start" has faces in the same place, of which either may be shown.
TEST(UnsplitWorld, ShowsThePartsOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* const name : {"lq_e0m1", "lq_e1m2"})
    expect_engine_faces(test::stock_level(data, name), test::effort(20, 2));
}

TEST(UnsplitWorld, SortsFewerEdges) {
  const test::DrawableLevel drawable = test::small_level();
  test::Random random(2);
  const test::Viewpoint viewpoint{.camera = test::random_camera(*drawable.level, random)};
  const render::Scene scene = viewpoint.scene(*drawable.level);
  Counter counter;
  render::Renderer renderer(drawable.palette, drawable.colormap);
  renderer.replace_stages(parse_choice("unsplit-edges").value().make_stages(&counter));
  find_pixel_faces(renderer, scene, {});
  const Counts counts = counter.take();
  EXPECT_GT(counts.edges_saved, 0u);
  EXPECT_GT(counts.splits, 0u);
  renderer.replace_stages(parse_choice("abutting-edges").value().make_stages(&counter));
  find_pixel_faces(renderer, scene, {});
  EXPECT_LE(counts.comparisons, counter.take().comparisons);
}

TEST(UnsplitWorld, AllocatesNothingInAWarmFrame) {
  const test::DrawableLevel drawable = test::small_level();
  test::Random random(1);
  const test::Viewpoint viewpoint{.camera = test::random_camera(*drawable.level, random)};
  const render::Scene scene = viewpoint.scene(*drawable.level);
  render::FrameBuffer frame(320, 200, render::PixelFormat::kIndexed);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  renderer.replace_stages(parse_choice("unsplit-edges").value().make_stages());
  for (int i = 0; i < 3; ++i) renderer.render(scene, {}, frame);
  const std::size_t before = test::allocation_count();
  renderer.render(scene, {}, frame);
  EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace temblor::lab
