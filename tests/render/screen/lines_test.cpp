// Lines over the view, against points along them that are projected one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "artgen/palette.h"
#include "render/screen/draw_lines.h"
#include "support/levels/drawable_level.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::FrameBuffer;
using render::Line;
using render::PixelFormat;

constexpr std::uint32_t kUndrawn = 0xff000000, kWhite = 0xffffffff;

render::ViewFrame make_view(const render::Camera& camera, int width, int height) {
  static const DrawableLevel level = small_level();
  render::Scene scene;
  scene.level = level.level.get();
  scene.camera = camera;
  return render::make_view_frame(scene, width, height);
}

FrameBuffer draw(const std::vector<Line>& lines, const render::ViewFrame& view) {
  FrameBuffer frame(view.width, view.height, PixelFormat::kRgb);
  std::ranges::fill(frame.rgb(), kUndrawn);
  draw_lines(lines, view, artgen::make_palette(), frame);
  return frame;
}

bool is_drawn(const FrameBuffer& frame, int x, int y) {
  return x >= 0 && y >= 0 && x < frame.width() && y < frame.height() &&
         frame.rgb()[static_cast<std::size_t>(y * frame.width() + x)] == kWhite;
}

bool is_drawn_around(const FrameBuffer& frame, const math::Vec2d& at) {
  const int x = static_cast<int>(std::lround(at.x)), y = static_cast<int>(std::lround(at.y));
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (is_drawn(frame, x + dx, y + dy)) return true;
  return false;
}

// The pixels of points along the line that are in front of the eye and on the screen.
std::vector<math::Vec2d> project_points(const Line& line, const render::ViewFrame& view) {
  constexpr int kPoints = 20000;
  std::vector<math::Vec2d> seen;
  for (int i = 0; i <= kPoints; ++i) {
    const math::Vec3d from(line.from_world), to(line.to_world);
    const math::Vec3d p = view.to_view(from + (to - from) * (double{1} * i / kPoints));
    if (p.z < view.near_z) continue;
    const math::Vec2d at = view.to_screen(p);
    if (at.x >= 0 && at.y >= 0 && at.x <= view.width - 1 && at.y <= view.height - 1) seen.push_back(at);
  }
  return seen;
}

TEST(Lines, PassThroughThePixelsOfTheirPoints) {
  int drawn_lines = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    render::Camera camera;
    camera.angles_deg = random.in_cube(180);
    camera.fov_deg = static_cast<float>(random.uniform(30, 150));
    if (random.chance(0.2)) camera = {.projection = render::Projection::kOrthographic, .units_per_pixel = 1};
    const render::ViewFrame view = make_view(camera, 160, 100);
    const Line line{random.in_cube(100), random.in_cube(100)};
    const FrameBuffer frame = draw({line}, view);
    const std::vector<math::Vec2d> points = project_points(line, view);
    drawn_lines += points.size() > 100;
    for (const math::Vec2d& at : points) ASSERT_TRUE(is_drawn_around(frame, at)) << seed;
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        if (!is_drawn(frame, x, y)) continue;
        // Points near the eye are far apart on the screen.
        const bool is_on_line = std::ranges::any_of(
            points, [&](const math::Vec2d& at) { return std::abs(at.x - x) < 3 && std::abs(at.y - y) < 3; });
        ASSERT_TRUE(is_on_line) << seed << ": " << x << "," << y;
      }
  }
  EXPECT_GT(drawn_lines, 50);
}

TEST(Lines, IndexedFramesGetTheNearestColor) {
  const render::ViewFrame view = make_view({}, 64, 40);
  FrameBuffer frame(64, 40, PixelFormat::kIndexed);
  std::ranges::fill(frame.indexed(), std::uint8_t{0});
  const formats::Palette palette = artgen::make_palette();
  const formats::Rgb color = palette[79];
  draw_lines(std::vector<Line>{{math::Vec3(50, 10, 0), math::Vec3(50, -10, 0), color}}, view, palette, frame);
  const auto drawn = std::ranges::find_if(frame.indexed(), [](std::uint8_t index) { return index != 0; });
  ASSERT_NE(drawn, frame.indexed().end());
  EXPECT_EQ(palette[*drawn], color);
}

