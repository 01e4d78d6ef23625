// Surface blocks against their definition, texel by texel: the texel of the texture, lit from the four
// samples around it by the formulas in render/surfaces/build_surface.h, implemented a second time.
#include "render/surfaces/build_surface.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "render/edges/edge_table.h"
#include "support/effort.h"
#include "support/levels/drawable_level.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::BlockRequest;
using render::PixelFormat;
using render::SurfaceShape;

constexpr int kTexelsASample = 16;

std::int64_t wrapped(std::int64_t value, std::int64_t size) {
  return (value % size + size) % size;
}
// Rounds down, whatever the sign. Negative `bits` multiply.
std::int64_t floor_shifted(std::int64_t value, int bits) {
  if (bits < 0) return value * (std::int64_t{1} << -bits);
  const std::int64_t unit = std::int64_t{1} << bits;
  return (value - wrapped(value, unit)) / unit;
}
std::int64_t surface_between(std::int64_t a, std::int64_t b, int i, int n) {
  return a + floor_shifted((b - a) * i * (2048 * 16 / n) + 16384, 15);
}

// One texel of a face's block, computed from the level's data.
class SurfaceDefinition {
 public:
  SurfaceDefinition(const DrawableLevel& drawable, const BlockRequest& request, const SurfaceShape& shape)
      : drawable_(drawable),
        level_(*drawable.level),
        request_(request),
        face_(level_.face(request.face)),
        own_grid_(face_.light_map_grid != world::kStockGrid ? &level_.light_map_grids[face_.light_map_grid]
                                                            : nullptr),
        texels_apart_(own_grid_ != nullptr ? std::max(own_grid_->texels, 1 << std::max(request.mip, 0))
                                           : kTexelsASample),
        texels_per_sample_(static_cast<int>(floor_shifted(texels_apart_, request.mip))),
        columns_(shape.width / texels_per_sample_ + 2),
        rows_(shape.height / texels_per_sample_ + 2) {
    for (int channel = 0; channel < (request.contents.colored ? 3 : 1); ++channel)
      for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column)
          light_sums_[static_cast<std::size_t>(channel)].push_back(compute_light_sum(column, row, channel));
  }

  std::uint8_t indexed(int x, int y) const {
    const std::int64_t t = lit(x, y, [&](std::int64_t column, std::int64_t row) {
      return std::max<std::int64_t>(floor_shifted(65280 - brightest_sum(column, row), 2), 64);
    });
    return drawable_.colormap.rows[static_cast<std::size_t>(floor_shifted(t, 8) * 256 + index(x, y))];
  }
  std::uint32_t rgb(int x, int y) const {
    const world::Texture& texture = level_.texture(request_.contents.texture);
    const formats::Rgb entry = drawable_.palette[index(x, y)];
    std::array<std::uint8_t, 3> color = {entry.r, entry.g, entry.b}, glow{};
    bool full_bright = index(x, y) >= 256 - drawable_.colormap.fullbrights;
    if (texture.colors) {
      const auto level = static_cast<std::size_t>(request_.mip + texture.colors->detail);
      color = channels(texture.colors->colors[level][texel(x, y)]);
      if (!texture.colors->glow.empty()) glow = channels(texture.colors->glow[level][texel(x, y)]);
      full_bright = false;
    }
    std::uint32_t shown = 0xff;
    for (int channel = 0; channel < 3; ++channel) {
      const std::uint8_t value = color[static_cast<std::size_t>(channel)];
      const std::int64_t h = lit(x, y, [&](std::int64_t column, std::int64_t row) {
        // Full light or less in the brightest channel.
        const std::int64_t sum = light_sum(column, row, channel), brightest = brightest_sum(column, row);
        return (brightest > 65280 ? sum * 65280 / brightest : sum) / 2;
      });
      const std::int64_t lit_value = std::min<std::int64_t>(255, floor_shifted(2 * value * h + 16384, 15));
      const std::int64_t unlit = glow[static_cast<std::size_t>(channel)];
      shown = shown << 8 | static_cast<std::uint32_t>(
                               std::min<std::int64_t>(255, unlit + (full_bright ? value : lit_value)));
    }
    return shown;
  }

 private:
  static std::array<std::uint8_t, 3> channels(std::uint32_t color) {
    return {static_cast<std::uint8_t>(color >> 16), static_cast<std::uint8_t>(color >> 8),
            static_cast<std::uint8_t>(color)};
  }

  std::uint8_t index(int x, int y) const {
    return level_.texture(request_.contents.texture).indices(request_.mip)[texel(x, y)];
  }

  // At mip level k, texel (s, t) of the face is texel (s >> k, t >> k) of that level, repeated.
  std::size_t texel(int x, int y) const {
    const world::Texture& texture = level_.texture(request_.contents.texture);
    const std::int64_t width = std::max<std::int64_t>(1, floor_shifted(texture.width, request_.mip));
    const std::int64_t height = std::max<std::int64_t>(1, floor_shifted(texture.height, request_.mip));
    const std::int64_t left = face_.texture_mins[0] + request_.tile_s * 256;
    const std::int64_t top = face_.texture_mins[1] + request_.tile_t * 256;
    const std::int64_t s = wrapped(floor_shifted(left, request_.mip) + x, width);
    const std::int64_t t = wrapped(floor_shifted(top, request_.mip) + y, height);
    return static_cast<std::size_t>(t * width + s);
  }

  std::int64_t brightest_sum(std::int64_t column, std::int64_t row) const {
    std::int64_t brightest = light_sum(column, row, 0);
    if (request_.contents.colored)
      for (const int channel : {1, 2}) brightest = std::max(brightest, light_sum(column, row, channel));
    return brightest;
  }

  // Without colored light, all channels have the same.
  std::int64_t light_sum(std::int64_t column, std::int64_t row, int channel) const {
    const std::vector<std::int64_t>& sums =
        light_sums_[static_cast<std::size_t>(request_.contents.colored ? channel : 0)];
    return sums[static_cast<std::size_t>(row * columns_ + column)];
  }

  // The face's samples, for all of its styles. Past the last sample, the value does not matter.
  std::int64_t compute_light_sum(std::int64_t column, std::int64_t row, int channel) const {
    if (own_grid_ != nullptr) return own_light_sum(column, row, channel);
    const std::int64_t width = face_.texture_extents[0] / 16 + 1, height = face_.texture_extents[1] / 16 + 1;
    column += request_.tile_s * 16;
    row += request_.tile_t * 16;
    if (column >= width || row >= height) return 0;
    std::int64_t sum = 0;
    for (std::int64_t style = 0; style < face_.style_count; ++style) {
      const std::int64_t sample = face_.light + style * width * height + row * width + column;
      const std::uint8_t value = request_.contents.colored
                                     ? level_.light_rgb[static_cast<std::size_t>(sample * 3 + channel)]
                                     : level_.light[static_cast<std::size_t>(sample)];
      sum += value * request_.contents.style_values[static_cast<std::size_t>(style)];
    }
    return sum;
  }

  // The light map's samples around a point that is column, row times texels_apart_ from the tile's first
  // texel.
  std::int64_t own_light_sum(std::int64_t column, std::int64_t row, int channel) const {
    const double s = static_cast<double>(request_.tile_s * 256 + column * texels_apart_);
    const double t = static_cast<double>(request_.tile_t * 256 + row * texels_apart_);
    const auto in_256ths = [](double position, std::int32_t count) {
      return static_cast<std::int64_t>(
          std::floor(std::min(std::max(position, 0.0), count - 1.0) * 256 + 0.5));
    };
    const std::int64_t x =
        in_256ths(own_grid_->first.x + s * own_grid_->per_s.x + t * own_grid_->per_t.x, own_grid_->width);
    const std::int64_t y =
        in_256ths(own_grid_->first.y + s * own_grid_->per_s.y + t * own_grid_->per_t.y, own_grid_->height);
    std::int64_t sum = 0;
    for (std::int64_t style = 0; style < face_.style_count; ++style) {
      std::int64_t weighted = 0;
      for (const int right : {0, 1})
        for (const int down : {0, 1}) {
          const std::int64_t share =
              (right == 1 ? x % 256 : 256 - x % 256) * (down == 1 ? y % 256 : 256 - y % 256);
          if (share == 0) continue;
          const std::int64_t sample =
              face_.light + (style * own_grid_->height + y / 256 + down) * own_grid_->width + x / 256 + right;
          weighted += share * (request_.contents.colored
                                   ? level_.light_rgb[static_cast<std::size_t>(sample * 3 + channel)]
                                   : level_.light[static_cast<std::size_t>(sample)]);
        }
      sum += weighted * request_.contents.style_values[static_cast<std::size_t>(style)] / 65536;
    }
    return sum;
  }

  // `of_sample` of the four samples around a texel, interpolated down the columns first and then along the
  // row.
  template <typename OfSample>
  std::int64_t lit(int x, int y, OfSample of_sample) const {
    const int n = texels_per_sample_;
    const auto down = [&](std::int64_t column) {
      return surface_between(of_sample(column, y / n), of_sample(column, y / n + 1), y % n, n);
    };
    return surface_between(down(x / n), down(x / n + 1), x % n, n);
  }

  const DrawableLevel& drawable_;
  const world::Level& level_;
  const BlockRequest& request_;
  const world::Face& face_;
  const world::LightMapGrid* own_grid_;  // null: a stock light map
  const int texels_apart_, texels_per_sample_;
  const int columns_, rows_;                             // of light_sums_
  std::array<std::vector<std::int64_t>, 3> light_sums_;  // each is used for many texels
};

