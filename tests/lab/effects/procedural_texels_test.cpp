// Procedural texels and marks in surfaces: the kernels against their definition, patterns across tiles and
// mip levels, and pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/lit_pictures.h"
#include "lab/world_light/effects/change_block.h"
#include "render/simd_targets.h"
#include "render/view/model_view.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

constexpr std::size_t kMaxRow = 256;

// A random row of a block, with room for all that the kernels may read.
struct RowCase {
  std::array<std::vector<std::int32_t>, lab::kPatternOctaves> nodes;
  std::vector<std::uint32_t> inks, colors;
  std::vector<std::uint8_t> table, indices;
  lab::PatternRow row{};

  explicit RowCase(Random& random) {
    row.count = static_cast<std::int32_t>(1 + random.below(kMaxRow));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      lab::OctaveRow& octave = row.octaves[i];
      octave.shift = static_cast<std::int32_t>(random.below(10));
      octave.first = static_cast<std::int32_t>(random.below(std::size_t{1} << octave.shift));
      const std::size_t count =
          (static_cast<std::size_t>(octave.first + row.count - 1) >> octave.shift) + 1 + lab::kNodePadding;
      for (std::size_t node = 0; node < count; ++node)
        nodes[i].push_back(static_cast<std::int32_t>(random.below(32768 / lab::kPatternOctaves)));
      octave.nodes = nodes[i].data();
    }
    if (random.chance(0.5)) {
      row.bias_first = static_cast<std::int32_t>(random.uniform(-1000, 1000) * 4096);
      row.bias_step = static_cast<std::int32_t>(random.uniform(-4, 4) * 4096);
    }
    for (int i = 0; i < 256; ++i) inks.push_back(static_cast<std::uint32_t>(random.bits()));
    for (int i = 0; i < lab::kIndexedPatterns * 256 + 3; ++i)
      table.push_back(static_cast<std::uint8_t>(random.bits()));
    for (std::int32_t i = 0; i < row.count; ++i) {
      colors.push_back(static_cast<std::uint32_t>(random.bits()));
      if (random.chance(0.2)) colors.back() &= 0xffffffu;
      indices.push_back(static_cast<std::uint8_t>(random.chance(0.2) ? 255 : random.bits()));
    }
    row.inks = inks.data();
    row.indices = table.data();
    row.clear = random.chance(0.5) ? 255 : 256;
  }

  // The pattern by the definition in pattern_kernels.h, with real numbers where it rounds down.
  double pattern(std::int32_t x) const {
    double sum = 0;
    for (const lab::OctaveRow& octave : row.octaves) {
      const double at = std::ldexp(octave.first + x, -octave.shift), node = std::floor(at);
      const auto i = static_cast<std::size_t>(node);
      sum += std::lerp(octave.nodes[i], octave.nodes[i + 1], at - node);
    }
    return std::clamp(sum / 128 + (row.bias_first + static_cast<double>(x) * row.bias_step) / 4096, 0.0,
                      255.0);
  }
};

