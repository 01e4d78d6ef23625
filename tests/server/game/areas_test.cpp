// Areas find the same entities as a plain list of boxes.
#include "server/game/areas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "support/effort.h"
#include "support/random.h"

namespace temblor::server {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;
using ::testing::UnorderedElementsAreArray;
using vm::EntityIndex;

constexpr math::Bounds kWorld{{-1000, -600, -200}, {1000, 600, 200}};

math::Bounds box_at(const math::Vec3& center, float half) {
  return {center - half, center + half};
}

std::vector<EntityIndex> found_in(const Areas& areas, const math::Bounds& box, AreaKind kind) {
  std::vector<EntityIndex> found;
  areas.find(box, kind, found);
  return found;
}

TEST(Areas, FindWhatAPlainListFinds) {
  struct Entry {
    math::Bounds box;
    AreaKind kind;
  };
  test::Random random(31);
  Areas areas(kWorld);
  std::map<std::uint32_t, Entry> list;
  std::size_t found_in_all = 0;
  for (int step = 0; step < test::effort(20000, 2000); ++step) {
    const auto number = static_cast<std::uint32_t>(random.below(300));
    if (random.chance(0.3)) {
      areas.unlink(EntityIndex{number});
      list.erase(number);
    } else {
      const math::Vec3 center = random.in_cube(1100);
      const Entry entry{box_at(center, static_cast<float>(random.log_uniform(1, 300))),
                        random.chance(0.5) ? AreaKind::kSolid : AreaKind::kTrigger};
      areas.link(EntityIndex{number}, entry.box, entry.kind);
      list[number] = entry;
    }
    const math::Bounds asked = box_at(random.in_cube(1000), static_cast<float>(random.log_uniform(1, 500)));
    for (const AreaKind kind : {AreaKind::kSolid, AreaKind::kTrigger}) {
      std::vector<EntityIndex> expected;
      for (const auto& [index, entry] : list)
        if (entry.kind == kind && glm::all(glm::lessThanEqual(entry.box.mins, asked.maxs)) &&
            glm::all(glm::greaterThanEqual(entry.box.maxs, asked.mins)))
          expected.push_back(EntityIndex{index});
      found_in_all += expected.size();
      ASSERT_THAT(found_in(areas, asked, kind), UnorderedElementsAreArray(expected));
    }
  }
  EXPECT_GT(found_in_all, 1000u);
}

TEST(Areas, FindLargePartsFirstAndKeepTheOrderOfLinking) {
  Areas areas(kWorld);
  // Small ones first: one in the upper half of x, one in the lower; then two across the middle.
  areas.link(EntityIndex{1}, box_at({700, 0, 0}, 2), AreaKind::kTrigger);
  areas.link(EntityIndex{2}, box_at({-700, 0, 0}, 2), AreaKind::kTrigger);
  areas.link(EntityIndex{3}, box_at({0, 0, 0}, 50), AreaKind::kTrigger);
  areas.link(EntityIndex{4}, box_at({0, 100, 0}, 50), AreaKind::kTrigger);
  EXPECT_THAT(found_in(areas, kWorld, AreaKind::kTrigger),
              ElementsAre(EntityIndex{3}, EntityIndex{4}, EntityIndex{1}, EntityIndex{2}));
  // Linked again: now after the others.
  areas.link(EntityIndex{3}, box_at({0, 0, 0}, 50), AreaKind::kTrigger);
  EXPECT_THAT(found_in(areas, kWorld, AreaKind::kTrigger),
              ElementsAre(EntityIndex{4}, EntityIndex{3}, EntityIndex{1}, EntityIndex{2}));
}

TEST(Areas, AcceptBoxesOutsideOfTheLevelAndInvalidOnes) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Areas areas(kWorld);
  areas.link(EntityIndex{1}, box_at({99999, 99999, 0}, 2), AreaKind::kSolid);
  areas.link(EntityIndex{2}, {{kNan, 0, 0}, {kNan, 1, 1}}, AreaKind::kSolid);
  areas.link(EntityIndex{3}, {{50, 50, 50}, {-50, -50, -50}}, AreaKind::kSolid);  // upside down
  EXPECT_THAT(found_in(areas, box_at({99999, 99999, 0}, 2), AreaKind::kSolid), ElementsAre(EntityIndex{1}));
  EXPECT_THAT(found_in(areas, {{kNan, kNan, kNan}, {kNan, kNan, kNan}}, AreaKind::kSolid), IsEmpty());
  EXPECT_THAT(found_in(areas, box_at({0, 0, 0}, 1), AreaKind::kSolid), IsEmpty());
  areas.unlink(EntityIndex{2});
  areas.unlink(EntityIndex{2});
  areas.unlink(EntityIndex{4000});
  EXPECT_THAT(found_in(areas, {{-1e6f, -1e6f, -1e6f}, {1e6f, 1e6f, 1e6f}}, AreaKind::kSolid),
              UnorderedElementsAre(EntityIndex{1}, EntityIndex{3}));
}

}  // namespace
}  // namespace temblor::server
