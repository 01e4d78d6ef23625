// Tests that the comparison finds errors, in pictures that the oracle painted and the test spoiled.
#include "oracle/comparison.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "oracle/polygon_level.h"

namespace temblor::oracle {
namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr render::PixelFace kBackground{render::PixelFace::kNothing, render::PixelFace::kNothing};

// A tilted square and a smaller one in front of it, full-bright; a part of the picture shows neither.
world::Level two_squares() {
  const PolygonVertices behind = {{40, 30, -30}, {60, 30, 30}, {60, -20, 30}, {40, -20, -30}};
  const PolygonVertices before = {{20, 5, -5}, {20, 5, 5}, {20, -5, 5}, {20, -5, -5}};
  const std::array models = {PolygonModel{{behind, before}}};
  world::Level level = make_polygon_level(models);
  for (world::Face& face : level.faces) face.kind = world::FaceKind::kUnlit;
  return level;
}

class SpoiledPicture : public testing::Test {
 protected:
  SpoiledPicture() : level_(two_squares()), prepared_(level_), faces_(frame_.pixel_count(), kBackground) {
    scene_.level = &level_;
    // The texture's axes are x and y: from +x both squares would show single columns of it.
    for (world::Face& face : level_.faces) {
      face.texture_mins = {-64, -64};
      face.texture_extents = {128, 128};
    }
    level_.texture_axes[0] = {{0, 1, 0}, 0.3f, {0, 0, 1}, 0.3f};
    paint();
  }

  void paint() {
    const RayScene rays(prepared_, {});
    const CameraRays camera(scene_.camera, kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const std::size_t i = position(x, y);
        const Ray ray = camera.ray(x, y);
        const auto hit = rays.nearest(ray, 1.0 / 16);
        frame_.indexed()[i] = 0;
        frame_.depth()[i] = 0;
        if (!hit) continue;
        faces_[i] = {0, static_cast<std::uint32_t>(hit->face)};
        const math::Vec2d at = texture_position(level_, level_.face(hit->face), ray.at(hit->distance));
        frame_.indexed()[i] = texel_at(level_.textures[0], {static_cast<std::int64_t>(std::floor(at.x)),
                                                            static_cast<std::int64_t>(std::floor(at.y))});
        frame_.depth()[i] = static_cast<float>(1 / hit->distance);
      }
    }
  }

  Tally compare() const {
    return Comparison(prepared_, scene_, {frame_, faces_, palette_, colormap_, false}).whole_frame();
  }

  static std::size_t position(int x, int y) { return static_cast<std::size_t>(y * kWidth + x); }

  world::Level level_;
  PreparedLevel prepared_;
  render::Scene scene_;
  render::FrameBuffer frame_{kWidth, kHeight, render::PixelFormat::kIndexed};
  std::vector<render::PixelFace> faces_;
  formats::Palette palette_{};
  formats::Colormap colormap_{};
};

TEST_F(SpoiledPicture, IsRightBeforeItIsSpoiled) {
  const Tally tally = compare();
  EXPECT_EQ(tally.pixels, static_cast<std::uint64_t>(kWidth * kHeight));
  EXPECT_EQ(tally.same_face, tally.pixels) << tally.summary();
  EXPECT_GT(tally.colors, 500u);
  EXPECT_EQ(tally.right_colors, tally.colors) << tally.summary();
  EXPECT_EQ(tally.right_depths, tally.depths) << tally.summary();
}

TEST_F(SpoiledPicture, WithAWrongFaceFarFromAnyEdge) {
  ASSERT_EQ(faces_[position(31, 24)].face, 1u);
  faces_[position(31, 24)].face = 0;
  const Tally tally = compare();
  EXPECT_EQ(tally.wrong_face, 1u);
  ASSERT_EQ(tally.findings.size(), 1u);
  EXPECT_NE(tally.findings[0].find("pixel 31,24: oracle 0/1"), std::string::npos) << tally.findings[0];
}

TEST_F(SpoiledPicture, WithAHole) {
  faces_[position(31, 24)] = kBackground;
  EXPECT_EQ(compare().wrong_face, 1u);
}

// Everything shifted one pixel to the right: correct except at the edges of faces.
TEST_F(SpoiledPicture, ShiftedByAPixel) {
  for (int y = 0; y < kHeight; ++y)
    for (int x = kWidth - 1; x > 0; --x) faces_[position(x, y)] = faces_[position(x - 1, y)];
  const Tally tally = compare();
  EXPECT_EQ(tally.wrong_face, 0u) << tally.summary();
  EXPECT_GT(tally.near_edge, 30u);
}

TEST_F(SpoiledPicture, ShiftedByThreePixels) {
  for (int y = 0; y < kHeight; ++y)
    for (int x = kWidth - 1; x > 2; --x) faces_[position(x, y)] = faces_[position(x - 3, y)];
  EXPECT_GT(compare().wrong_face, 30u);
}

TEST_F(SpoiledPicture, WithColorsOfTheNextTexel) {
  level_.texture_axes[0].s_offset += 1;
  const Tally tally = compare();
  EXPECT_EQ(tally.same_face, tally.pixels);
  EXPECT_LT(tally.color_agreement(), 0.1) << tally.summary();
}

TEST_F(SpoiledPicture, WithDepthsOfTheNextPixel) {
  for (std::size_t i = 0; i + 1 < frame_.pixel_count(); ++i) frame_.depth()[i] = frame_.depth()[i + 1];
  // The smaller square is upright: its 1/z is constant, so only the tilted one's is wrong.
  const Tally tally = compare();
  EXPECT_LT(tally.right_depths, tally.depths) << tally.summary();
}

// Compilers leave faces that no leaf lists; they count as absent.
TEST_F(SpoiledPicture, WithAFaceThatNoLeafLists) {
  level_.leaves[1].marked_face_count = 1;
  EXPECT_GT(compare().wrong_face, 50u);
}

// Two faces in the same place: the renderer may draw either.
TEST_F(SpoiledPicture, WithATie) {
  const PolygonVertices square = {{20, 5, -5}, {20, 5, 5}, {20, -5, 5}, {20, -5, -5}};
  const std::array models = {PolygonModel{{square, square}}};
  const world::Level level = make_polygon_level(models);
  const PreparedLevel prepared(level);
  scene_.level = &level;
  for (const std::uint32_t face : {0u, 1u}) {
    for (render::PixelFace& pixel : faces_) pixel = {0, face};
    Tally tally;
    Comparison(prepared, scene_, {frame_, faces_, palette_, colormap_, false}).pixel(31, 24, tally);
    EXPECT_EQ(tally.same_face + tally.tied, 1u) << face;
  }
}

}  // namespace
}  // namespace temblor::oracle