// A block in memory of exactly its size and padding.
struct BuiltBlock {
  std::vector<std::byte> bytes;
  SurfaceShape shape;

  BuiltBlock(SurfaceShape of_shape, std::size_t bytes_per_texel)
      : bytes(of_shape.texels() * bytes_per_texel + render::kBlockPadding), shape(of_shape) {}
  render::SurfaceBlock view() { return {bytes.data(), shape}; }
  template <typename Texel>
  Texel texel(int x, int y) const {
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(shape.width);
    Texel value;
    std::memcpy(&value, bytes.data() + (at + static_cast<std::size_t>(x)) * sizeof(Texel), sizeof(Texel));
    return value;
  }
};

// With sanitizers, whole blocks are built, but only a slanted sample of texels is compared with the slow
// definition.
constexpr int kTexelStep = effort(1, 7);
// They also build only every third face of a level.
constexpr std::size_t kFaceStep = effort(1, 3);

void expect_as_defined(const DrawableLevel& drawable, BlockRequest request, PixelFormat format,
                       bool simd_kernels, base::Arena& scratch) {
  const bool indexed = format == PixelFormat::kIndexed;
  const render::ColorTables tables = render::make_color_tables(drawable.palette, drawable.colormap);
  BuiltBlock block(
      render::surface_shape(drawable.level->face(request.face), request.tile_s, request.tile_t, request.mip),
      indexed ? 1 : 4);
  request.block = block.view();
  render::build_surface(*drawable.level, tables, nullptr, request, format, simd_kernels, scratch);
  const SurfaceDefinition definition(drawable, request, block.shape);
  for (int y = 0; y < block.shape.height; ++y)
    for (int x = y % kTexelStep; x < block.shape.width; x += kTexelStep) {
      if (indexed) {
        ASSERT_EQ(int{block.texel<std::uint8_t>(x, y)}, int{definition.indexed(x, y)}) << x << ", " << y;
      } else {
        ASSERT_EQ(block.texel<std::uint32_t>(x, y), definition.rgb(x, y)) << x << ", " << y;
      }
    }
}

