// Lights that project a texture.
#include "compiler/light/sources/projection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compiler/light/keys/key_room.h"
#include "compiler/light/lighting.h"

namespace temblor::test {
namespace {

using compiler::Projection;
using math::Vec3;
using math::Vec3d;

// A projector with a picture of four colors: red, green / blue, white.
Projection four_colors(const char* mangle, const char* fov = "90") {
  const formats::Entity entity{{{"classname", "light"},
                                {"_project_texture", "four"},
                                {"_project_mangle", mangle},
                                {"_project_fov", fov}}};
  Projection projection = compiler::read_projection(entity, {}).value();
  projection.width = projection.height = 2;
  projection.texels = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  return projection;
}

TEST(Projection, PictureIsUprightAndReadsFromLeftToRight) {
  const Projection ahead = four_colors("0 0 0");  // along x, so left is y and up is z
  const auto expect_color = [](const Projection& projection, const Vec3& way, const Vec3& color) {
    EXPECT_LT(glm::length(compiler::find_projected_color(projection, way) - color), 1e-5f);
  };
  for (const float distance : {1.0f, 64.0f}) {
    expect_color(ahead, Vec3(1, 0.5f, 0.5f) * distance, {1, 0, 0});
    expect_color(ahead, Vec3(1, -0.5f, 0.5f) * distance, {0, 1, 0});
    expect_color(ahead, Vec3(1, 0.5f, -0.5f) * distance, {0, 0, 1});
    expect_color(ahead, Vec3(1, -0.5f, -0.5f) * distance, {1, 1, 1});
    expect_color(ahead, Vec3(1, 0, 0) * distance, {0.5f, 0.5f, 0.5f});
  }
  // A quarter turn clockwise brings the left top to the right top.
  expect_color(four_colors("0 0 90"), {1, -0.5f, 0.5f}, {1, 0, 0});
  expect_color(four_colors("90 0 0"), {-0.5f, 1, 0.5f}, {1, 0, 0});
  // Straight down, the top of the picture is where yaw leads.
  expect_color(four_colors("0 -90 0"), {0.5f, 0.5f, -1}, {1, 0, 0});
}

TEST(Projection, IsDarkBeyondItsAngle) {
  for (const char* fov : {"40", "90", "120"}) {
    const Projection ahead = four_colors("0 0 0", fov);
    const auto edge = static_cast<float>(std::tan(std::stod(fov) / 2 * std::numbers::pi / 180));
    const auto is_lit = [&](float y, float z) {
      return compiler::find_projected_color(ahead, {1, y, z}) != Vec3(0.0f);
    };
    EXPECT_TRUE(is_lit(edge * 0.99f, 0)) << fov;
    EXPECT_TRUE(is_lit(0, -edge * 0.99f)) << fov;
    EXPECT_FALSE(is_lit(edge * 1.01f, 0)) << fov;
    EXPECT_FALSE(is_lit(0, -edge * 1.01f)) << fov;
    EXPECT_EQ(compiler::find_projected_color(ahead, {-1, 0, 0}), Vec3(0.0f));
  }
}

// Lights the floor with and without a picture; their ratio is the picture.
TEST(Projection, FloorShowsThePicture) {
  formats::Palette palette{};
  for (std::size_t i = 0; i < palette.size(); ++i)
    palette[i] = {static_cast<std::uint8_t>(i), 255, static_cast<std::uint8_t>(255 - i)};
  const std::string down = "'_project_texture' 'stone' '_project_mangle' '0 -90 0' '_project_fov' '45'";
  const auto bare = lit_map(key_room(lamp()), {{}, palette}),
             shown = lit_map(key_room(lamp(down)), {{}, palette});
  const auto texture = std::ranges::find(shown->textures, "stone", &world::Texture::name);
  ASSERT_NE(texture, shown->textures.end());
  const double size =
      2 * kLampHeight * std::tan(22.5 * std::numbers::pi / 180);  // of the picture on the floor
  int inside = 0, outside = 0;
  for (int x = -112; x <= 112; x += 16)
    for (int y = -112; y <= 112; y += 16) {
      const Vec3d place(x, y, 0);
      // Means over a luxel's square, by texels at many points. The top is at x, the right at -y.
      Vec3d color(0.0);
      constexpr int kPoints = 32;
      for (int i = 0; i < kPoints * kPoints; ++i) {
        const double right = -(y + (i % kPoints + 0.5) / kPoints * 16 - 8) / size + 0.5;
        const double down_part = -(x + (i / kPoints + 0.5) / kPoints * 16 - 8) / size + 0.5;
        if (right < 0 || right >= 1 || down_part < 0 || down_part >= 1) continue;
        const auto column = static_cast<std::size_t>(right * texture->width);
        const auto row = static_cast<std::size_t>(down_part * texture->height);
        const formats::Rgb& texel = palette[texture->mips[0][row * texture->width + column]];
        color += Vec3d(texel.r, texel.g, texel.b) / (255.0 * kPoints * kPoints);
      }
      const Vec3d all = shown_light(*bare, face_under(*bare, place, kFaceUp), place);
      const Vec3d part = shown_light(*shown, face_under(*shown, place, kFaceUp), place);
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_NEAR(part[channel], all[channel] * color[channel], all.x * 0.1 + 1) << x << " " << y;
      ++(color == Vec3d(0.0) ? outside : inside);
      if (color == Vec3d(0.0)) {
        ASSERT_EQ(part, Vec3d(0.0)) << x << " " << y;
      }
    }
  EXPECT_GT(inside, 80);
  EXPECT_GT(outside, 40);
}

TEST(Projection, MissingTextureIsReportedAndLeavesTheLight) {
  const auto room = [](const char* keys) {
    return light(room_with({std::string("{ 'classname' 'light' 'origin' '0 0 40' ") + keys + " }"}));
  };
  const LitResult lit = room("'_project_texture' 'slide'");
  ASSERT_EQ(lit.warnings.size(), 1u);
  EXPECT_NE(lit.warnings[0].what.find("\"0 0 40\": \"slide\" is not projected"), std::string::npos)
      << lit.warnings[0].what;
  EXPECT_EQ(lit.bsp.lighting, room("").bsp.lighting);
}

}  // namespace
}  // namespace temblor::test
