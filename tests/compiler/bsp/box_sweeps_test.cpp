// Boxes that move through compiled maps, compared with the same boxes and the brushes themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "compiler/bsp/brush_boxes.h"
#include "compiler/compiled_maps.h"
#include "compiler/drafts.h"
#include "compiler/vis/sight_lines.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"
#include "world/trace.h"

namespace temblor::test {
namespace {

using math::Vec3;
using math::Vec3d;

struct HullAndBox {
  world::Hull hull;
  HullBox box;
};
constexpr std::array<HullAndBox, 3> kHulls = {{{world::Hull::kPoint, {{0, 0, 0}, {0, 0, 0}}},
                                               {world::Hull::kPlayer, {{-16, -16, -24}, {16, 16, 32}}},
                                               {world::Hull::kLarge, {{-32, -32, -24}, {32, 32, 64}}}}};

// A trace stops this far before what it meets (world/trace.h).
constexpr double kGap = 1.0 / 32;
// The tolerance of compiled hulls: slivers of brushes this thin are not worth a node.
constexpr double kEpsilon = 0.1;  // units

// All solids at once, except those far from the box's path.
class Brushes {
 public:
  explicit Brushes(const formats::Map& map) : solids_(solids_of_world(map)) {}

  const Solid& any(Random& io_random) const { return solids_[io_random.below(solids_.size())]; }

  double time_of_contact(const HullAndBox& hull, const Vec3d& start, const Vec3d& end, double gap) const {
    const Vec3d mins = glm::min(start, end) + hull.box.mins - 1.0,
                maxs = glm::max(start, end) + hull.box.maxs + 1.0;
    double first = 2;
    for (const Solid& solid : solids_) {
      if (glm::any(glm::lessThan(maxs, solid.mins)) || glm::any(glm::greaterThan(mins, solid.maxs))) continue;
      if (hull.hull == world::Hull::kPoint && !solid.stops_points) continue;
      first = std::min(first, test::time_of_contact(solid, hull.box, start, end, gap));
    }
    return first;
  }

 private:
  std::vector<Solid> solids_;
};

Vec3 random_start(const Solid& near, const HullBox& box, Random& io_random) {
  constexpr double kAway = 48;
  Vec3d at;
  for (int axis = 0; axis < 3; ++axis)
    at[axis] =
        io_random.uniform(near.mins[axis] - box.maxs[axis] - kAway, near.maxs[axis] - box.mins[axis] + kAway);
  return Vec3(at);
}

class BoxSweeps : public ::testing::TestWithParam<const char*> {};

TEST_P(BoxSweeps, EndAtTheBrushes) {
  DATA_FOLDER_OR_SKIP(data);
  const formats::Map map = read_stock_map(data, GetParam());
  const auto level = make_level_of_brushes(map);

  const Brushes brushes(map);
  Random random(17);
  const int sweeps = effort(20000, 200);
  int too_far = 0, too_short = 0, stopped = 0;
  for (int done = 0; done < sweeps;) {
    const HullAndBox& hull = kHulls[random.below(kHulls.size())];
    const Vec3 start = random_start(brushes.any(random), hull.box, random);
    const Vec3 end = start + random.in_cube(random.log_uniform(1, 512));
    if (brushes.time_of_contact(hull, start, start, kEpsilon) <= 1) continue;  // begins in or at a brush
    ++done;
    const world::Trace trace = world::trace_line(*level, world::ModelIndex{0}, hull.hull, start, end);
    const double near = brushes.time_of_contact(hull, start, end, kGap + kEpsilon),
                 deep = brushes.time_of_contact(hull, start, end, -kEpsilon);
    constexpr double kRounding = 1e-4;
    stopped += trace.fraction < 1 ? 1 : 0;
    const bool is_far = double{trace.fraction} > deep + kRounding,
               is_short = trace.fraction < 1 && double{trace.fraction} < near - kRounding;
    too_far += is_far ? 1 : 0;
    too_short += is_short ? 1 : 0;
    if ((is_far || is_short) && too_far + too_short < 5)
      ADD_FAILURE() << fmt::format("hull {}, from {} {} {} to {} {} {}: {}, brushes say {} to {}",
                                   static_cast<int>(hull.hull), start.x, start.y, start.z, end.x, end.y,
                                   end.z, trace.fraction, near, deep);
  }
  EXPECT_EQ(too_far, 0);
  EXPECT_EQ(too_short, 0);
  EXPECT_GT(stopped, sweeps / 10);
  EXPECT_LT(stopped, sweeps * 9 / 10);
}

// A path from info_player_start through courtyard, halls and shafts to the far end of the level. In the
// finished level, a player's box moves freely from each point to the next.
constexpr std::array<Vec3, 21> kPathThroughE0m1 = {{
    {512, 2048, 304},  {1184, 1984, 16},  {1184, 1632, 16},  {640, 1312, 16},   {640, 1216, 48},
    {640, 1152, 48},   {608, 672, 48},    {-32, 480, 48},    {-32, 160, 48},    {-352, -32, 16},
    {-544, -32, -48},  {-544, -704, -80}, {480, -960, -144}, {640, -512, -208}, {640, -448, -208},
    {480, -256, -208}, {480, -192, -176}, {480, 0, -176},    {672, 160, -176},  {704, 352, -208},
    {704, 352, -144},
}};

TEST(FastCompile, LetsPlayersThroughLikeTheFinishedLevel) {
  DATA_FOLDER_OR_SKIP(data);
  compiler::CompileOptions options;
  options.fast_visibility = options.light.fast = true;
  const auto ours =
      world::make_level(compile_stock_map(data, "lq_e0m1", options).level.bsp, "compiled").value();
  const auto theirs = world::make_level(compiler::finished_level(data, "lq_e0m1"), "finished").value();
  const auto trace = [](const world::Level& level, const Vec3& from, const Vec3& to) {
    return world::trace_line(level, world::ModelIndex{0}, world::Hull::kPlayer, from, to);
  };
  int blocked = 0;
  for (std::size_t i = 0; i < kPathThroughE0m1.size(); ++i)
    for (std::size_t k = 0; k < kPathThroughE0m1.size(); ++k) {
      const Vec3 &from = kPathThroughE0m1[i], &to = kPathThroughE0m1[k];
      const world::Trace got = trace(*ours, from, to), expected = trace(*theirs, from, to);
      EXPECT_FALSE(got.start_solid) << i;
      if (k == i + 1) {
        EXPECT_EQ(got.fraction, 1) << "the path's piece " << i;
      }
      EXPECT_EQ(got.fraction < 1, expected.fraction < 1) << i << " to " << k;
      EXPECT_LT(glm::length(got.end - expected.end), 0.25F) << i << " to " << k;
      blocked += expected.fraction < 1 ? 1 : 0;
    }
  EXPECT_GT(blocked, 100) << "what is not the path leads through walls";
}

INSTANTIATE_TEST_SUITE_P(Stock, BoxSweeps, ::testing::ValuesIn(stock_maps_for_hulls()),
                         [](const auto& map) { return std::string(map.param); });

}  // namespace
}  // namespace temblor::test
