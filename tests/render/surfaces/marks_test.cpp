#include "render/marks.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace temblor::render {
namespace {

constexpr world::FaceIndex kFace{7}, kOther{8};

Mark mark_at(float x, std::uint32_t seed = 1) {
  return {MarkKind::kBulletHole, {x, 2, 3}, 4, seed};
}

TEST(Marks, AFaceWithoutMarksHasNone) {
  const MarkSet set;
  EXPECT_TRUE(set.marks_on_face(kFace).empty());
  EXPECT_EQ(set.revision(kFace), 0u);
  EXPECT_EQ(set.size(), 0u);
}

TEST(Marks, TheOldestGivesWay) {
  MarkSet set;
  const std::size_t added = MarkSet::kMarksPerFace + 3;
  for (std::size_t i = 0; i < added; ++i) set.add(kFace, mark_at(static_cast<float>(i)));
  set.add(kOther, mark_at(100));
  ASSERT_EQ(set.marks_on_face(kFace).size(), MarkSet::kMarksPerFace);
  for (std::size_t i = 0; i < MarkSet::kMarksPerFace; ++i)
    EXPECT_EQ(set.marks_on_face(kFace)[i].position_model.x, static_cast<float>(i + 3));
  EXPECT_EQ(set.marks_on_face(kOther).size(), 1u);
  EXPECT_EQ(set.size(), MarkSet::kMarksPerFace + 1);
  set.clear();
  EXPECT_EQ(set.size(), 0u);
  EXPECT_EQ(set.revision(kFace), 0u);
}

Mark lasting_at(float x) {
  Mark mark = mark_at(x);
  mark.is_lasting = true;
  return mark;
}

std::vector<float> places(const MarkSet& set) {
  std::vector<float> result;
  for (const Mark& mark : set.marks_on_face(kFace)) result.push_back(mark.position_model.x);
  return result;
}

TEST(Marks, ShotsDoNotReplaceLastingOnes) {
  MarkSet set;
  const auto full = static_cast<int>(MarkSet::kMarksPerFace);
  set.add(kFace, lasting_at(100));
  for (int i = 0; i < 2 * full; ++i) set.add(kFace, mark_at(static_cast<float>(i)));
  EXPECT_EQ(places(set).size(), MarkSet::kMarksPerFace);
  EXPECT_EQ(places(set).front(), 100);
  for (int i = 0; i < full + 2; ++i) set.add(kFace, lasting_at(static_cast<float>(200 + i)));
  EXPECT_EQ(places(set).size(), MarkSet::kMarksPerFace);
  EXPECT_EQ(places(set).front(), 202);  // older lasting ones gave way to newer ones
  const std::uint64_t revision = set.revision(kFace);
  set.add(kFace, mark_at(1));
  EXPECT_EQ(set.revision(kFace), revision);
}

TEST(Marks, OfShotsCanBeRemoved) {
  MarkSet set, expected;
  set.add(kFace, mark_at(1));
  set.add(kFace, lasting_at(2));
  set.add(kOther, mark_at(3));
  set.remove_shots();
  expected.add(kFace, lasting_at(2));
  EXPECT_EQ(set.size(), 1u);
  EXPECT_EQ(set.revision(kFace), expected.revision(kFace));
  EXPECT_EQ(set.revision(kOther), 0u);
}

Mark picture_at(std::uint32_t pixel, const math::Vec3& up) {
  Mark mark{.kind = MarkKind::kPicture, .position_model = {1, 2, 3}};
  mark.picture = std::make_shared<const MarkPicture>(formats::Image{1, 1, {pixel}});
  mark.up_model = up;
  return mark;
}

TEST(Marks, PicturesDifferByPixelsAndDirection) {
  const auto revision = [](const Mark& mark) {
    MarkSet set;
    set.add(kFace, mark);
    return set.revision(kFace);
  };
  const std::uint64_t first = revision(picture_at(0xff102030u, {0, 0, 1}));
  EXPECT_EQ(first, revision(picture_at(0xff102030u, {0, 0, 1})));
  EXPECT_NE(first, revision(picture_at(0xff102031u, {0, 0, 1})));
  EXPECT_NE(first, revision(picture_at(0xff102030u, {0, 1, 0})));
}

TEST(Marks, EqualMarksHaveEqualRevisionsInAnySet) {
  MarkSet one, two;
  // The second set reaches the same marks in another way: older ones were replaced.
  for (int i = 0; i < 5; ++i) two.add(kFace, mark_at(1000));
  for (std::size_t i = 0; i < MarkSet::kMarksPerFace; ++i) {
    one.add(kFace, mark_at(static_cast<float>(i)));
    two.add(kFace, mark_at(static_cast<float>(i)));
  }
  EXPECT_EQ(one.revision(kFace), two.revision(kFace));
  MarkSet positive, negative;
  positive.add(kFace, mark_at(0.0f));
  negative.add(kFace, mark_at(-0.0f));
  EXPECT_EQ(positive.revision(kFace), negative.revision(kFace));
}

TEST(Marks, EveryPartOfAMarkCounts) {
  std::vector<std::vector<Mark>> faces;
  const Mark plain = mark_at(1);
  faces.push_back({plain});
  for (int part = 0; part < 6; ++part) {
    Mark mark = plain;
    if (part == 0) mark.kind = MarkKind::kScorch;
    if (part == 1) mark.position_model.x += 1;
    if (part == 2) mark.position_model.y += 1;
    if (part == 3) mark.position_model.z += 1;
    if (part == 4) mark.radius += 1;
    if (part == 5) mark.seed += 1;
    faces.push_back({mark});
    faces.push_back({plain, mark});
    faces.push_back({mark, plain});
  }
  faces.push_back({plain, plain});
  std::set<std::uint64_t> revisions;
  for (const std::vector<Mark>& marks : faces) {
    MarkSet set;
    for (const Mark& mark : marks) set.add(kFace, mark);
    revisions.insert(set.revision(kFace));
  }
  EXPECT_EQ(revisions.size(), faces.size());
  EXPECT_FALSE(revisions.contains(0));
}

}  // namespace
}  // namespace temblor::render
