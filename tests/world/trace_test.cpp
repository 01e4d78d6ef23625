// Compares traces with dense samples along their paths. The level's plan, or a plain walk of the file's clip
// trees, decides whether a sample is solid.
#include "world/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/level_script_contents.h"
#include "support/random.h"
#include "world/naive_tree.h"
#include "world/test_levels.h"

namespace temblor::world {
namespace {

using IsSolid = std::function<bool(const math::Vec3&)>;

constexpr float kGap = 1.0f / 32;
constexpr float kSampleUnits = 0.25f;

// The center, and 26 points of a sphere around it.
std::vector<math::Vec3> make_offsets(float radius) {
  std::vector<math::Vec3> offsets;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const math::Vec3 direction(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        offsets.push_back(direction * (radius / std::max(1.0f, glm::length(direction))));
      }
  return offsets;
}

// The surroundings of a point: whether everything, or nothing, close to it is solid. "Close" is a little more
// than the gap that traces keep.
struct Surroundings {
  bool all_solid = true, none_solid = true;
};
Surroundings surroundings(const IsSolid& is_solid, const math::Vec3& point) {
  static const std::vector<math::Vec3> offsets = make_offsets(0.1f);
  Surroundings result;
  for (const math::Vec3& offset : offsets) {
    const bool solid = is_solid(point + offset);
    result.all_solid = result.all_solid && solid;
    result.none_solid = result.none_solid && !solid;
    if (!result.all_solid && !result.none_solid) break;
  }
  return result;
}

struct TraceCounts {
  int stopped = 0, free = 0, started_solid = 0;
  int stepped_back = 0;  // ended earlier than the samples require
  int short_gaps = 0;    // ended closer to the obstacle than the gap
};

// Checks what the samples prove: the trace passed no point deep in solid, and did not stop before the first
// point that is close to solid.
void expect_path_as_sampled(const Trace& trace, const IsSolid& is_solid, const math::Vec3& start,
                            const math::Vec3& end, TraceCounts& io_counts) {
  const float length = glm::distance(start, end);
  const int steps = static_cast<int>(length / kSampleUnits) + 1;
  const auto at = [&](int step) {
    return start + (end - start) * (static_cast<float>(step) / static_cast<float>(steps));
  };
  const float slack = 2.0f / static_cast<float>(steps);
  const Surroundings first = surroundings(is_solid, start);
  if (first.all_solid) {
    EXPECT_TRUE(trace.start_solid);
    ++io_counts.started_solid;
    return;
  }
  if (!first.none_solid) return;
  EXPECT_FALSE(trace.start_solid);
  EXPECT_FALSE(trace.all_solid);
  EXPECT_FALSE(is_solid(trace.end));
  bool met_any = false;
  for (int step = 0; step <= steps; ++step) {
    const float fraction = static_cast<float>(step) / static_cast<float>(steps);
    const Surroundings here = surroundings(is_solid, at(step));
    if (!here.none_solid && !met_any) {
      met_any = true;
      if (trace.fraction < fraction - slack) ++io_counts.stepped_back;
    }
    if (here.all_solid) {
      EXPECT_LE(trace.fraction, fraction) << "passed through solid";
      ++io_counts.stopped;
      break;
    }
  }
  if (!met_any) {
    EXPECT_EQ(trace.fraction, 1);
    ++io_counts.free;
  }
}

// Checks what is true for every trace that was stopped: the end is on the path, the gap before the plane in
// the result.
void expect_stop_is_consistent(const Trace& trace, const math::Vec3& start, const math::Vec3& end,
                               TraceCounts& io_counts) {
  const math::Vec3 expected = start + (end - start) * trace.fraction;
  EXPECT_LT(glm::distance(trace.end, expected), 0.01f);
  if (trace.fraction == 1) {
    EXPECT_EQ(trace.end, end);
    return;
  }
  EXPECT_NEAR(glm::length(trace.plane_normal), 1, 0.01f);
  const float before = glm::dot(trace.plane_normal, trace.end) - trace.plane_distance;
  const float at_end = glm::dot(trace.plane_normal, end) - trace.plane_distance;
  const float at_start = glm::dot(trace.plane_normal, start) - trace.plane_distance;
  EXPECT_LT(at_end, 0.001f) << "did not have to cross the plane";
  EXPECT_GT(at_start, -0.001f) << "hit the plane from behind";
  EXPECT_GT(before, -0.002f);
  // A trace that starts closer than the gap cannot move.
  if (before < std::min(kGap, at_start) - 0.002f) ++io_counts.short_gaps;
}

math::Vec3 random_point(const math::Bounds& bounds, test::Random& random) {
  math::Vec3 point;
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(random.uniform(bounds.mins[axis], bounds.maxs[axis]));
  return point;
}

TraceCounts check_random_traces(const TestLevel& test, std::size_t model, Hull hull, const IsSolid& is_solid,
                                test::Random& random, int traces) {
  TraceCounts counts;
  const math::Bounds bounds{test.bsp.models[model].mins - 48.0f, test.bsp.models[model].maxs + 48.0f};
  for (int i = 0; i < traces; ++i) {
    const math::Vec3 start = random_point(bounds, random);
    math::Vec3 end = random.chance(0.3) ? start + random.in_cube(64) : random_point(bounds, random);
    // Paths along an axis lie in planes of the tree.
    if (random.chance(0.3)) end[static_cast<int>(random.below(3))] = start[static_cast<int>(random.below(3))];
    const Trace trace = trace_line(*test.level, base::to_index<ModelIndex>(model), hull, start, end);
    SCOPED_TRACE(test.name + " trace " + std::to_string(i));
    expect_stop_is_consistent(trace, start, end, counts);
    expect_path_as_sampled(trace, is_solid, start, end, counts);
  }
  // A cut before one plane may be within the gap of the next; only then is the distance smaller.
  EXPECT_LE(counts.short_gaps, 1 + traces / 500) << test.name;
  return counts;
}

constexpr math::Bounds kHullBoxes[] = {
    {{0, 0, 0}, {0, 0, 0}}, {{-16, -16, -24}, {16, 16, 32}}, {{-32, -32, -24}, {32, 32, 64}}};

TEST(TraceLine, ThroughTheSmallLevelStopsWhereItsPlanIsSolid) {
  const TestLevel test = small_test_level();
  const std::vector<artgen::SmallLevelBox> boxes = artgen::small_level_boxes();
  const IsSolid in_solid[] = {
      [&](const math::Vec3& p) { return test::find_contents(boxes, p) == test::kSolidContents; },
      [&](const math::Vec3& p) {
        return test::stops_box(boxes, {p + kHullBoxes[1].mins, p + kHullBoxes[1].maxs});
      },
      [&](const math::Vec3& p) {
        return test::stops_box(boxes, {p + kHullBoxes[2].mins, p + kHullBoxes[2].maxs});
      }};
  test::Random random(21);
  for (const Hull hull : {Hull::kPoint, Hull::kPlayer, Hull::kLarge}) {
    const IsSolid& is_solid = in_solid[static_cast<std::size_t>(hull)];
    const int traces = hull == Hull::kPoint ? test::effort(2000, 100) : test::effort(200, 60);
    const TraceCounts counts = check_random_traces(test, 0, hull, is_solid, random, traces);
    EXPECT_EQ(counts.stepped_back, 0);
    EXPECT_GT(counts.stopped, traces / 20);
    EXPECT_GT(counts.started_solid, traces / 20);
  }
}

TEST(TraceLine, AgainstADoorStopsAtItsBoxGrownByTheHulls) {
  const TestLevel test = small_test_level();
  const math::Bounds door = artgen::small_level_door();
  test::Random random(22);
  for (const Hull hull : {Hull::kPoint, Hull::kPlayer, Hull::kLarge}) {
    const math::Bounds& box = kHullBoxes[static_cast<std::size_t>(hull)];
    const IsSolid is_solid = [&](const math::Vec3& p) {
      for (int axis = 0; axis < 3; ++axis)
        if (p[axis] + box.maxs[axis] <= door.mins[axis] || p[axis] + box.mins[axis] >= door.maxs[axis])
          return false;
      return true;
    };
    const int traces = test::effort(2000, 200);
    const TraceCounts counts = check_random_traces(test, 1, hull, is_solid, random, traces);
    EXPECT_EQ(counts.stepped_back, 0);
    EXPECT_GT(counts.stopped, traces / 50);
    EXPECT_GT(counts.free, traces / 50);
  }
}

TEST(TraceLine, ThroughStockLevelsStopsWhereTheirTreesAreSolid) {
  DATA_FOLDER_OR_SKIP(base_folder);
  constexpr std::int32_t kSolid = -2;
  test::Random random(23);
  TraceCounts total;
  int traces = 0;
  for (const TestLevel& test : stock_levels(base_folder)) {
    for (const Hull hull : {Hull::kPoint, Hull::kPlayer, Hull::kLarge}) {
      for (const std::size_t model : {std::size_t{0}, test.bsp.models.size() - 1}) {
        const IsSolid is_solid = [&](const math::Vec3& p) {
          return naive_contents(test.bsp, model, static_cast<std::size_t>(hull), to_point(p)) == kSolid;
        };
        const int count = test::effort(40, 10);
        const TraceCounts counts = check_random_traces(test, model, hull, is_solid, random, count);
        traces += count;
        total.stopped += counts.stopped;
        total.free += counts.free;
        total.stepped_back += counts.stepped_back;
      }
    }
  }
  EXPECT_GT(total.stopped, traces / 20);
  EXPECT_GT(total.free, 0);
  // Between planes that meet at a sharp angle, a trace may step back, as in the original.
  EXPECT_LT(total.stepped_back, traces / 50);
}

TEST(TraceLine, SaysWhatItPassedThrough) {
  const TestLevel test = small_test_level();
  const auto trace = [&](const math::Vec3& start, const math::Vec3& end) {
    return trace_line(*test.level, ModelIndex{0}, Hull::kPoint, start, end);
  };
  const Trace in_air = trace({256, 256, 30}, {300, 256, 60});
  EXPECT_TRUE(in_air.in_open);
  EXPECT_FALSE(in_air.in_water);
  EXPECT_EQ(in_air.fraction, 1);

  const Trace into_pool = trace({1200, 200, 0}, {1200, 200, -500});
  EXPECT_TRUE(into_pool.in_open);
  EXPECT_TRUE(into_pool.in_water);
  EXPECT_EQ(into_pool.plane_normal, math::Vec3(0, 0, 1));
  EXPECT_FLOAT_EQ(into_pool.plane_distance, -256);
  EXPECT_FLOAT_EQ(into_pool.end.z, -256 + kGap);

  const Trace under_water = trace({1200, 200, -200}, {1210, 210, -190});
  EXPECT_FALSE(under_water.in_open);
  EXPECT_TRUE(under_water.in_water);

  // Sky is not solid for a point.
  const Trace to_the_sky = trace({1000, 300, 0}, {1000, 300, 1000});
  EXPECT_FLOAT_EQ(to_the_sky.plane_distance, -448);
  EXPECT_EQ(to_the_sky.plane_normal, math::Vec3(0, 0, -1));
}

TEST(TraceLine, FromSolidFollowsThePathOut) {
  const TestLevel test = small_test_level();
  const auto trace = [&](const math::Vec3& start, const math::Vec3& end) {
    return trace_line(*test.level, ModelIndex{0}, Hull::kPoint, start, end);
  };
  const Trace out_of_wall = trace({-8, 256, 64}, {256, 256, 64});
  EXPECT_TRUE(out_of_wall.start_solid);
  EXPECT_FALSE(out_of_wall.all_solid);
  EXPECT_EQ(out_of_wall.fraction, 1);

  const Trace back_into_solid = trace({112, 112, 64}, {112, 112, -64});
  EXPECT_TRUE(back_into_solid.all_solid);
  const Trace through_the_hall = trace({112, 112, 64}, {256, 112, -64});
  EXPECT_TRUE(through_the_hall.start_solid);
  EXPECT_FALSE(through_the_hall.all_solid);
  EXPECT_NEAR(through_the_hall.end.z, kGap, 0.001f);
}

TEST(TraceLine, OfNoLengthTellsOnlyWhereItIs) {
  const TestLevel test = small_test_level();
  const Trace in_air = trace_line(*test.level, ModelIndex{0}, Hull::kPoint, {256, 256, 64}, {256, 256, 64});
  EXPECT_FALSE(in_air.start_solid);
  EXPECT_EQ(in_air.fraction, 1);
  const Trace in_rock =
      trace_line(*test.level, ModelIndex{0}, Hull::kPoint, {-500, 256, 64}, {-500, 256, 64});
  EXPECT_TRUE(in_rock.start_solid);
  EXPECT_TRUE(in_rock.all_solid);
}

TEST(HullContents, AreThoseOfThePlan) {
  const TestLevel test = small_test_level();
  const std::vector<artgen::SmallLevelBox> boxes = artgen::small_level_boxes();
  const math::Bounds bounds{test.bsp.models[0].mins - 40.0f, test.bsp.models[0].maxs + 40.0f};
  test::Random random(24);
  for (int i = 0; i < test::effort(5000, 300); ++i) {
    const math::Vec3 point = random_point(bounds, random);
    EXPECT_EQ(static_cast<std::int32_t>(hull_contents(*test.level, ModelIndex{0}, Hull::kPoint, point)),
              test::find_contents(boxes, point));
    for (const Hull hull : {Hull::kPlayer, Hull::kLarge}) {
      const math::Bounds& box = kHullBoxes[static_cast<std::size_t>(hull)];
      const bool stops = test::stops_box(boxes, {point + box.mins, point + box.maxs});
      EXPECT_EQ(hull_contents(*test.level, ModelIndex{0}, hull, point),
                stops ? Contents::kSolid : Contents::kEmpty);
    }
  }
}

TEST(HullContents, OfStockLevelsAreWhatAPlainWalkFinds) {
  DATA_FOLDER_OR_SKIP(base_folder);
  test::Random random(25);
  for (const TestLevel& test : stock_levels(base_folder)) {
    for (std::size_t model = 0; model < test.bsp.models.size(); ++model) {
      const math::Bounds bounds{test.bsp.models[model].mins - 16.0f, test.bsp.models[model].maxs + 16.0f};
      for (const Hull hull : {Hull::kPoint, Hull::kPlayer, Hull::kLarge}) {
        for (int i = 0; i < 20; ++i) {
          const math::Vec3 point = random_point(bounds, random);
          EXPECT_EQ(static_cast<std::int32_t>(
                        hull_contents(*test.level, base::to_index<ModelIndex>(model), hull, point)),
                    naive_contents(test.bsp, model, static_cast<std::size_t>(hull), to_point(point)));
        }
      }
    }
  }
}

TEST(ChooseHull, GoesByWidthAndMakesTheLowerCornersMeet) {
  const Level level;
  const HullChoice point = choose_hull(level, {0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(point.hull, Hull::kPoint);
  EXPECT_EQ(point.offset, math::Vec3(0, 0, 0));
  const HullChoice player = choose_hull(level, {-16, -16, -24}, {16, 16, 32});
  EXPECT_EQ(player.hull, Hull::kPlayer);
  EXPECT_EQ(player.offset, math::Vec3(0, 0, 0));
  const HullChoice crate = choose_hull(level, {0, 0, 0}, {32, 32, 64});
  EXPECT_EQ(crate.hull, Hull::kPlayer);
  EXPECT_EQ(crate.offset, math::Vec3(16, 16, 24));
  const HullChoice monster = choose_hull(level, {-32, -32, -24}, {32, 32, 64});
  EXPECT_EQ(monster.hull, Hull::kLarge);
  EXPECT_EQ(monster.offset, math::Vec3(0, 0, 0));
  EXPECT_EQ(choose_hull(level, {-1, -50, -50}, {1, 50, 50}).hull, Hull::kPoint);
  EXPECT_EQ(choose_hull(level, {-1.5f, 0, 0}, {1.5f, 0, 0}).hull, Hull::kPlayer);
  EXPECT_EQ(choose_hull(level, {-16.5f, 0, 0}, {16.5f, 0, 0}).hull, Hull::kLarge);
}

// The boxes of Half-Life's hulls are centered, so that a box of Quake stands 12 or 8 units higher in them.
TEST(ChooseHull, PutsFeetOnTheFloorOfHalfLifesHulls) {
  Level level;
  level.is_half_life = true;
  level.hull_boxes = kHalfLifeHulls;
  const HullChoice player = choose_hull(level, {-16, -16, -24}, {16, 16, 32});
  EXPECT_EQ(player.hull, Hull::kPlayer);
  EXPECT_EQ(player.offset, math::Vec3(0, 0, 12));
  const HullChoice monster = choose_hull(level, {-32, -32, -24}, {32, 32, 64});
  EXPECT_EQ(monster.hull, Hull::kLarge);
  EXPECT_EQ(monster.offset, math::Vec3(0, 0, 8));
  const HullChoice low = choose_hull(level, {-16, -16, 0}, {16, 16, 36});
  EXPECT_EQ(low.hull, Hull::kLow);
  EXPECT_EQ(low.offset, math::Vec3(0, 0, 18));
  EXPECT_EQ(choose_hull(level, {-16, -16, 0}, {16, 16, 37}).hull, Hull::kPlayer);
  EXPECT_EQ(choose_hull(level, {-1, -1, 0}, {1, 1, 9}).hull, Hull::kPoint);
}

}  // namespace
}  // namespace temblor::world
