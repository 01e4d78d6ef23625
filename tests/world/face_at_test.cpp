// Compares the faces near a point that the tree walk finds with a test of every face of the world.
#include "world/face_at.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"
#include "world/test_levels.h"

namespace temblor::world {
namespace {

std::vector<math::Vec3d> corners(const Level& level, const Face& face) {
  std::vector<math::Vec3d> result;
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i)
    result.emplace_back(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
  return result;
}

// The nearest point of a triangle, from its inside and its three sides in barycentric coordinates.
double distance_to_triangle(const math::Vec3d& a, const math::Vec3d& b, const math::Vec3d& c,
                            const math::Vec3d& point) {
  const auto to_side = [&](const math::Vec3d& start, const math::Vec3d& end) {
    const math::Vec3d way = end - start;
    const double squared = glm::dot(way, way);
    const double along = squared > 0 ? std::clamp(glm::dot(point - start, way) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, start + way * along);
  };
  double nearest = std::min({to_side(a, b), to_side(b, c), to_side(c, a)});
  const math::Vec3d ab = b - a, ac = c - a, ap = point - a;
  const double bb = glm::dot(ab, ab), bc = glm::dot(ab, ac), cc = glm::dot(ac, ac);
  const double determinant = bb * cc - bc * bc;
  if (determinant > 1e-9) {
    const double v = (cc * glm::dot(ap, ab) - bc * glm::dot(ap, ac)) / determinant;
    const double w = (bb * glm::dot(ap, ac) - bc * glm::dot(ap, ab)) / determinant;
    if (v >= 0 && w >= 0 && v + w <= 1)
      nearest = std::min(nearest, glm::distance(point, a + ab * v + ac * w));
  }
  return nearest;
}

double distance_to_face(const std::vector<math::Vec3d>& polygon, const math::Vec3d& point) {
  double nearest = glm::distance(point, polygon.at(0));
  for (std::size_t i = 2; i < polygon.size(); ++i)
    nearest = std::min(nearest, distance_to_triangle(polygon[0], polygon[i - 1], polygon[i], point));
  return nearest;
}

struct Counts {
  int found = 0, several = 0;
};

void expect_as_by_looking_at_all(const TestLevel& test_level, ModelIndex number, const math::Vec3d& point,
                                 double reach, NearFaceFinder& io_faces, Counts& io_counts) {
  constexpr double kUnsure = 0.01;
  const Level& level = *test_level.level;
  std::map<std::uint32_t, NearFace> found;
  for (const NearFace& near : io_faces.find(level, number, point, reach)) {
    EXPECT_TRUE(found.emplace(static_cast<std::uint32_t>(near.face), near).second) << "found twice";
  }
  const Model& model = level.models[base::to_size(number)];
  for (std::uint32_t i = model.first_face; i < model.first_face + model.face_count; ++i) {
    const Face& face = level.faces[i];
    const Plane& plane = level.planes[face.plane];
    const double in_front =
        (glm::dot(math::Vec3d(plane.normal), point) - double{plane.distance}) * (face.back_side ? -1 : 1);
    const double distance = distance_to_face(corners(level, face), point);
    const bool near = distance <= reach && in_front >= -NearFaceFinder::kMaxDistanceBehind;
    const bool unsure = std::abs(distance - reach) < kUnsure ||
                        std::abs(in_front + NearFaceFinder::kMaxDistanceBehind) < kUnsure;
    const auto it = found.find(i);
    if (!unsure) {
      EXPECT_EQ(it != found.end(), near)
          << test_level.name << " face " << i << " distance " << distance << " in front " << in_front;
    }
    if (it == found.end()) continue;
    EXPECT_NEAR(it->second.distance, distance, kUnsure) << test_level.name << " face " << i;
    EXPECT_NEAR(it->second.in_front, in_front, 1e-6);
    EXPECT_NEAR(glm::distance(it->second.nearest, point), it->second.distance, 1e-9);
  }
  io_counts.found += static_cast<int>(found.size());
  io_counts.several += found.size() > 1;
}

// Choose points near a face: most other points have no face within reach.
math::Vec3d place_near_a_face(const Level& level, ModelIndex number, test::Random& io_random) {
  const Model& model = level.models[base::to_size(number)];
  const Face& face = level.faces[model.first_face + io_random.below(model.face_count)];
  const std::vector<math::Vec3d> polygon = corners(level, face);
  const math::Vec3d middle = (polygon[0] + polygon[io_random.below(polygon.size())]) * 0.5;
  return middle + math::Vec3d(io_random.in_cube(io_random.log_uniform(0.1, 40)));
}

void expect_model(const TestLevel& level, ModelIndex model, int points) {
  test::Random random(1);
  NearFaceFinder faces;
  Counts counts;
  for (int i = 0; i < points; ++i)
    expect_as_by_looking_at_all(level, model, place_near_a_face(*level.level, model, random),
                                random.log_uniform(0.5, 60), faces, counts);
  EXPECT_GT(counts.found, points / 2);
  EXPECT_GT(counts.several, points / 10);
}

TEST(NearFaceFinder, SmallLevelAsByLookingAtAll) {
  expect_model(small_test_level(), ModelIndex{0}, test::effort(1000, 200));
}

TEST(NearFaceFinder, BrushModelsAsByLookingAtAll) {
  const TestLevel level = small_test_level();
  ASSERT_GT(level.level->models.size(), 1u);
  for (std::size_t model = 1; model < level.level->models.size(); ++model)
    expect_model(level, base::to_index<ModelIndex>(model), test::effort(200, 50));
}

TEST(NearFaceFinder, StockLevelsAsByLookingAtAll) {
  DATA_FOLDER_OR_SKIP(data);
  for (const TestLevel& level : stock_levels(data)) expect_model(level, ModelIndex{0}, test::effort(200, 20));
}

TEST(NearFaceFinder, NowhereIsNearNothing) {
  NearFaceFinder faces;
  const TestLevel level = small_test_level();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(faces.find(*level.level, ModelIndex{0}, math::Vec3d(1e9), 5).empty());
  EXPECT_TRUE(faces.find(*level.level, ModelIndex{0}, math::Vec3d(std::nan("")), 5).empty());
  EXPECT_TRUE(faces.find(*level.level, ModelIndex{0}, math::Vec3d(infinite), 5).empty());
}

}  // namespace
}  // namespace temblor::world
