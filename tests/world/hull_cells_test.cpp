// Compares traces through cells with traces through the whole tree. They must be equal bit for bit.
#include "world/hull_cells.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"
#include "world/test_levels.h"

namespace temblor::world {
namespace {

struct PathCounts {
  int paths = 0, stopped = 0, free = 0, started_solid = 0;
};

void expect_equal(const Trace& actual, const Trace& expected) {
  EXPECT_EQ(actual.all_solid, expected.all_solid);
  EXPECT_EQ(actual.start_solid, expected.start_solid);
  EXPECT_EQ(actual.in_open, expected.in_open);
  EXPECT_EQ(actual.in_water, expected.in_water);
  EXPECT_EQ(actual.fraction, expected.fraction);
  EXPECT_EQ(actual.end, expected.end);
  EXPECT_EQ(actual.plane_normal, expected.plane_normal);
  EXPECT_EQ(actual.plane_distance, expected.plane_distance);
}

math::Vec3 pick_point(const math::Bounds& bounds, test::Random& random) {
  math::Vec3 point;
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(random.uniform(bounds.mins[axis], bounds.maxs[axis]));
  return random.chance(0.5) ? point : glm::round(point);  // planes are often at whole numbers
}

// Follows paths through one hull. Each begins where the last one ended, or anywhere; most are short.
void compare_paths(const TestLevel& test, ModelIndex model, Hull hull, int paths, test::Random& random,
                   PathCounts& io_counts) {
  const Level& level = *test.level;
  HullCells cells(level, model, hull);
  const Model& traced = level.models[base::to_size(model)];
  const math::Bounds bounds{traced.bounds.mins - 48.0f, traced.bounds.maxs + 48.0f};
  math::Vec3 start = pick_point(bounds, random);
  for (int i = 0; i < paths; ++i) {
    math::Vec3 end = random.chance(0.1) ? pick_point(bounds, random) : start + random.in_cube(20);
    // Paths along an axis lie in planes of the tree.
    if (random.chance(0.3)) end[static_cast<int>(random.below(3))] = start[static_cast<int>(random.below(3))];
    SCOPED_TRACE(test.name + " path " + std::to_string(i));
    const Trace expected = trace_line(level, model, hull, start, end);
    expect_equal(cells.trace_line(start, end), expected);
    EXPECT_EQ(cells.contents(start), hull_contents(level, model, hull, start));
    EXPECT_EQ(cells.contents(expected.end), hull_contents(level, model, hull, expected.end));
    ++io_counts.paths;
    ++(expected.start_solid    ? io_counts.started_solid
       : expected.fraction < 1 ? io_counts.stopped
                               : io_counts.free);
    start = expected.start_solid || random.chance(0.05) ? pick_point(bounds, random) : expected.end;
  }
}

void expect_all_kinds(const PathCounts& counts) {
  EXPECT_GT(counts.stopped, counts.paths / 50);
  EXPECT_GT(counts.free, counts.paths / 50);
  EXPECT_GT(counts.started_solid, counts.paths / 50);
}

constexpr Hull kHulls[] = {Hull::kPoint, Hull::kPlayer, Hull::kLarge};

TEST(HullCells, OfTheSmallLevelTraceLikeTheWholeTree) {
  const TestLevel test = small_test_level();
  test::Random random(31);
  PathCounts counts;
  for (const Hull hull : kHulls)
    for (std::size_t model = 0; model < test.level->models.size(); ++model)
      compare_paths(test, base::to_index<ModelIndex>(model), hull, test::effort(5000, 500), random, counts);
  expect_all_kinds(counts);
}

TEST(HullCells, OfStockLevelsTraceLikeTheWholeTree) {
  DATA_FOLDER_OR_SKIP(base_folder);
  test::Random random(32);
  PathCounts counts;
  for (const TestLevel& test : stock_levels(base_folder))
    for (const Hull hull : kHulls)
      compare_paths(test, ModelIndex{0}, hull, test::effort(1000, 200), random, counts);
  expect_all_kinds(counts);
}

TEST(HullCells, TraceOutsideOfAllCells) {
  const TestLevel test = small_test_level();
  HullCells cells(*test.level, ModelIndex{0}, Hull::kPlayer);
  constexpr float kFar = 1e7f, kInfinity = std::numeric_limits<float>::infinity();
  const auto compare = [&](const math::Vec3& start, const math::Vec3& end) {
    expect_equal(cells.trace_line(start, end),
                 trace_line(*test.level, ModelIndex{0}, Hull::kPlayer, start, end));
  };
  compare({kFar, kFar, kFar}, {kFar, kFar, kFar - 8});
  compare({256, 256, 30}, {kFar, 256, 30});
  compare({-kFar, 256, 30}, {kFar, 256, 30});
  const math::Vec3 nowhere(std::numeric_limits<float>::quiet_NaN(), 256, 30);
  for (const math::Vec3& point : {nowhere, math::Vec3(kInfinity, 256, 30), math::Vec3(256, -kInfinity, 30)})
    EXPECT_EQ(cells.contents(point), hull_contents(*test.level, ModelIndex{0}, Hull::kPlayer, point));
}

}  // namespace
}  // namespace temblor::world