bool has_surface(const world::Face& face) {
  return face.kind == world::FaceKind::kLit && face.light != world::kNoLight;
}

// Any tile of a face at any mip level, under any light: dark, as stored, and far brighter than the brightest.
BlockRequest any_request(const world::Level& level, world::FaceIndex index, Random& random) {
  const world::Face& face = level.face(index);
  const render::TileGrid tiles = render::tile_grid(face);
  BlockRequest request{};
  request.face = index;
  request.tile_s = static_cast<std::uint16_t>(random.below(tiles.s));
  request.tile_t = static_cast<std::uint16_t>(random.below(tiles.t));
  const int finest = level.texture(face.texture).finest_mip();
  request.mip = finest + static_cast<int>(random.below(static_cast<std::size_t>(4 - finest)));
  request.contents.texture = face.texture;
  request.contents.colored = !level.light_rgb.empty() && random.chance(0.7);
  for (std::size_t style = 0; style < face.style_count; ++style)
    request.contents.style_values[style] =
        random.chance(0.3) ? 256 : static_cast<std::uint16_t>(random.below(random.chance(0.2) ? 4000 : 600));
  return request;
}

void expect_all_as_defined(const DrawableLevel& drawable, Random& random, int rounds) {
  base::Arena scratch;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t number = 0; number < drawable.level->faces.size(); number += kFaceStep) {
      const auto index = base::to_index<world::FaceIndex>(number);
      if (!has_surface(drawable.level->face(index))) continue;
      const BlockRequest request = any_request(*drawable.level, index, random);
      const PixelFormat format = random.chance(0.5) ? PixelFormat::kIndexed : PixelFormat::kRgb;
      const bool simd_kernels = random.chance(0.7);
      SCOPED_TRACE(fmt::format("{}, round {}, face {}, tile {}, {}, mip {}, {}{}", drawable.name, round,
                               number, request.tile_s, request.tile_t, request.mip,
                               format == PixelFormat::kIndexed ? "indexed" : "rgb",
                               simd_kernels ? "" : ", plain"));
      expect_as_defined(drawable, request, format, simd_kernels, scratch);
      if (testing::Test::HasFatalFailure()) return;
    }
}