TEST(PatternKernels, AreTheSameOnEveryInstructionSet) {
  for (int seed = 0; seed < effort(3000, 100); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const RowCase rows(random);
    std::vector<std::uint32_t> colors = rows.colors;
    std::vector<std::uint8_t> indices = rows.indices;
    lab::change_row_u32_scalar(rows.row, colors.data());
    lab::change_row_u8_scalar(rows.row, indices.data());
    for_each_simd_target([&] {
      std::vector<std::uint32_t> simd_colors = rows.colors;
      std::vector<std::uint8_t> simd_indices = rows.indices;
      lab::change_row_u32_simd(rows.row, simd_colors.data());
      lab::change_row_u8_simd(rows.row, simd_indices.data());
      ASSERT_EQ(simd_colors, colors) << seed;
      ASSERT_EQ(simd_indices, indices) << seed;
    });
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(PatternKernels, FollowTheirDefinition) {
  for (int seed = 0; seed < effort(300, 50); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    RowCase rows(random);
    // The ink of a pattern is its number, and black shows it.
    for (std::uint32_t i = 0; i < 256; ++i) rows.inks[i] = 0xff000000u | i;
    std::ranges::fill(rows.colors, 0xff000000u);
    lab::change_row_u32_scalar(rows.row, rows.colors.data());
    for (std::int32_t x = 0; x < rows.row.count; ++x)
      EXPECT_NEAR(rows.colors[static_cast<std::size_t>(x)] & 255, rows.pattern(x), 2.1) << seed << ", " << x;
  }
}

// Gray blocks of a face, changed by a pattern.
class PatternBlocks {
 public:
  explicit PatternBlocks(const DrawableLevel& drawable, lab::PatternKind kind = lab::PatternKind::kNoise,
                         double time_s = 0)
      : tables_(render::make_color_tables(drawable.palette, drawable.colormap)),
        colors_(lab::make_pattern_colors(kind, tables_)),
        style_(lab::find_style(kind)),
        time_s_(time_s),
        level_(*drawable.level) {
    scene_.level = &level_;
  }

  // Brightness by texel. The shape may reach beyond the tile.
  std::vector<int> draw(world::FaceIndex face, int tile_s, int mip, render::SurfaceShape shape) {
    std::vector<std::uint32_t> texels(shape.texels(), 0xff808080u);
    render::BlockRequest request{};
    request.face = face;
    request.tile_s = static_cast<std::uint16_t>(tile_s);
    request.mip = mip;
    request.contents.texture = level_.face(face).texture;
    request.block = {reinterpret_cast<std::byte*>(texels.data()), shape};
    lab::change_block({scene_, settings_, PixelFormat::kRgb, tables_, jobs_, arenas_},
                      {style_, colors_, time_s_}, request, scratch_);
    std::vector<int> grays;
    for (const std::uint32_t texel : texels) grays.push_back(static_cast<int>(texel & 255));
    return grays;
  }

 private:
  render::ColorTables tables_;
  lab::PatternColors colors_;
  const lab::PatternStyle& style_;
  const double time_s_;
  const world::Level& level_;
  render::Scene scene_;
  render::Settings settings_;
  base::Jobs jobs_{1};
  render::FrameArenas arenas_;
  base::Arena scratch_;
};

constexpr world::FaceIndex kFace{0};

TEST(ProceduralTexels, ContinueAcrossTiles) {
  const DrawableLevel drawable = small_level();
  PatternBlocks blocks(drawable);
  for (const int mip : {-1, 0, 1, 2, 3}) {
    const int tile = render::at_mip(256, mip), width = tile + 8;
    const std::vector<int> first = blocks.draw(kFace, 0, mip, {width, 4}),
                           second = blocks.draw(kFace, 1, mip, {8, 4});
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 8; ++x)
        EXPECT_EQ(first[static_cast<std::size_t>(y * width + tile + x)],
                  second[static_cast<std::size_t>(y * 8 + x)])
            << mip;
  }
}

TEST(ProceduralTexels, LookAlikeOnMipLevels) {
  const DrawableLevel drawable = small_level();
  PatternBlocks blocks(drawable);
  const std::vector<int> fine = blocks.draw(kFace, 0, 0, {256, 256}),
                         coarse = blocks.draw(kFace, 0, 2, {64, 64});
  const auto [least, most] = std::ranges::minmax(fine);
  EXPECT_GT(most - least, 30);
  double difference = 0, range = 0;
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t x = 0; x < 64; ++x) {
      double mean = 0;
      for (std::size_t i = 0; i < 16; ++i) mean += fine[(y * 4 + i / 4) * 256 + x * 4 + i % 4] / 16.0;
      difference += std::abs(mean - coarse[y * 64 + x]) / 4096;
      range += std::abs(mean - 128) / 4096;
    }
  EXPECT_LT(difference, range * 0.6);
}

