// Brushes with sides that are nearly in one plane: their faces have no gaps.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "compiler/bsp/make_draft.h"
#include "support/effort.h"
#include "support/levels/bsp_faces.h"
#include "support/levels/room_map.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3d;

constexpr double kHalfPedestal = 48;  // half of the pedestal's width and depth

std::string bend_side_text(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return fmt::format("( {} {} {} ) ( {} {} {} ) ( {} {} {} ) stone 0 0 0 1 1\n", a.x, a.y, a.z, b.x, b.y, b.z,
                     c.x, c.y, c.z);
}

// A pedestal in the middle of a room. Two planes on its top meet above a line through a random point, and
// bend by only this little over half of the pedestal's width.
std::string pedestal_text(double bend, Random& io_random) {
  const double turn = io_random.uniform(0, 2 * M_PI), tilt = io_random.uniform(-0.5, 0.5);
  const Vec3d along(std::cos(turn), std::sin(turn), 0), across(-along.y, along.x, 0);
  const Vec3d ridge(io_random.uniform(-30, 30), io_random.uniform(-30, 30), io_random.uniform(0, 20));
  const auto top = [&](double slope) {
    const Vec3d down(0, 0, slope * 16);
    return bend_side_text(ridge, ridge + across * 16.0 + down, ridge + along * 16.0);
  };
  std::string text =
      box_text({-kHalfPedestal, -kHalfPedestal, -256}, {kHalfPedestal, kHalfPedestal, 128}, "stone");
  text.resize(text.find('}'));
  return text + top(tilt) + top(tilt - bend / kHalfPedestal) + "}\n";
}

// The area of the pedestal that the world's faces cover, seen from above.
double area_from_above(const formats::Bsp& bsp) {
  double sum = 0;
  for (const formats::BspFace& face : bsp.faces) {
    const std::vector<math::Vec3> corners = list_vertices(bsp, face);
    if (corners[0].z < -200 || corners[0].z > 200) continue;  // floor and ceiling
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3d a(corners[i]), b(corners[(i + 1) % corners.size()]);
      twice += b.x * a.y - a.x * b.y;
    }
    sum += std::max(twice / 2, 0.0);
  }
  return sum;
}

TEST(FlatBends, LeaveNoGaps) {
  for (int seed = 0; seed < effort(300, 20); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const double bend = random.log_uniform(0.002, 1);
    const std::string text =
        entity_text("worldspawn", "",
                    walls_text(Vec3d(-256), Vec3d(256), "wall") + pedestal_text(bend, random)) +
        point_text("info_player_start", {-200, -200, 0});
    base::Jobs jobs(1);
    compiler::Warnings warnings;
    const auto made = compiler::make_draft(
        parse_map(text), [](std::string_view) { return math::Vec2d(64, 64); }, {}, jobs, warnings);
    ASSERT_TRUE(made.ok());
    EXPECT_NEAR(area_from_above(made.value().draft.bsp), 4 * kHalfPedestal * kHalfPedestal, 2)
        << "seed " << seed << ", bend " << bend;
  }
}

// The ceiling of a cave: prisms side by side, whose lower ends have these heights at their corners. Some of
// their planes cross at a thousandth of a degree.
constexpr int kColumns = 5, kRows = 8, kTop = 208;
constexpr std::array<std::array<int, kColumns + 1>, kRows + 1> kRock = {{{173, 173, 173, 175, 182, 185},
                                                                         {178, 178, 176, 177, 183, 181},
                                                                         {183, 181, 179, 179, 177, 183},
                                                                         {176, 180, 182, 182, 180, 184},
                                                                         {173, 175, 178, 177, 176, 182},
                                                                         {178, 176, 173, 177, 181, 184},
                                                                         {177, 182, 182, 183, 184, 184},
                                                                         {178, 191, 193, 193, 192, 186},
                                                                         {179, 186, 188, 186, 187, 187}}};
constexpr Vec3d kRoomLow(304, -560, 0), kRoomHigh(592, -80, kTop);

Vec3d corner_of_rock(std::size_t column, std::size_t row) {
  return {std::floor(kRoomLow.x + 57.6 * static_cast<double>(column)),
          kRoomLow.y + 60.0 * static_cast<double>(row), kRock[row][column]};
}

std::string prism_text(const std::array<Vec3d, 3>& lower) {
  const auto above = [](Vec3d point) { return Vec3d(point.x, point.y, kTop); };
  std::string text = "{\n" + bend_side_text(lower[0], lower[1], lower[2]);
  text += bend_side_text(above(lower[0]), above(lower[2]), above(lower[1]));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d &a = lower[i], &b = lower[(i + 1) % 3];
    text += bend_side_text(a, above(a), b);
  }
  return text + "}\n";
}

std::string rock_text() {
  std::string text;
  for (std::size_t row = 0; row < kRows; ++row)
    for (std::size_t column = 0; column < kColumns; ++column) {
      const std::array<Vec3d, 4> ring = {corner_of_rock(column, row), corner_of_rock(column + 1, row),
                                         corner_of_rock(column + 1, row + 1),
                                         corner_of_rock(column, row + 1)};
      const std::size_t from = (row + column) % 2;
      for (const std::size_t k : {from, from + 2})
        text += prism_text({ring[k % 4], ring[(k + 1) % 4], ring[(k + 2) % 4]});
    }
  return text;
}

// The area of the rock that the world's faces cover, seen from below.
double area_from_below(const formats::Bsp& bsp) {
  double sum = 0;
  for (const formats::BspFace& face : bsp.faces) {
    const std::vector<math::Vec3> corners = list_vertices(bsp, face);
    if (corners[0].z < 100) continue;  // floor and walls
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3d a(corners[i]), b(corners[(i + 1) % corners.size()]);
      twice += b.y * a.x - a.y * b.x;
    }
    sum += std::abs(twice) / 2;
  }
  return sum;
}

TEST(FlatBends, LeaveNoHolesInACavesCeiling) {
  const std::string text = entity_text("worldspawn", "", walls_text(kRoomLow, kRoomHigh, "wall")) +
                           entity_text("func_detail", "", rock_text()) +
                           point_text("info_player_start", {448, -400, 60});
  base::Jobs jobs(1);
  compiler::Warnings warnings;
  const auto made = compiler::make_draft(
      parse_map(text), [](std::string_view) { return math::Vec2d(64, 64); }, {}, jobs, warnings);
  ASSERT_TRUE(made.ok());
  const Vec3d size = kRoomHigh - kRoomLow;
  // Slivers where planes cross may be missing.
  EXPECT_NEAR(area_from_below(made.value().draft.bsp) / (size.x * size.y), 1, 0.002);
}

}  // namespace
}  // namespace temblor::test
