// Caustics: which faces they show on, the light they add by definition, and pictures with and without them.
#include "render/surfaces/light/caustics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "artgen/small_level.h"
#include "render/renderer.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

std::shared_ptr<const world::Level> make_flooded_level(world::Contents liquid) {
  static const formats::Bsp dry = artgen::make_small_level({});
  formats::Bsp bsp = dry;
  for (formats::BspLeaf& leaf : bsp.leaves)
    if (leaf.contents == static_cast<std::int32_t>(world::Contents::kEmpty))
      leaf.contents = static_cast<std::int32_t>(liquid);
  std::ranges::fill(bsp.lighting, std::uint8_t{100});
  return world::make_level(std::move(bsp), "flooded").value();
}

FrameCopy draw_flooded(const world::Level& level, std::uint64_t seed, double time_s,
                       const render::Settings& settings, PixelFormat format = PixelFormat::kRgb) {
  const DrawableLevel look = small_level();
  Random random(seed);
  Viewpoint viewpoint;
  viewpoint.camera = random_camera(level, random);
  viewpoint.time_s = time_s;
  render::Renderer renderer(look.palette, look.colormap);
  render::FrameBuffer frame(160, 120, format);
  renderer.render(viewpoint.scene(level), settings, frame);
  return copy_picture(frame);
}

constexpr std::uint64_t kCausticViews = 4;

TEST(Caustics, ShowUnderWaterOnly) {
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb})
    for (const world::Contents liquid : {world::Contents::kWater, world::Contents::kEmpty,
                                         world::Contents::kSlime, world::Contents::kLava}) {
      const std::shared_ptr<const world::Level> level = make_flooded_level(liquid);
      std::size_t different = 0;
      for (std::uint64_t seed = 0; seed < kCausticViews; ++seed)
        different += differing_pixels(draw_flooded(*level, seed, 5, {.caustics = true}, format),
                                      draw_flooded(*level, seed, 5, {}, format));
      EXPECT_EQ(different > 0, liquid == world::Contents::kWater) << static_cast<int>(liquid);
    }
}

TEST(Caustics, MoveAndDependOnNothingElse) {
  const std::shared_ptr<const world::Level> level = make_flooded_level(world::Contents::kWater);
  for (std::uint64_t seed = 0; seed < kCausticViews; ++seed) {
    const FrameCopy picture = draw_flooded(*level, seed, 5, {.caustics = true});
    EXPECT_GT(differing_pixels(picture, draw_flooded(*level, seed, 5.5, {.caustics = true})), 100u);
    EXPECT_EQ(picture, draw_flooded(*level, seed, 5, {.threads = 3, .caustics = true}));
    EXPECT_EQ(picture, draw_flooded(*level, seed, 5, {.surface_cache = false, .caustics = true}));
    EXPECT_EQ(picture, draw_flooded(*level, seed, 5, {.simd_kernels = false, .caustics = true}));
  }
}

// In front of the middle of each face that is wholly within a leaf.
TEST(Caustics, FacesUnderWaterAreThoseWithWaterInFrontOfThem) {
  DATA_FOLDER_OR_SKIP(base_folder);
  const DrawableLevel stock = stock_level(base_folder, "lq_e0m1");
  const world::Level& level = *stock.level;
  const render::WaterFaces under_water(level);
  std::size_t wet = 0, wrong = 0;
  const world::Model& world_model = level.models.front();
  for (std::uint32_t i = world_model.first_face; i < world_model.first_face + world_model.face_count; ++i) {
    const auto number = base::to_index<world::FaceIndex>(i);
    const world::Face& face = level.face(number);
    if (face.kind != world::FaceKind::kLit) continue;
    math::Vec3 middle(0);
    for (std::uint32_t corner = 0; corner < face.surfedge_count; ++corner)
      middle += level.vertices[level.surfedge_start(face.first_surfedge + corner)];
    middle /= static_cast<float>(face.surfedge_count);
    const math::Vec3 front = middle + level.planes[face.plane].normal * (face.back_side ? -1.0f : 1.0f);
    const bool in_water =
        level.leaves[base::to_size(world::find_leaf(level, front))].contents == world::Contents::kWater;
    wet += in_water;
    wrong += in_water != under_water.contains(number);
  }
  EXPECT_GT(wet, 20u);
  EXPECT_LT(wrong * 50, wet);
}

// One face of 512 x 256 texels in a plane through the origin.
world::Level make_plain_level(const math::Vec3& normal, const math::Vec3& s_axis, const math::Vec3& t_axis) {
  world::Level level;
  level.planes.push_back({normal, 0, 3});
  level.texture_axes.push_back({s_axis, 0, t_axis, 0});
  world::Face face{};
  face.kind = world::FaceKind::kLit;
  face.texture_extents = {512, 256};
  level.faces.push_back(face);
  return level;
}

struct LitTile {
  render::SampleGrid grid;
  render::LightSums light;
};

// A tile of the face with one light everywhere.
LitTile light_tile(const world::Level& level, int tile_s, std::uint32_t step, int mip, base::Arena& arena) {
  const world::Face& face = level.faces[0];
  const render::SampleGrid grid = render::sample_grid(face, tile_s, 0);
  const render::SampleGrid refined = render::refine_for_caustics(grid, mip);
  const std::span<const std::uint32_t> flat = arena.allocate_filled<std::uint32_t>(
      static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), 25600);
  return {refined, render::add_caustics(level, face, step, {flat, 1}, grid, refined, arena)};
}