class SurfacesOfSmallLevel : public testing::TestWithParam<SmallLevelVariant> {};
TEST_P(SurfacesOfSmallLevel, AreAsDefined) {
  Random random(1);
  expect_all_as_defined(small_level(GetParam().options, GetParam().name), random, effort(3, 1));
}
std::vector<SmallLevelVariant> lit_variants() {
  std::vector<SmallLevelVariant> variants = small_level_variants();
  std::erase_if(variants, [](const SmallLevelVariant& variant) { return !variant.options.light; });
  return variants;
}
INSTANTIATE_TEST_SUITE_P(Variants, SurfacesOfSmallLevel, testing::ValuesIn(lit_variants()),
                         [](const auto& test) { return test.param.name; });

// A light map of any size, turned and scaled in any way.
world::LightMapGrid make_random_grid(Random& random) {
  world::LightMapGrid grid{};
  grid.width = static_cast<std::int32_t>(random.log_uniform(1, 100));
  grid.height = static_cast<std::int32_t>(random.log_uniform(1, 100));
  const double scale = random.log_uniform(0.005, 2);
  const auto vector = [&](double size) {
    return math::Vec2d(random.uniform(-size, size), random.uniform(-size, size));
  };
  grid.first = vector(50);
  grid.per_s = vector(scale);
  grid.per_t = vector(scale);
  grid.texels = 1 << random.below(5);
  return grid;
}

std::shared_ptr<const formats::TextureColors> make_random_colors(const world::Texture& texture,
                                                                 int max_detail, Random& random) {
  formats::TextureColors colors;
  colors.detail = static_cast<int>(random.below(static_cast<std::size_t>(max_detail + 1)));
  const bool has_glow = random.chance(0.5);
  for (int mip = -colors.detail; mip < 4; ++mip) {
    const std::int64_t texels = std::max<std::int64_t>(1, floor_shifted(texture.width, mip)) *
                                std::max<std::int64_t>(1, floor_shifted(texture.height, mip));
    const auto fill = [&](auto& out, auto make) {
      for (std::int64_t i = 0; i < texels; ++i) out.push_back(make());
    };
    const auto channels = [&] { return static_cast<std::uint32_t>(random.below(1 << 24)); };
    if (mip < 0)
      fill(*colors.fine_indices.emplace(colors.fine_indices.begin()),
           [&] { return static_cast<std::uint8_t>(random.bits()); });
    fill(colors.colors.emplace_back(), [&] { return 0xff000000u | channels(); });
    if (has_glow) fill(colors.glow.emplace_back(), [&] { return random.chance(0.5) ? 0 : channels(); });
  }
  return std::make_shared<const formats::TextureColors>(std::move(colors));
}

// One face of any extent, from nothing to several tiles, anywhere in a texture of any size, with random
// samples and colors.
DrawableLevel make_random_level(Random& random) {
  world::Level level;
  world::Texture texture;
  texture.width = static_cast<std::uint32_t>(random.log_uniform(1, 300));
  texture.height = static_cast<std::uint32_t>(random.log_uniform(1, 300));
  for (std::uint32_t mip = 0; mip < 4; ++mip)
    for (std::uint32_t i = std::max(1u, texture.width >> mip) * std::max(1u, texture.height >> mip); i > 0;
         --i)
      texture.mips[mip].push_back(static_cast<std::uint8_t>(random.bits()));
  world::Face face{};
  face.kind = world::FaceKind::kLit;
  face.style_count = static_cast<std::uint8_t>(random.below(5));
  face.light = static_cast<std::uint32_t>(random.below(20));
  const auto sixteens = [&](std::size_t most) { return static_cast<std::int32_t>(16 * random.below(most)); };
  face.texture_mins = {sixteens(100) - 800, sixteens(100) - 800};
  face.texture_extents = {sixteens(random.chance(0.3) ? 40 : 5), sixteens(random.chance(0.3) ? 40 : 5)};
  if (random.chance(0.5)) {
    face.light_map_grid = 0;
    level.light_map_grids.push_back(make_random_grid(random));
  }
  level.faces.push_back(face);
  // Fine levels of small faces and textures only: the definition is slow.
  const bool is_large = std::max(face.texture_extents[0], face.texture_extents[1]) > 80;
  if (random.chance(0.1) && texture.width * texture.height < 3000)
    texture.colors = make_random_colors(texture, is_large ? 1 : 3, random);
  level.textures.push_back(texture);
  const auto [width, height] = level.light_size(face);
  const std::size_t samples = face.light + std::size_t{face.style_count} * static_cast<std::size_t>(width) *
                                               static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < samples; ++i) level.light.push_back(static_cast<std::uint8_t>(random.bits()));
  if (random.chance(0.5))
    for (std::size_t i = 0; i < samples * 3; ++i)
      level.light_rgb.push_back(static_cast<std::uint8_t>(random.bits()));

  DrawableLevel drawable{"noise", std::make_shared<const world::Level>(std::move(level)), {}, {}};
  for (formats::Rgb& color : drawable.palette) {
    color.r = static_cast<std::uint8_t>(random.bits());
    color.g = static_cast<std::uint8_t>(random.bits());
    color.b = static_cast<std::uint8_t>(random.bits());
  }
  for (std::uint8_t& entry : drawable.colormap.rows) entry = static_cast<std::uint8_t>(random.bits());
  drawable.colormap.fullbrights = static_cast<int>(random.below(257));
  return drawable;
}

