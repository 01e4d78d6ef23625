// Random maps, checked by rays and boxes against their brushes: they are sealed, each hull agrees with the
// brushes, no line of sight is lost, and any number of threads gives the same level.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "compiler/drafts.h"
#include "compiler/random/level_checks.h"
#include "compiler/random/random_map.h"
#include "compiler/vis/sight_lines.h"
#include "support/effort.h"
#include "support/random.h"
#include "world/level.h"

namespace temblor::test {
namespace {

using compiler::BitMatrix;
using math::Vec3d;

class RandomMapChecker {
 public:
  explicit RandomMapChecker(std::uint64_t seed)
      : random_(seed + 1'000'000),
        map_(make_random_map(seed)),
        result_(compile_map(map_.map, 1)),
        solids_(solids_of_world(map_.map)),
        level_(world::make_level(result_.draft.bsp, "random").value()) {}

  void run() {
    ASSERT_FALSE(result_.leak) << "sealed maps must not leak";
    ASSERT_EQ(find_level_fault(result_), "");
    visible_ = find_visibility(result_.draft.portals, 1);
    check_points();
    check_sight();
  }
  void check_threads() {
    const compiler::DraftResult again = compile_map(map_.map, 3);
    EXPECT_TRUE(formats::write_bsp(again.draft.bsp, formats::BspVersion::k29).value() ==
                formats::write_bsp(result_.draft.bsp, formats::BspVersion::k29).value());
    EXPECT_TRUE(find_visibility(again.draft.portals, 3) == visible_);
  }
  const std::string& text() const { return map_.text; }
  int lines_of_sight() const { return lines_of_sight_; }

 private:
  Vec3d random_place() {
    const math::Vec3 mins = result_.draft.bsp.models[0].mins, maxs = result_.draft.bsp.models[0].maxs;
    Vec3d place;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] = random_.uniform(double{mins[axis]} - 16, double{maxs[axis]} + 16);
    return Vec3d(math::Vec3(place));
  }

  // Outside and in brushes, everything is solid or sky; in rooms, everything else is not.
  void check_points() {
    for (int i = 0; i < 150; ++i) {
      const Vec3d at = random_place();
      const auto& [hull, box] = kHullBoxes[random_.below(kHullBoxes.size())];
      const double in_room = depth_in_rooms(map_, at), in_brush = depth_in_any(solids_, box, at);
      const bool is_unsure = std::abs(in_brush) < kUnsure || std::abs(in_room) < kUnsure;
      // Behind a door, a point is in no room; its sill and lintel are brushes.
      const bool is_free = in_room > kUnsure && in_brush < -kUnsure;
      const bool is_filled = in_brush > kUnsure || in_room < -17;
      if (is_unsure || (!is_free && !is_filled)) continue;
      EXPECT_EQ(is_solid(*level_, hull, at), is_filled)
          << "hull " << static_cast<int>(hull) << " at " << at.x << ' ' << at.y << ' ' << at.z
          << ", depth in brushes " << in_brush << ", in rooms " << in_room;
    }
  }

  void check_sight() {
    const formats::Bsp& bsp = result_.draft.bsp;
    const HullBox& point = kHullBoxes.front().second;
    std::vector<Vec3d> places;
    for (int i = 0; i < 4000 && places.size() < 24; ++i) {
      const Vec3d at = random_place();
      if (depth_in_rooms(map_, at) > kUnsure && depth_in_any(solids_, point, at) < -kUnsure)
        places.push_back(at);
    }
    ASSERT_EQ(places.size(), 24u);
    const auto cluster_at = [&](const Vec3d& at) {
      return result_.draft.portals.cluster_of_leaf[compiler::leaf_at(bsp, at)];
    };
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const bool is_blocked = std::ranges::any_of(solids_, [&](const Solid& solid) {
          return time_of_contact(solid, point, places[i], places[k], kUnsure) <= 1;
        });
        if (is_blocked) continue;
        ++lines_of_sight_;
        EXPECT_TRUE(visible_.at(cluster_at(places[i]), cluster_at(places[k])))
            << places[i].x << ' ' << places[i].y << ' ' << places[i].z << " does not see " << places[k].x
            << ' ' << places[k].y << ' ' << places[k].z;
      }
  }

  Random random_;
  RandomMap map_;
  compiler::DraftResult result_;
  std::vector<Solid> solids_;
  std::shared_ptr<const world::Level> level_;
  BitMatrix visible_;
  int lines_of_sight_ = 0;
};

void check_maps(std::uint64_t first, std::uint64_t end) {
  int lines_of_sight = 0;
  for (std::uint64_t seed = first; seed < end; ++seed) {
    RandomMapChecker checker(seed);
    checker.run();
    if (seed % 10 == 0) checker.check_threads();
    lines_of_sight += checker.lines_of_sight();
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed << ":\n" << checker.text();
  }
  EXPECT_GT(lines_of_sight, static_cast<int>(end - first) * 20);
}

TEST(RandomMaps, FewKeepTheirPromises) {
  check_maps(0, effort(20, 3));
}

// In seeds 455 and 960, clip hulls have several wedges one behind the other, through which the outside must
// not come in.
TEST(ManyRandomMaps, KeepTheirPromises) {
  check_maps(20, effort(1000, 30));
}

// Walls that are tilted by less than 0.25 degrees. In 2451 and 2917, the outside comes into a gap along such
// a wall, and the wall must still end at that gap. In 4300, a piece of a wall is thinner than 0.01 units.
TEST(ManyRandomMaps, KeepTiltedWallsInPlace) {
  for (const std::uint64_t seed : {986, 1211, 1216, 1355, 2451, 2917, 4300}) check_maps(seed, seed + 1);
}

// Wedges along tilted walls are narrow in a room and wide outside of it, or the other way around (37654).
TEST(ManyRandomMaps, KeepWedgesSealed) {
  for (const std::uint64_t seed : {4346, 16617, 18254, 36722, 37654, 57607}) check_maps(seed, seed + 1);
}

// The tops of two blocks are 0.05 units apart, and a leaf as thin reaches through the room and a pillar.
TEST(ManyRandomMaps, HaveNoThinSheets) {
  check_maps(59102, 59103);
}

// In 33436, two tree planes run 0.08 units apart through a floor, and the part of it between them must not
// get lost. In 35440, a thin leaf inside a pillar has a side 0.002 units away from another one.
TEST(ManyRandomMaps, HaveNoCracks) {
  for (const std::uint64_t seed : {33436, 35440}) check_maps(seed, seed + 1);
}

}  // namespace
}  // namespace temblor::test
