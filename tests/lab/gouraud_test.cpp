// Gouraud shading of the world: its interpolation against definitions, and its pictures against the engine's.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "lab/lit_pictures.h"
#include "lab/world_light/lit_polygons.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using render::PixelFormat;

constexpr auto kGouraud = {
    "gouraud",        "gouraud:perspective=1", "gouraud:triangles=1",
    "gouraud:spot=1", "gouraud:cut=32",        "gouraud:perspective=1,triangles=1,cut=16"};

render::ViewFrame make_frame(double roll_deg) {
  const DrawableLevel drawable = small_level();
  render::Scene scene;
  scene.level = drawable.level.get();
  scene.camera.angles_deg = {0, 0, static_cast<float>(roll_deg)};
  return render::make_view_frame(scene, 640, 480);
}

lab::WorldCorner make_corner(math::Vec3d at, float light) {
  return {at, {light, light, light}};
}

// The light of the polygon at a pixel.
double find_light(const lab::LitPolygon& polygon, double x, double y) {
  const lab::RowLight row = lab::cross_row(polygon, y);
  return row.light_left[0] +
         (row.light_right[0] - row.light_left[0]) * (x - row.left) / (row.right - row.left);
}

// On a wall across the view, light that is linear on the screen is linear on the wall.
TEST(LitPolygons, TrianglesAreLinearHoweverTheyTurn) {
  base::Arena arena;
  for (double roll = 0; roll < 360; roll += 17) {
    const render::ViewFrame view = make_frame(roll);
    const std::array corners{make_corner({100, -50, -40}, 10), make_corner({100, 50, -40}, 90),
                             make_corner({100, 0, 60}, 40)};
    const lab::LitPolygon triangle = lab::place_polygon(view, corners, false, arena);
    ASSERT_EQ(triangle.corners.size(), 3u);
    for (const auto& [b, c] : {std::pair{0.2, 0.3}, std::pair{0.5, 0.1}, std::pair{0.05, 0.9}}) {
      const math::Vec3d at = corners[0].at * (1 - b - c) + corners[1].at * b + corners[2].at * c;
      const math::Vec2d pixel = view.to_screen(view.to_view(at));
      EXPECT_NEAR(find_light(triangle, pixel.x, pixel.y), 10 * (1 - b - c) + 90 * b + 40 * c, 1e-3) << roll;
    }
  }
}

// The article's figure: the light inside of a square depends on its rotation.
TEST(LitPolygons, SquaresChangeWhenTheyTurn) {
  base::Arena arena;
  const std::array corners{make_corner({100, -40, -40}, 0), make_corner({100, 40, -40}, 100),
                           make_corner({100, 40, 40}, 0), make_corner({100, -40, 40}, 0)};
  std::vector<double> lights;
  for (const double roll : {1.0, 46.0, 91.0, 136.0}) {
    const render::ViewFrame view = make_frame(roll);
    const math::Vec2d middle = view.to_screen(view.to_view({100, 0, 0}));
    lights.push_back(find_light(lab::place_polygon(view, corners, false, arena), middle.x, middle.y));
  }
  const auto [least, most] = std::ranges::minmax(lights);
  EXPECT_LT(least, 5);
  EXPECT_GT(most, 40);
}

// On a floor, light over z is linear on the floor, and light on the screen is not; where the floor is clipped
// makes no difference to the first.
TEST(LitPolygons, LightOverZIsLinearOnTheWall) {
  base::Arena arena;
  const render::ViewFrame view = make_frame(5);
  double largest = 0;
  for (const double from : {-100.0, 20.0}) {
    const auto light = [](double x) { return static_cast<float>(x + 200); };
    const std::array corners{
        make_corner({from, -60, -30}, light(from)), make_corner({from, 60, -30}, light(from)),
        make_corner({400, 60, -30}, light(400)), make_corner({400, -60, -30}, light(400))};
    const lab::LitPolygon exact = lab::place_polygon(view, corners, true, arena);
    const lab::LitPolygon on_screen = lab::place_polygon(view, corners, false, arena);
    for (const double x : {70.0, 150.0, 300.0}) {
      const math::Vec3d at = view.to_view({x, 11, -30});
      const math::Vec2d pixel = view.to_screen(at);
      EXPECT_NEAR(find_light(exact, pixel.x, pixel.y) * at.z, light(x), 1e-2) << from;
      largest = std::max(largest, std::abs(find_light(on_screen, pixel.x, pixel.y) - double{light(x)}));
    }
  }
  EXPECT_GT(largest, 50);
}

// With the same light at every sample, all techniques show the engine's picture.
TEST(Gouraud, IsExactInFlatLight) {
  DrawableLevel drawable = small_level({.colored_light = true}, "colored");
  auto flat = std::make_shared<world::Level>(*drawable.level);
  std::ranges::fill(flat->light, std::uint8_t{90});
  for (std::size_t i = 0; i < flat->light_rgb.size(); ++i)
    flat->light_rgb[i] = static_cast<std::uint8_t>(90 + 40 * (i % 3));
  drawable.level = flat;
  for (const PixelFormat format : {PixelFormat::kIndexed, PixelFormat::kRgb}) {
    LitPictures engine(drawable, nullptr, format);
    for (const char* const technique : kGouraud) {
      LitPictures gouraud(drawable, technique, format);
      for (int seed = 0; seed < effort(10, 2); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        Viewpoint view = make_lit_view(*flat, format, random);
        view.lights.clear();
        const render::Scene scene = view.scene(*flat);
        const render::Settings settings{.simd_kernels = seed % 2 == 0};
        EXPECT_EQ(differing_pixels(engine.draw(scene, settings), gouraud.draw(scene, settings)), 0u)
            << technique << ", seed " << seed;
      }
    }
  }
}

double mean_difference(const FrameCopy& a, const FrameCopy& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    for (int shift = 0; shift <= 16; shift += 8)
      sum += std::abs(static_cast<int>(a.rgb[i] >> shift & 255) - static_cast<int>(b.rgb[i] >> shift & 255));
  return sum / static_cast<double>(a.rgb.size());
}

// The finer the grid, the nearer to the light map.
TEST(Gouraud, ApproachesTheLightMap) {
  const DrawableLevel drawable = small_level();
  constexpr std::array kFinerAndFiner = {"gouraud:perspective=1", "gouraud:perspective=1,cut=64",
                                         "gouraud:perspective=1,cut=16"};
  std::array<double, 3> differences{};
  LitPictures engine(drawable, nullptr, PixelFormat::kRgb);
  for (std::size_t i = 0; i < kFinerAndFiner.size(); ++i) {
    LitPictures gouraud(drawable, kFinerAndFiner[i], PixelFormat::kRgb);
    for (int seed = 0; seed < 8; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      const Viewpoint view = make_lit_view(*drawable.level, PixelFormat::kRgb, random);
      const render::Scene scene = view.scene(*drawable.level);
      differences[i] += mean_difference(engine.draw(scene, {}), gouraud.draw(scene, {})) / 8;
    }
  }
  EXPECT_GT(differences[0], 1.5 * differences[1]);
  EXPECT_GT(differences[1], 3 * differences[2]);
  EXPECT_LT(differences[2], 1.5);
}

TEST(Gouraud, IsTheSameForAnyThreadsAndBands) {
  for (const char* const technique : kGouraud) expect_same_for_any_threads(technique);
}

TEST(Gouraud, AllocatesNothingInAWarmFrame) {
  for (const char* const technique : kGouraud) expect_no_allocations_in_a_warm_frame(technique);
}

}  // namespace
}  // namespace temblor::test
