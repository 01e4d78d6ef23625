// Boxes against the clip hulls of compiled maps, compared with boxes against the brushes themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/text.h"
#include "compiler/bsp/brush_boxes.h"
#include "compiler/compiled_maps.h"
#include "compiler/drafts.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"
#include "support/random.h"
#include "world/trace.h"

namespace temblor::test {
namespace {

using math::Vec3d;

using HullTable = std::vector<std::pair<world::Hull, HullBox>>;
const HullTable kHullBoxes = {{world::Hull::kPlayer, {{-16, -16, -24}, {16, 16, 32}}},
                              {world::Hull::kLarge, {{-32, -32, -24}, {32, 32, 64}}}};
const HullTable kHullsOfHalfLife = {{world::Hull::kPlayer, {{-16, -16, -36}, {16, 16, 36}}},
                                    {world::Hull::kLarge, {{-32, -32, -32}, {32, 32, 32}}},
                                    {world::Hull::kLow, {{-16, -16, -18}, {16, 16, 18}}}};

// Compares at random points near the map's brushes. Points deeper inside or farther away than this must
// agree; nearer, rounding decides.
constexpr double kUnsure = 0.1;  // units

void expect_hulls_agree(const formats::Map& map, int points, Random& io_random,
                        const HullTable& hulls = kHullBoxes) {
  const auto level = make_level_of_brushes(map, {.half_life = &hulls == &kHullsOfHalfLife});
  const std::vector<Solid> solids = solids_of_world(map);
  int wrong = 0, solid_points = 0, sure = 0;
  for (int i = 0; i < points; ++i) {
    const Solid& near = solids[io_random.below(solids.size())];
    const auto& [hull, box] = hulls[io_random.below(hulls.size())];
    Vec3d at;
    for (int axis = 0; axis < 3; ++axis)
      at[axis] =
          io_random.uniform(near.mins[axis] - box.maxs[axis] - 8, near.maxs[axis] - box.mins[axis] + 8);
    at = Vec3d(math::Vec3(at));
    double deepest = -1e9;
    for (const Solid& solid : solids) {
      if (glm::any(glm::lessThan(at + box.maxs, solid.mins - 1.0)) ||
          glm::any(glm::greaterThan(at + box.mins, solid.maxs + 1.0)))
        continue;
      deepest = std::max(deepest, depth_in(solid, box, at));
    }
    if (std::abs(deepest) < kUnsure) continue;
    ++sure;
    const bool is_solid =
        world::hull_contents(*level, world::ModelIndex{0}, hull, math::Vec3(at)) == world::Contents::kSolid;
    solid_points += is_solid ? 1 : 0;
    if (is_solid == (deepest > 0)) continue;
    if (++wrong < 5) ADD_FAILURE() << "at " << at.x << ' ' << at.y << ' ' << at.z << ", depth " << deepest;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(sure, points * 9 / 10);
  EXPECT_GT(solid_points, points / 10);
  EXPECT_LT(solid_points, points * 99 / 100);
}

class ClipHulls : public ::testing::TestWithParam<const char*> {};

TEST_P(ClipHulls, AgreeWithTheBrushes) {
  DATA_FOLDER_OR_SKIP(data);
  const base::ByteVector text = read_file(data / "mapsrc" / (std::string(GetParam()) + ".map"));
  Random random(11);
  const formats::Map map = formats::read_map(base::as_text(text)).value();
  expect_hulls_agree(map, effort(100000, 500), random);
  expect_hulls_agree(map, effort(100000, 500), random, kHullsOfHalfLife);
}

INSTANTIATE_TEST_SUITE_P(Stock, ClipHulls, ::testing::ValuesIn(stock_maps_for_hulls()),
                         [](const auto& map) { return std::string(map.param); });

// A tetrahedron has edges in directions that no box has.
TEST(ClipHulls, AgreeForSlantedBrushes) {
  Random random(5);
  for (int i = 0; i < effort(30, 5); ++i) {
    std::string text = "{\n";
    std::array<Vec3d, 4> p;
    for (Vec3d& point : p) point = glm::round(Vec3d(random.in_cube(100)));
    if (glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) < 0) std::swap(p[0], p[1]);
    if (std::abs(glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0])) < 1e5) continue;
    const auto side = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
      text += fmt::format("( {} {} {} ) ( {} {} {} ) ( {} {} {} ) stone 0 0 0 1 1\n", a.x, a.y, a.z, b.x, b.y,
                          b.z, c.x, c.y, c.z);
    };
    // Outward is away from the fourth corner.
    side(p[0], p[1], p[2]);
    side(p[0], p[3], p[1]);
    side(p[1], p[3], p[2]);
    side(p[0], p[2], p[3]);
    SCOPED_TRACE(text);
    expect_hulls_agree(parse_map(entity_text("worldspawn", "", text + "}\n")), effort(2000, 200), random);
    expect_hulls_agree(parse_map(entity_text("worldspawn", "", text + "}\n")), effort(2000, 200), random,
                       kHullsOfHalfLife);
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace temblor::test
