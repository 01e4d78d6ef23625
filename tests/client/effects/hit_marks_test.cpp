// Marks in a level built in code, whose walls are known, and in a stock level.
#include "client/effects/hit_marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "support/levels/drawable_level.h"
#include "support/random.h"
#include "world/visibility.h"

namespace temblor::client {
namespace {

using render::Mark;
using render::MarkKind;
using render::MarkSet;

struct MarkedFace {
  world::FaceIndex face{};
  std::vector<Mark> marks;
};

std::vector<MarkedFace> marked_faces(const world::Level& level, const MarkSet& set) {
  std::vector<MarkedFace> result;
  for (std::size_t i = 0; i < level.faces.size(); ++i) {
    const auto face = base::to_index<world::FaceIndex>(i);
    const auto marks = set.marks_on_face(face);
    if (!marks.empty()) result.push_back({face, {marks.begin(), marks.end()}});
  }
  return result;
}

double in_front(const world::Level& level, world::FaceIndex face, const math::Vec3& point) {
  const world::FacePlane plane = world::compute_face_plane(level, level.face(face));
  return glm::dot(plane.normal, math::Vec3d(point)) - plane.distance;
}

// The center of a large lit face, and its normal.
struct Wall {
  world::FaceIndex face{};
  math::Vec3 middle{0.0f}, normal{0.0f};
};
std::vector<Wall> walls(const world::Level& level) {
  std::vector<Wall> result;
  for (std::uint32_t i = 0; i < level.world().face_count; ++i) {
    const world::Face& face = level.faces[level.world().first_face + i];
    if (face.kind != world::FaceKind::kLit) continue;
    math::Vec3 sum(0.0f);
    for (std::uint32_t corner = 0; corner < face.surfedge_count; ++corner)
      sum += level.vertices[level.surfedge_start(face.first_surfedge + corner)];
    result.push_back({base::to_index<world::FaceIndex>(level.world().first_face + i),
                      sum / static_cast<float>(face.surfedge_count),
                      math::Vec3(world::compute_face_plane(level, face).normal)});
  }
  return result;
}

TEST(HitMarks, AShotMarksTheNearestPointOfAWall) {
  const auto level = test::small_level().level;
  HitMarks hit_marks;
  int marked = 0;
  for (const Wall& wall : walls(*level)) {
    // Half the rounding of coordinates in messages, and 4 units, as for shots.
    for (const float before : {-0.06f, 0.1f, 4.0f}) {
      if (world::point_contents(*level, wall.middle + wall.normal * std::max(before, 0.1f)) !=
          world::Contents::kEmpty)
        continue;
      MarkSet set;
      hit_marks.add(*level, {MarkKind::kBulletHole, wall.middle + wall.normal * before, 6, 2.5f, 77}, set);
      bool on_wall = false;
      for (const MarkedFace& face : marked_faces(*level, set))
        for (const Mark& mark : face.marks) {
          EXPECT_EQ(mark.seed, 77u);
          EXPECT_LE(mark.radius, 2.5f);
          EXPECT_NEAR(in_front(*level, face.face, mark.position_model), 0, 0.01);
          on_wall =
              on_wall || (face.face == wall.face && glm::distance(mark.position_model, wall.middle) < 0.1f &&
                          mark.radius == 2.5f);
        }
      // A corner of a narrow face may be nearer than another face's center.
      EXPECT_TRUE(on_wall || set.size() > 0);
      marked += on_wall;
    }
  }
  EXPECT_GT(marked, 50);
}

TEST(HitMarks, ABallCutsAPlaneInACircle) {
  const auto level = test::small_level().level;
  HitMarks hit_marks;
  int deep = 0;
  for (const Wall& wall : walls(*level)) {
    MarkSet set;
    const math::Vec3 center = wall.middle + wall.normal;
    hit_marks.add(*level, {MarkKind::kScorch, center, 2, 32, 1}, set);
    for (const MarkedFace& face : marked_faces(*level, set)) {
      ASSERT_EQ(face.marks.size(), 1u);
      const Mark& mark = face.marks[0];
      EXPECT_EQ(mark.kind, MarkKind::kScorch);
      // The ball's center is on the wall that was hit: foot, circle and center form a right angle.
      double least = 1e9;
      for (const Wall& hit : walls(*level))
        if (std::abs(in_front(*level, hit.face, center)) <= 1.01)
          least = std::min(
              least, std::abs(std::hypot(double{mark.radius}, in_front(*level, face.face, center)) - 32));
      EXPECT_LT(least, 1.1);
      deep += mark.radius < 30;
    }
  }
  EXPECT_GT(deep, 10);
}

// A scorch across the border of two faces of a wall looks like one.
TEST(HitMarks, FacesInOnePlaneShareAMark) {
  const auto level = test::small_level().level;
  HitMarks hit_marks;
  int shared = 0;
  for (const Wall& wall : walls(*level)) {
    MarkSet set;
    hit_marks.add(*level, {MarkKind::kScorch, wall.middle + wall.normal, 2, 64, 5}, set);
    const auto own = set.marks_on_face(wall.face);
    if (own.empty()) continue;
    for (const MarkedFace& other : marked_faces(*level, set)) {
      if (std::abs(in_front(*level, other.face, wall.middle)) > 0.001 ||
          glm::dot(math::Vec3(world::compute_face_plane(*level, level->face(other.face)).normal),
                   wall.normal) < 0.999f)
        continue;
      EXPECT_LT(glm::distance(other.marks[0].position_model, own[0].position_model), 0.01f);
      EXPECT_NEAR(other.marks[0].radius, own[0].radius, 0.01f);
      shared += other.face != wall.face;
    }
  }
  EXPECT_GT(shared, 10);
}

TEST(HitMarks, NothingWithinReachMarksNothing) {
  const auto level = test::small_level().level;
  HitMarks hit_marks;
  for (const Wall& wall : walls(*level)) {
    MarkSet set;
    hit_marks.add(*level, {MarkKind::kBulletHole, wall.middle - wall.normal * 0.5f, 0.4f, 2.5f, 1}, set);
    EXPECT_EQ(set.marks_on_face(wall.face).size(), 0u);
  }
}

TEST(HitMarks, SkyAndLiquidsTakeNoMarks) {
  const auto level = test::small_level().level;
  HitMarks hit_marks;
  test::Random random(1);
  int sky = 0, liquid = 0;
  for (std::size_t i = 0; i < level->faces.size(); ++i) {
    const world::Face& face = level->faces[i];
    if (face.kind != world::FaceKind::kSky && face.kind != world::FaceKind::kLiquid) continue;
    const math::Vec3 normal(world::compute_face_plane(*level, face).normal);
    math::Vec3 sum(0.0f);
    for (std::uint32_t corner = 0; corner < face.surfedge_count; ++corner)
      sum += level->vertices[level->surfedge_start(face.first_surfedge + corner)];
    MarkSet set;
    hit_marks.add(
        *level, {MarkKind::kScorch, sum / static_cast<float>(face.surfedge_count) + normal, 4, 100, 1}, set);
    EXPECT_TRUE(set.marks_on_face(base::to_index<world::FaceIndex>(i)).empty());
    (face.kind == world::FaceKind::kSky ? sky : liquid) += 1;
  }
  EXPECT_GT(sky, 0);
  EXPECT_GT(liquid, 0);
}

}  // namespace
}  // namespace temblor::client