// A floor of depth 1/50 covers the left half of the frame. Lines cross it at other distances.
TEST(Lines, WithADepthTestAreHiddenByWhatIsNearer) {
  const render::ViewFrame view = make_view({}, 64, 40);
  for (const PixelFormat format : {PixelFormat::kRgb, PixelFormat::kIndexed}) {
    FrameBuffer frame(64, 40, format);
    const auto count = [&](float distance, bool is_depth_tested, bool left) {
      std::ranges::fill(frame.rgb(), kUndrawn);
      std::ranges::fill(frame.indexed(), std::uint8_t{0});
      for (std::size_t i = 0; i < frame.pixel_count(); ++i)
        frame.depth()[i] = i % 64 < 32 ? 1.0f / 50 : std::numeric_limits<float>::lowest();
      const Line line{{distance, 500, 0}, {distance, -500, 0}, {255, 255, 255}, is_depth_tested};
      draw_lines(std::vector<Line>{line}, view, artgen::make_palette(), frame);
      int drawn = 0;
      for (std::size_t i = 0; i < frame.pixel_count(); ++i)
        if ((i % 64 < 32) == left)
          drawn += format == PixelFormat::kRgb ? frame.rgb()[i] != kUndrawn : frame.indexed()[i] != 0;
      return drawn;
    };
    EXPECT_EQ(count(40, true, true), 32) << "in front";
    EXPECT_EQ(count(50, true, true), 32) << "on it";
    EXPECT_EQ(count(60, true, true), 0) << "behind";
    EXPECT_EQ(count(60, true, false), 32) << "beside it";
    EXPECT_EQ(count(60, false, true), 32) << "without a test";
  }
}

// A line into the depth ends where it enters the wall.
TEST(Lines, AreTestedWhereTheyAre) {
  const render::ViewFrame view = make_view({}, 200, 150);
  FrameBuffer frame(200, 150, PixelFormat::kRgb);
  std::ranges::fill(frame.rgb(), kUndrawn);
  std::ranges::fill(frame.depth(), 1.0f / 100);
  draw_lines(std::vector<Line>{{{10, 5, -9}, {400, 5, -9}, {255, 255, 255}, true}}, view,
             artgen::make_palette(), frame);
  const auto at = [&](double distance) {
    const math::Vec2d pixel = view.to_screen(view.to_view({distance, 5, -9}));
    return is_drawn_around(frame, pixel);
  };
  EXPECT_TRUE(at(20) && at(60) && at(95));
  EXPECT_FALSE(at(200) || at(390));
}

TEST(Lines, WithstandAnyNumbers) {
  const render::ViewFrame view = make_view({}, 64, 40);
  const float huge = std::numeric_limits<float>::max(), nan = std::numeric_limits<float>::quiet_NaN(),
              infinite = std::numeric_limits<float>::infinity();
  const auto count = [&](const Line& line) { return std::ranges::count(draw({line}, view).rgb(), kWhite); };
  EXPECT_EQ(count({math::Vec3(nan, 0, 0), math::Vec3(50, 0, 0)}), 0);
  EXPECT_EQ(count({math::Vec3(50, 0, 0), math::Vec3(50, -infinite, 0)}), 0);
  EXPECT_EQ(count({math::Vec3(-1, 0, 0), math::Vec3(-50, 0, 0)}), 0) << "behind the eye";
  EXPECT_EQ(count({math::Vec3(50, 0, 0), math::Vec3(50, 0, 0)}), 1);
  EXPECT_EQ(count({math::Vec3(50, huge, 0), math::Vec3(50, -huge, 0)}), 64);
  EXPECT_EQ(count({math::Vec3(-huge), math::Vec3(-huge)}), 0);
}

}  // namespace
}  // namespace temblor::test
