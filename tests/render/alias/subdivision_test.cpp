// Subdivision against the affine rasterizer, by size: the error decides up to which size it may replace it
// (kSubdivisionSidePx).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/alias/prepare_alias.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/levels/drawable_level.h"
#include "support/models/drawable_models.h"
#include "support/random.h"

namespace temblor::test {
namespace {

constexpr int kBentWidth = 320, kBentHeight = 240;
constexpr double kFocalPx = kBentHeight * 4 / 3.0 / 2;  // 90 degrees

// Skins of distant models are smooth colors, not noise.
formats::Mdl smooth_sphere() {
  formats::Mdl mdl = sphere_mdl();
  for (std::size_t i = 0; i < mdl.skins[0].pictures[0].size(); ++i)
    mdl.skins[0].pictures[0][i] = static_cast<std::uint8_t>(4 + i % mdl.skin_width / 16);
  return mdl;
}

double mean_side(const formats::Mdl& mdl) {
  double sum = 0;
  for (const formats::MdlTriangle& triangle : mdl.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t corner) {
        const auto& bytes = mdl.frames[0].poses[0].vertices[triangle.vertices[corner % 3]].position;
        return math::Vec3d(bytes[0], bytes[1], bytes[2]);
      };
      sum += glm::distance(at(i), at(i + 1));
    }
  return sum / static_cast<double>(mdl.triangles.size() * 3);
}

struct Difference {
  int farthest_px = 0;    // from a pixel that one covers to the nearest that the other does
  double brightness = 0;  // mean difference where both cover, of 255
  std::size_t covered = 0;
};

// The distance to the nearest covered pixel, along the longer axis.
int distance_to_cover(const render::FrameBuffer& frame, int x, int y) {
  for (int reach = 0; reach < 8; ++reach)
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const int at_x = x + dx, at_y = y + dy;
        if (at_x < 0 || at_y < 0 || at_x >= kBentWidth || at_y >= kBentHeight) continue;
        if (frame.depth()[static_cast<std::size_t>(at_y * kBentWidth + at_x)] > 0) return reach;
      }
  return 8;
}

void compare(const render::FrameBuffer& a, const render::FrameBuffer& b, Difference& io_delta,
             double& io_sum) {
  for (int y = 0; y < kBentHeight; ++y)
    for (int x = 0; x < kBentWidth; ++x) {
      const auto i = static_cast<std::size_t>(y * kBentWidth + x);
      const bool in_a = a.depth()[i] > 0, in_b = b.depth()[i] > 0;
      if (in_a != in_b)
        io_delta.farthest_px = std::max(io_delta.farthest_px, distance_to_cover(in_a ? b : a, x, y));
      if (!in_a || !in_b) continue;
      ++io_delta.covered;
      const auto brightness = [&](std::uint32_t color) {
        return ((color >> 16 & 255) + (color >> 8 & 255) + (color & 255)) / 3.0;
      };
      io_sum += std::abs(brightness(a.rgb()[i]) - brightness(b.rgb()[i]));
    }
}

class Subdivision : public testing::Test {
 protected:
  Difference difference_at(double side_px, render::AliasRaster raster) {
    Difference difference;
    double sum = 0;
    for (int seed = 0; seed < effort(60, 8); ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      render::Scene scene;
      scene.level = drawable_.level.get();
      scene.camera.origin_world = {0, 0, 100000};
      render::AliasInstance instance;
      instance.model = model_.get();
      const double distance = side_ * kFocalPx / side_px;
      instance.origin_world = scene.camera.origin_world + math::Vec3(static_cast<float>(distance), 0, 0) +
                              random.in_cube(kSize / 8);
      instance.angles_deg = random.in_cube(180);
      instance.min_light = 100;
      scene.alias_models = {&instance, 1};
      render::FrameBuffer affine(kBentWidth, kBentHeight, render::PixelFormat::kRgb),
          other(kBentWidth, kBentHeight, render::PixelFormat::kRgb);
      renderer_.render(scene, {.alias_raster = render::AliasRaster::kAffine}, affine);
      renderer_.render(scene, {.alias_raster = raster}, other);
      compare(affine, other, difference, sum);
    }
    difference.brightness = sum / static_cast<double>(std::max<std::size_t>(1, difference.covered));
    return difference;
  }

  static constexpr float kSize = 64;
  const DrawableLevel drawable_ = small_level({.tiny = true});
  const formats::Mdl mdl_ = smooth_sphere();
  const std::shared_ptr<const render::AliasModel> model_ = small_model(mdl_, kSize);
  const double side_ = mean_side(mdl_) * kSize / 255;
  render::Renderer renderer_{drawable_.palette, drawable_.colormap};
};

// The stated error: outlines off by at most one pixel, mean brightness off by at most a sixteenth of white.
constexpr int kMaxPx = 1;
constexpr double kMaxBrightness = 16;

TEST_F(Subdivision, DiffersFromAffineByLittleWhereItIsChosen) {
  for (const double side_px : {0.3, 0.5, 0.7, 1.0, render::kSubdivisionSidePx, 1.5, 2.0}) {
    const Difference difference = difference_at(side_px, render::AliasRaster::kSubdivision);
    EXPECT_LE(difference.farthest_px, kMaxPx) << side_px;
    EXPECT_LE(difference.brightness, kMaxBrightness) << side_px;
    EXPECT_GT(difference.covered, static_cast<std::size_t>(effort(50, 20))) << side_px;
  }
}

TEST_F(Subdivision, IsChosenBelowASizeAndNotAboveIt) {
  const Difference small = difference_at(render::kSubdivisionSidePx * 0.7, render::AliasRaster::kAuto);
  const Difference split = difference_at(render::kSubdivisionSidePx * 0.7, render::AliasRaster::kSubdivision);
  EXPECT_GT(small.brightness, 0);
  EXPECT_EQ(small.brightness, split.brightness);
  EXPECT_EQ(difference_at(render::kSubdivisionSidePx * 1.1, render::AliasRaster::kAuto).brightness, 0);
}

}  // namespace
}  // namespace temblor::test