// The sanitizers would notice a conversion out of range.
TEST(ProceduralTexels, BearAnyTimeAndAnyTextureAxes) {
  const DrawableLevel drawable = small_level();
  for (const double time_s :
       {-1e300, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    for (const float stretch : {1.0f, 1e-6f, 1e-30f, 1e30f}) {
      auto level = std::make_shared<world::Level>(*drawable.level);
      for (world::TextureAxes& axes : level->texture_axes) axes.s_axis *= stretch;
      DrawableLevel stretched = drawable;
      stretched.level = level;
      PatternBlocks blocks(stretched, lab::PatternKind::kFire, time_s);
      for (std::uint32_t face = 0; face < level->faces.size(); face += 7)
        EXPECT_EQ(blocks.draw(world::FaceIndex{face}, 0, -3, {2048, 2}).size(), 4096u);
    }
}

// A view of the small level, drawn by the engine and by a technique.
class EffectPictures : public testing::TestWithParam<PixelFormat> {
 protected:
  static constexpr int kWidth = 333, kHeight = 203;
  struct Drawn {
    FrameCopy picture;
    std::uint64_t texels_built = 0, texels_read = 0;
    std::vector<render::PixelFace> faces;
  };
  // A technique draws all of its frames with one renderer.
  class Painter {
   public:
    Painter(const DrawableLevel& drawable, const char* technique)
        : renderer_(drawable.palette, drawable.colormap), frame_(kWidth, kHeight, GetParam()) {
      if (technique != nullptr) renderer_.replace_stages(lab::parse_choice(technique).value().make_stages());
    }
    Drawn draw(const render::Scene& scene, const render::Settings& settings = {}) {
      const render::FrameStats stats = renderer_.render(scene, settings, frame_);
      Drawn drawn{copy_picture(frame_), stats.texels_built, stats.texels_read, {}};
      drawn.faces.resize(frame_.pixel_count());
      std::vector<std::uint8_t> writes(frame_.pixel_count());
      renderer_.pixel_faces(drawn.faces, writes);
      return drawn;
    }

   private:
    render::Renderer renderer_;
    render::FrameBuffer frame_;
  };

  EffectPictures() : random_(11), view_(make_lit_view(*drawable_.level, GetParam(), random_)) {}

  render::Scene scene(double time_s = 1) const {
    render::Scene scene = view_.scene(*drawable_.level);
    scene.time_s = time_s;
    return scene;
  }
  bool is_wall(const render::PixelFace& pixel) const {
    const world::Face& face = drawable_.level->faces[pixel.face];
    return std::abs(render::place_plane(*drawable_.level, face, {}).normal.z) < 0.7;
  }
  static bool differ(const FrameCopy& a, const FrameCopy& b, std::size_t pixel) {
    return GetParam() == PixelFormat::kRgb ? a.rgb[pixel] != b.rgb[pixel]
                                           : a.indexed[pixel] != b.indexed[pixel];
  }

  const DrawableLevel drawable_ = small_level();
  Random random_;
  const Viewpoint view_;
};

TEST_P(EffectPictures, NoiseIsBuiltOnce) {
  Painter engine(drawable_, nullptr), noise(drawable_, "procedural-texels");
  const Drawn right = engine.draw(scene()), first = noise.draw(scene()), second = noise.draw(scene());
  EXPECT_EQ(first.texels_built, first.texels_read);
  EXPECT_EQ(second.texels_built, 0u);
  EXPECT_EQ(first.picture, second.picture);
  EXPECT_GT(differing_pixels(right.picture, first.picture), right.faces.size() / 4);
}

TEST_P(EffectPictures, WaterAndFireMoveOnWallsOnly) {
  Painter engine(drawable_, nullptr);
  const Drawn right = engine.draw(scene());
  for (const char* const technique : {"procedural-texels:pattern=1", "procedural-texels:pattern=2"}) {
    Painter moving(drawable_, technique);
    const Drawn first = moving.draw(scene()), same = moving.draw(scene()), later = moving.draw(scene(1.1));
    EXPECT_EQ(later.texels_built, later.texels_read) << technique;
    EXPECT_EQ(first.picture, same.picture) << technique;
    EXPECT_GT(differing_pixels(first.picture, later.picture), 100u) << technique;
    std::size_t changed = 0, on_floors = 0;
    for (std::size_t i = 0; i < right.faces.size(); ++i) {
      if (right.faces[i].instance != 0 || !differ(right.picture, first.picture, i)) continue;
      (is_wall(right.faces[i]) ? changed : on_floors)++;
    }
    EXPECT_GT(changed, 100u) << technique;
    EXPECT_EQ(on_floors, 0u) << technique;
  }
}

TEST_P(EffectPictures, MarksAreBuiltOnce) {
  Painter engine(drawable_, nullptr), none(drawable_, "marked-surfaces:marks=0"),
      four(drawable_, "marked-surfaces");
  const Drawn right = engine.draw(scene()), first = four.draw(scene()), second = four.draw(scene());
  EXPECT_EQ(none.draw(scene()).picture, right.picture);
  EXPECT_EQ(second.texels_built, 0u);
  EXPECT_GT(differing_pixels(right.picture, first.picture), 100u);
}

TEST_P(EffectPictures, ScalarKernelsDrawTheSame) {
  for (const char* const technique :
       {"procedural-texels", "procedural-texels:pattern=1", "procedural-texels:pattern=2"}) {
    Painter simd(drawable_, technique), scalar(drawable_, technique);
    EXPECT_EQ(simd.draw(scene()).picture, scalar.draw(scene(), {.simd_kernels = false}).picture) << technique;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, EffectPictures, testing::Values(PixelFormat::kIndexed, PixelFormat::kRgb),
                         [](const auto& format) {
                           return format.param == PixelFormat::kRgb ? "rgb" : "indexed";
                         });

TEST(SurfaceEffects, AreTheSameForAnyThreadsAndBands) {
  expect_same_for_any_threads("procedural-texels:pattern=2");
  expect_same_for_any_threads("marked-surfaces");
}

TEST(SurfaceEffects, AllocateNothingInAWarmFrame) {
  expect_no_allocations_in_a_warm_frame("procedural-texels");
  expect_no_allocations_in_a_warm_frame("procedural-texels:pattern=1");
  expect_no_allocations_in_a_warm_frame("marked-surfaces");
}

TEST(SurfaceEffects, EndWithTheTechnique) {
  const DrawableLevel drawable = small_level();
  Random random(7);
  const Viewpoint view = make_lit_view(*drawable.level, PixelFormat::kRgb, random);
  const render::Scene scene = view.scene(*drawable.level);
  render::Renderer renderer(drawable.palette, drawable.colormap);
  render::FrameBuffer frame(200, 120, PixelFormat::kRgb);
  renderer.render(scene, {}, frame);
  const FrameCopy before = copy_picture(frame);
  renderer.replace_stages(lab::parse_choice("procedural-texels").value().make_stages());
  renderer.render(scene, {}, frame);
  EXPECT_GT(differing_pixels(before, copy_picture(frame)), 1000u);
  renderer.replace_stages({});
  renderer.render(scene, {}, frame);
  EXPECT_EQ(before, copy_picture(frame));
}

}  // namespace
}  // namespace temblor::test
