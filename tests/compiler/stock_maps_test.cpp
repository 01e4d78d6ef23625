// Every map of the game data, compiled and compared with the finished level that its makers ship.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "base/text.h"
#include "compiler/bsp/make_draft.h"
#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec3d;

// A face of the world as a viewer sees it.
struct SeenFace {
  Vec3d normal{0.0};
  double distance = 0;
  std::string texture;
  std::vector<Vec3d> corners;  // clockwise
  Vec3d mins{1e9}, maxs{-1e9};
};

std::vector<SeenFace> faces_of_world(const formats::Bsp& bsp) {
  std::vector<SeenFace> faces;
  const formats::BspModel& world = bsp.models.front();
  for (std::uint32_t i = world.first_face; i < world.first_face + world.face_count; ++i) {
    const formats::BspFace& from = bsp.faces[i];
    const double sign = from.side == 0 ? 1 : -1;
    SeenFace face{
        Vec3d(bsp.planes[from.plane].normal) * sign,
        double{bsp.planes[from.plane].distance} * sign,
        base::to_lower(bsp.miptexes[static_cast<std::size_t>(bsp.texinfos[from.texinfo].miptex)].name),
        {}};
    for (std::uint32_t k = 0; k < from.surfedge_count; ++k) {
      const std::int32_t edge = bsp.surfedges[from.first_surfedge + k];
      const auto& ends = bsp.edges[static_cast<std::size_t>(std::abs(edge))].vertices;
      face.corners.emplace_back(bsp.vertices[ends[edge < 0 ? 1 : 0]]);
      face.mins = glm::min(face.mins, face.corners.back() - 0.1);
      face.maxs = glm::max(face.maxs, face.corners.back() + 0.1);
    }
    faces.push_back(std::move(face));
  }
  return faces;
}

// The first face that a ray meets from its front; null: none.
const SeenFace* first_met(const std::vector<SeenFace>& faces, const Vec3d& from, const Vec3d& direction) {
  const SeenFace* met = nullptr;
  double nearest = 1e9;
  for (const SeenFace& face : faces) {
    const double toward = glm::dot(direction, face.normal);
    if (toward > -1e-9) continue;
    const double along = (face.distance - glm::dot(from, face.normal)) / toward;
    if (along < 1e-6 || along >= nearest) continue;
    const Vec3d point = from + direction * along;
    if (glm::any(glm::lessThan(point, face.mins)) || glm::any(glm::greaterThan(point, face.maxs))) continue;
    bool inside = true;
    for (std::size_t i = 0; i < face.corners.size() && inside; ++i) {
      const Vec3d &a = face.corners[i], &b = face.corners[(i + 1) % face.corners.size()];
      inside = glm::dot(glm::cross(face.normal, b - a), point - a) <= 1e-3;
    }
    if (!inside) continue;
    nearest = along;
    met = &face;
  }
  return met;
}

std::vector<Vec3d> list_eyes(const formats::Bsp& bsp) {
  constexpr double kEyeHeight = 22;  // above an entity's origin
  std::vector<Vec3d> eyes;
  const std::vector<formats::Entity> entities = formats::read_entities(bsp.entities).value();
  for (const formats::Entity& entity : entities) {
    const std::string_view name = entity.classname();
    if (!name.starts_with("info_") && !name.starts_with("item_") && !name.starts_with("monster_")) continue;
    if (const auto origin = entity.find_vec3("origin"))
      eyes.push_back(Vec3d(*origin) + Vec3d(0, 0, kEyeHeight));
  }
  return eyes;
}

class StockMaps : public ::testing::TestWithParam<const char*> {};

TEST_P(StockMaps, LookLikeTheFinishedLevels) {
  DATA_FOLDER_OR_SKIP(data);
  const std::string name = GetParam();
  if (!std::filesystem::exists(data / "mapsrc" / (name + ".map")))
    GTEST_SKIP() << "no mapsrc/" << name << ".map";
  const base::ByteVector text = read_file(data / "mapsrc" / (name + ".map"));
  base::Jobs jobs(2);
  compiler::Warnings warnings;
  const compiler::DraftResult made =
      compiler::make_draft(
          formats::read_map(base::as_text(text)).value(),
          [](std::string_view) { return math::Vec2d(64, 64); }, {}, jobs, warnings)
          .value();
  EXPECT_FALSE(made.leak) << "the finished level has none";
  const base::ByteVector finished_bytes = read_file(data / "id1" / "maps" / (name + ".bsp"));
  const formats::Bsp finished = formats::read_bsp(finished_bytes).value();
  EXPECT_EQ(made.draft.bsp.models.size(), finished.models.size());

  const std::vector<SeenFace> ours = faces_of_world(made.draft.bsp), theirs = faces_of_world(finished);
  const std::vector<Vec3d> eyes = list_eyes(finished);
  ASSERT_FALSE(eyes.empty());
  Random random(7);
  const int rays = effort(20000, 1000);
  int met = 0, agree = 0, holes = 0;
  std::map<std::string, int> differences;
  for (int i = 0; i < rays; ++i) {
    const Vec3d eye = eyes[random.below(eyes.size())];
    const Vec3d direction(random.in_cube(1));
    const SeenFace* const expected = first_met(theirs, eye, direction);
    if (expected == nullptr) continue;  // the eye is in a wall
    ++met;
    const SeenFace* const got = first_met(ours, eye, direction);
    if (got == nullptr) {
      ++holes;
      continue;
    }
    const bool same = glm::length(got->normal - expected->normal) < 0.01 &&
                      std::abs(got->distance - expected->distance) < 0.1 && got->texture == expected->texture;
    agree += same ? 1 : 0;
    if (!same) ++differences[fmt::format("{} for {}", got->texture, expected->texture)];
  }
  EXPECT_GT(met, rays / 2);
  EXPECT_EQ(holes, 0);
  EXPECT_GE(agree, met * 0.99);
  for (const auto& [what, times] : differences) ::testing::Test::RecordProperty(what, times);
}

std::vector<const char*> maps_with_rooms() {
  if (kQuick) return {"start", "lq_e0m9", "lqdm12"};
  return {"start", "lq_e0m1", "lq_e0m3", "lq_e0m9", "lq_e1m2", "lqdm5", "lqdm11", "lqdm12"};
}

INSTANTIATE_TEST_SUITE_P(All, StockMaps, ::testing::ValuesIn(maps_with_rooms()),
                         [](const auto& map) { return std::string(map.param); });

}  // namespace
}  // namespace temblor::test
