// Brushes with sides that are nearly in one plane: what is drawn of them has no gaps.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "compiler/make_draft.h"
#include "support/bsp_faces.h"
#include "support/effort.h"
#include "support/random.h"
#include "support/room_map.h"

namespace temblor::test {
namespace {

using math::Vec3d;

constexpr double kHalf = 48;  // of the pedestal's width and depth

std::string side_text(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return fmt::format("( {} {} {} ) ( {} {} {} ) ( {} {} {} ) stone 0 0 0 1 1\n", a.x, a.y, a.z, b.x, b.y, b.z,
                     c.x, c.y, c.z);
}

// A pedestal in the middle of a room, from its floor up to two planes that meet above a line through a random
// place and bend by so little over half of its width.
std::string pedestal_text(double bend, Random& io_random) {
  const double turn = io_random.uniform(0, 2 * M_PI), tilt = io_random.uniform(-0.5, 0.5);
  const Vec3d along(std::cos(turn), std::sin(turn), 0), across(-along.y, along.x, 0);
  const Vec3d ridge(io_random.uniform(-30, 30), io_random.uniform(-30, 30), io_random.uniform(0, 20));
  const auto top = [&](double slope) {
    const Vec3d down(0, 0, slope * 16);
    return side_text(ridge, ridge + across * 16.0 + down, ridge + along * 16.0);
  };
  std::string text = box_text({-kHalf, -kHalf, -256}, {kHalf, kHalf, 128}, "stone");
  text.resize(text.find('}'));
  return text + top(tilt) + top(tilt - bend / kHalf) + "}\n";
}

// The area that the world's faces cover of the pedestal, seen from above.
double area_from_above(const formats::Bsp& bsp) {
  double sum = 0;
  for (const formats::BspFace& face : bsp.faces) {
    const std::vector<math::Vec3> corners = vertices_of(bsp, face);
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
        map_of(text), [](std::string_view) { return math::Vec2d(64, 64); }, {}, jobs, warnings);
    ASSERT_TRUE(made.ok());
    EXPECT_NEAR(area_from_above(made.value().draft.bsp), 4 * kHalf * kHalf, 2)
        << "seed " << seed << ", bend " << bend;
  }
}

}  // namespace
}  // namespace temblor::test