TEST(Caustics, KeepTheMeanLightOfFloors) {
  const world::Level level = make_plain_level({0, 0, 1}, {1, 0, 0}, {0, -1, 0});
  base::Arena arena;
  for (std::uint32_t step = 1; step < 1000; step += 90) {
    const LitTile tile = light_tile(level, 0, step, 0, arena);
    const auto sum = std::accumulate(tile.light.values.begin(), tile.light.values.end(), std::uint64_t{0});
    const double mean = static_cast<double>(sum) / static_cast<double>(tile.light.values.size());
    EXPECT_NEAR(mean / 25600, 1, 0.15) << "step " << step;
    const auto [least, most] = std::ranges::minmax(tile.light.values);
    EXPECT_LT(least, 22000u);
    EXPECT_GT(most, 40000u);
  }
}

TEST(Caustics, ContinueOverTheBordersOfTiles) {
  const world::Level level = make_plain_level({0, 0, 1}, {0.7f, 0.2f, 0}, {0.1f, -1.3f, 0});
  base::Arena arena;
  for (std::uint32_t step = 1; step < 500; step += 70)
    for (const int mip : {0, 1, 2, 3}) {
      const LitTile left = light_tile(level, 0, step, mip, arena),
                    right = light_tile(level, 1, step, mip, arena);
      for (std::int32_t row = 0; row < left.grid.rows; ++row) {
        const auto end = static_cast<std::size_t>((row + 1) * left.grid.columns - 1);
        const auto start = static_cast<std::size_t>(row * right.grid.columns);
        EXPECT_NEAR(left.light.values[end], right.light.values[start], 400);
      }
    }
}

TEST(Caustics, LeaveCeilingsAndFacesWithoutTextureAxesAlone) {
  base::Arena arena;
  for (const world::Level& level : {make_plain_level({0, 0, -1}, {1, 0, 0}, {0, 1, 0}),
                                    make_plain_level({0, 0, 1}, {1, 0, 0}, {2, 0, 0})}) {
    const LitTile tile = light_tile(level, 0, 7, 0, arena);
    EXPECT_TRUE(std::ranges::all_of(tile.light.values, [](std::uint32_t sum) { return sum == 25600; }));
  }
}

// On a ceiling, where no net hides it.
TEST(Caustics, InterpolateTheLightBetweenSamples) {
  const world::Level level = make_plain_level({0, 0, -1}, {1, 0, 0}, {0, 1, 0});
  const render::SampleGrid grid = render::sample_grid(level.faces[0], 0, 0);
  const render::SampleGrid refined = render::refine_for_caustics(grid, 0);
  base::Arena arena;
  Random random(3);
  std::vector<std::uint32_t> light(static_cast<std::size_t>(grid.columns * grid.rows) * 3);
  for (std::uint32_t& sum : light) sum = static_cast<std::uint32_t>(random.uniform(0, 1 << 28));
  const render::LightSums sums =
      render::add_caustics(level, level.faces[0], 1, {light, 3}, grid, refined, arena);
  const std::int32_t factor = grid.texels / refined.texels;
  const auto at = [&](std::int32_t column, std::int32_t row, std::size_t channel) {
    return static_cast<double>(light[static_cast<std::size_t>(row * grid.columns + column) * 3 + channel]);
  };
  for (std::int32_t row = 0; row < refined.rows; ++row)
    for (std::int32_t column = 0; column < refined.columns; ++column)
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const std::int32_t x = column / factor, y = row / factor;
        const std::int32_t right = std::min(x + 1, grid.columns - 1), below = std::min(y + 1, grid.rows - 1);
        const double across = static_cast<double>(column % factor) / factor;
        const double expected = std::lerp(std::lerp(at(x, y, channel), at(right, y, channel), across),
                                          std::lerp(at(x, below, channel), at(right, below, channel), across),
                                          static_cast<double>(row % factor) / factor);
        EXPECT_NEAR(sums.values[static_cast<std::size_t>(row * refined.columns + column) * 3 + channel],
                    expected, 1);
      }
}

TEST(Caustics, FacesTakeTheirStepsAtDifferentTimes) {
  std::vector<int> steps_in_frame(240);
  for (std::uint32_t face = 0; face < 200; ++face)
    for (std::size_t frame = 1; frame < steps_in_frame.size(); ++frame) {
      const auto number = base::to_index<world::FaceIndex>(face);
      const std::uint32_t before = render::find_caustic_step(number, static_cast<double>(frame - 1) / 240);
      const std::uint32_t now = render::find_caustic_step(number, static_cast<double>(frame) / 240);
      EXPECT_GE(now, before);
      steps_in_frame[frame] += static_cast<int>(now - before);
    }
  EXPECT_EQ(std::accumulate(steps_in_frame.begin(), steps_in_frame.end(), 0) / 200, 14);
  EXPECT_LT(*std::ranges::max_element(steps_in_frame), 40);
}

}  // namespace
}  // namespace temblor::test
