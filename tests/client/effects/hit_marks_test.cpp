// Marks in a level built in code, whose walls are known, and in a stock level.
#include "client/effects/hit_marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "artgen/small_level.h"
#include "math/angles.h"
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
      hit_marks.add(*level, {}, {MarkKind::kBulletHole, wall.middle + wall.normal * before, 6, 2.5f, 77},
                    set);
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
    hit_marks.add(*level, {}, {MarkKind::kScorch, center, 2, 32, 1}, set);
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
    hit_marks.add(*level, {}, {MarkKind::kScorch, wall.middle + wall.normal, 2, 64, 5}, set);
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
    hit_marks.add(*level, {}, {MarkKind::kBulletHole, wall.middle - wall.normal * 0.5f, 0.4f, 2.5f, 1}, set);
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
    hit_marks.add(*level, {},
                  {MarkKind::kScorch, sum / static_cast<float>(face.surfedge_count) + normal, 4, 100, 1},
                  set);
    EXPECT_TRUE(set.marks_on_face(base::to_index<world::FaceIndex>(i)).empty());
    (face.kind == world::FaceKind::kSky ? sky : liquid) += 1;
  }
  EXPECT_GT(sky, 0);
  EXPECT_GT(liquid, 0);
}

// The door of the small level, somewhere else and turned.
struct MovedDoor {
  world::ModelIndex model{1};
  render::BrushModelInstance mover{.model = model, .origin_world = {40, 300, 20}, .angles_deg = {20, 70, 5}};
  math::Basis basis = math::basis_from_angles(mover.angles_deg);

  math::Vec3 direction_to_world(const math::Vec3d& v) const {
    return math::Vec3(basis.forward * v.x - basis.right * v.y + basis.up * v.z);
  }
  math::Vec3 to_world(const math::Vec3d& p) const { return mover.origin_world + direction_to_world(p); }
};

TEST(HitMarks, StayWhereTheyAreOnADoorWhereverItIs) {
  const auto level = test::small_level().level;
  const MovedDoor door;
  const math::Vec3d middle =
      (math::Vec3d(artgen::small_level_door().mins) + math::Vec3d(artgen::small_level_door().maxs)) * 0.5;
  HitMarks hit_marks;
  const world::Model& model = level->models[1];
  int marked = 0;
  for (std::uint32_t i = model.first_face; i < model.first_face + model.face_count; ++i) {
    const auto face = base::to_index<world::FaceIndex>(i);
    const math::Vec3d normal = world::compute_face_plane(*level, level->face(face)).normal;
    const math::Vec3d on_face = world::find_nearest_point(*level, level->face(face), middle + normal * 100.0);
    for (const render::BrushModelInstance& mover : {door.mover, render::BrushModelInstance{door.model}}) {
      const bool is_moved = mover.origin_world != math::Vec3(0.0f);
      const math::Vec3d shot = on_face + normal * 3.0;
      MarkSet set;
      hit_marks.add(*level, {&mover, 1},
                    {MarkKind::kBulletHole, is_moved ? door.to_world(shot) : math::Vec3(shot), 6, 4, 7}, set);
      bool found = false;
      for (const Mark& mark : set.marks_on_face(face))
        found =
            found || (glm::distance(mark.position_model, math::Vec3(on_face)) < 0.05f && mark.radius == 4);
      // The world may be nearer to the door where it is in its frame.
      EXPECT_TRUE(found || !is_moved) << i;
      marked += found;
    }
  }
  EXPECT_GT(marked, static_cast<int>(model.face_count));
}

TEST(HitMarks, ADoorShieldsTheWallBehindIt) {
  const auto level = test::small_level().level;
  HitMarks hit_marks;
  int shielded = 0;
  for (const Wall& wall : walls(*level)) {
    // The door lies flat before the wall, 4 units from it: its large sides face x or y.
    const math::Bounds box = level->models[1].bounds;
    const math::Vec3 size = box.maxs - box.mins, middle = (box.maxs + box.mins) * 0.5f;
    const int thin = size.x < size.y ? 0 : 1;
    if (std::abs(wall.normal[thin]) < 0.99f) continue;
    const float away = size[thin] / 2 + 4;
    const render::BrushModelInstance door{.model = world::ModelIndex{1},
                                          .origin_world = wall.middle + wall.normal * away - middle};
    const math::Vec3 explosion = wall.middle + wall.normal * (away + size[thin] / 2 + 3);
    if (world::point_contents(*level, explosion) != world::Contents::kEmpty) continue;
    MarkSet with, without;
    hit_marks.add(*level, {&door, 1}, {MarkKind::kScorch, explosion, 28, 20, 1}, with);
    hit_marks.add(*level, {}, {MarkKind::kScorch, explosion, 28, 20, 1}, without);
    if (without.marks_on_face(wall.face).empty()) continue;
    EXPECT_TRUE(with.marks_on_face(wall.face).empty());
    EXPECT_GT(with.size(), 0u);
    ++shielded;
  }
  EXPECT_GT(shielded, 0);
}

TEST(HitMarks, APictureLiesInOnePlaneAndStandsUpright) {
  const auto level = test::small_level().level;
  const auto picture = std::make_shared<const render::MarkPicture>(formats::Image{1, 1, {0xffffffffu}});
  HitMarks hit_marks;
  int walls_seen = 0;
  for (const Wall& wall : walls(*level)) {
    Hit hit{MarkKind::kPicture, wall.middle + wall.normal, 4, 24};
    hit.picture = picture;
    hit.turn_deg = 90;
    hit.is_lasting = true;
    MarkSet set;
    hit_marks.add(*level, {}, hit, set);
    const auto marked = marked_faces(*level, set);
    if (marked.empty()) continue;
    const math::Vec3d plane = world::compute_face_plane(*level, level->face(marked.front().face)).normal;
    for (const MarkedFace& face : marked) {
      EXPECT_GT(glm::dot(world::compute_face_plane(*level, level->face(face.face)).normal, plane), 0.999);
      for (const Mark& mark : face.marks) {
        EXPECT_EQ(mark.radius, 24);
        EXPECT_TRUE(mark.is_lasting);
        // A quarter of a turn to the right of up (or of north, on floors).
        const math::Vec3d up = std::abs(plane.z) > 0.99 ? math::Vec3d(0, 1, 0) : math::Vec3d(0, 0, 1);
        EXPECT_LT(glm::distance(math::Vec3d(mark.up_model), glm::normalize(glm::cross(up, plane))), 1e-3);
        ++walls_seen;
      }
    }
  }
  EXPECT_GT(walls_seen, 20);
}

}  // namespace
}  // namespace temblor::client
