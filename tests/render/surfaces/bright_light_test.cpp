// Light that is brighter than full light keeps its hue in `rgb` pictures.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>
#include <vector>

#include "render/surfaces/build_surface.h"
#include "support/levels/drawable_level.h"

namespace temblor::test {
namespace {

using Light = std::array<std::uint8_t, 3>;

// One square of 16 x 16 texels, all of them gray 100, which full light shows as gray 199. `steady` falls on
// it in style 0, and `flickering` in style 1.
DrawableLevel make_wall(const Light& steady, const Light& flickering) {
  constexpr std::size_t kSamples = 4;
  world::Level level;
  world::Texture texture;
  texture.width = texture.height = 16;
  for (std::size_t mip = 0; mip < 4; ++mip) texture.mips[mip].resize(std::size_t{256} >> 2 * mip, 1);
  level.textures.push_back(texture);
  world::Face face{};
  face.kind = world::FaceKind::kLit;
  face.style_count = 2;
  face.styles = {0, 1, world::kNoStyle, world::kNoStyle};
  face.texture_extents = {16, 16};
  level.faces.push_back(face);
  for (const Light& light : {steady, flickering})
    for (std::size_t sample = 0; sample < kSamples; ++sample) {
      level.light.push_back(light[0]);
      level.light_rgb.insert(level.light_rgb.end(), light.begin(), light.end());
    }
  DrawableLevel wall{"wall", std::make_shared<const world::Level>(std::move(level)), {}, {}};
  wall.palette[1] = {100, 100, 100};
  return wall;
}

// The red, green, and blue of the wall's texel at 5, 7.
Light draw(const DrawableLevel& wall, std::uint16_t flicker, bool simd_kernels) {
  const render::ColorTables tables = render::make_color_tables(wall.palette, wall.colormap);
  const render::SurfaceShape shape = render::surface_shape(wall.level->faces[0], 0, 0, 0);
  std::vector<std::byte> bytes(shape.texels() * 4 + render::kBlockPadding);
  render::BlockRequest request{};
  request.contents.colored = true;
  request.contents.style_values = {256, flicker, 0, 0};
  request.block = {bytes.data(), shape};
  base::Arena scratch;
  render::build_surface(*wall.level, tables, nullptr, request, render::PixelFormat::kRgb, simd_kernels,
                        scratch);
  std::uint32_t texel;
  std::memcpy(&texel, bytes.data() + (7 * 16 + 5) * sizeof(texel), sizeof(texel));
  return {static_cast<std::uint8_t>(texel >> 16), static_cast<std::uint8_t>(texel >> 8),
          static_cast<std::uint8_t>(texel)};
}

constexpr std::uint8_t kFullyLit = 199;

TEST(BrightLight, OfOneColorDoesNotChange) {
  const DrawableLevel wall = make_wall({200, 120, 40}, {100, 60, 20});
  const Light full = draw(wall, 256, true);
  EXPECT_EQ(full[0], kFullyLit);
  EXPECT_NEAR(full[1], kFullyLit * 0.6, 1);
  EXPECT_NEAR(full[2], kFullyLit * 0.2, 1);
  for (std::uint16_t flicker = 150; flicker < 600; flicker += 22)
    for (const bool simd_kernels : {false, true})
      EXPECT_EQ(draw(wall, flicker, simd_kernels), full) << flicker;
}

// Cut off one by one, the channels would all be full, and the wall would stay gray.
TEST(BrightLight, ShowsRedOnAWallThatIsFullyLitByWhite) {
  const DrawableLevel wall = make_wall({255, 255, 255}, {200, 0, 0});
  for (std::uint16_t flicker = 0; flicker < 600; flicker += 22)
    for (const bool simd_kernels : {false, true}) {
      const Light shown = draw(wall, flicker, simd_kernels);
      const double white = 255.0 * 256, red = 200.0 * flicker;
      EXPECT_EQ(shown[0], kFullyLit) << flicker;
      EXPECT_NEAR(shown[1], kFullyLit * white / (white + red), 1) << flicker;
      EXPECT_EQ(shown[2], shown[1]) << flicker;
    }
}

TEST(BrightLight, OfEqualChannelsIsCutOffAsGrayLightIs) {
  const DrawableLevel wall = make_wall({255, 255, 255}, {31, 31, 31});
  for (std::uint16_t flicker = 0; flicker < 600; flicker += 22)
    EXPECT_EQ(draw(wall, flicker, true), (Light{kFullyLit, kFullyLit, kFullyLit})) << flicker;
}

}  // namespace
}  // namespace temblor::test