// A light map of its own that lies where the stock map lies gives the same block, bit for bit, at every mip
// level.
TEST(Surfaces, AreTheSameFromAnEqualGrid) {
  for (int seed = 0; seed < effort(300, 30); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const DrawableLevel stock = make_random_level(random);
    if (stock.level->faces[0].light_map_grid != world::kStockGrid || !has_surface(stock.level->faces[0]))
      continue;
    auto level = std::make_shared<world::Level>(*stock.level);
    world::Face& face = level->faces[0];
    face.light_map_grid = 0;
    level->light_map_grids.push_back(
        {face.light_width(), face.light_height(), {0, 0}, {1.0 / 16, 0}, {0, 1.0 / 16}, 16});
    BlockRequest request = any_request(*level, world::FaceIndex{0}, random);
    const render::ColorTables tables = render::make_color_tables(stock.palette, stock.colormap);
    base::Arena scratch;
    const SurfaceShape shape = render::surface_shape(face, request.tile_s, request.tile_t, request.mip);
    for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
      BuiltBlock expected(shape, format == PixelFormat::kIndexed ? 1 : 4), block = expected;
      request.block = expected.view();
      render::build_surface(*stock.level, tables, nullptr, request, format, true, scratch);
      request.block = block.view();
      render::build_surface(*level, tables, nullptr, request, format, true, scratch);
      ASSERT_EQ(block.bytes, expected.bytes) << seed;
    }
  }
}

TEST(Surfaces, OfNoiseAreAsDefined) {
  for (int seed = 0; seed < effort(1000, 100); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    expect_all_as_defined(make_random_level(random), random, 3);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

// At every mip level, the tiles of a face are adjacent: together they are as large as the face.
TEST(SurfaceShapes, MakeUpTheFace) {
  for (std::int32_t extent = 16; extent <= 1600; extent += 16)
    for (int mip = -3; mip < 4; ++mip) {
      world::Face face{};
      face.kind = world::FaceKind::kLit;
      face.texture_extents = {extent, 1616 - extent};
      const render::TileGrid tiles = render::tile_grid(face);
      std::int32_t width = 0, height = 0;
      for (int tile = 0; tile < tiles.s; ++tile) {
        const SurfaceShape shape = render::surface_shape(face, tile, 0, mip);
        ASSERT_GE(shape.width, 1);
        ASSERT_LE(shape.width, floor_shifted(256, mip));
        width += shape.width;
      }
      for (int tile = 0; tile < tiles.t; ++tile) height += render::surface_shape(face, 0, tile, mip).height;
      ASSERT_EQ(width, floor_shifted(face.texture_extents[0], mip));
      ASSERT_EQ(height, floor_shifted(face.texture_extents[1], mip));
    }
}
TEST(SurfaceShapes, HaveATexelWhereTheFaceHasNoExtent) {
  for (int mip = 0; mip < 4; ++mip) {
    const SurfaceShape shape = render::surface_shape(world::Face{}, 0, 0, mip);
    EXPECT_EQ(shape.width, 1);
    EXPECT_EQ(shape.height, 1);
  }
}

}  // namespace
}  // namespace temblor::test
