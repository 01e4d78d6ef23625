// Overviews leave out exactly the faces whose front is sky or solid space.
#include <gtest/gtest.h>

#include <set>

#include "render/view/level_tables.h"
#include "render/view/view_frame.h"
#include "render/view/visible_faces.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/stage_parts.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using Faces = std::set<std::uint32_t>;

// Whether any place just in front of a face is open. The faces of this level are rectangles along the axes.
bool has_open_front(const world::Level& level, const world::Face& face) {
  constexpr int kSteps = 64;
  math::Vec3 mins(1e9f), maxs(-1e9f);
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const math::Vec3 vertex = level.vertices[level.surfedge_start(face.first_surfedge + i)];
    mins = glm::min(mins, vertex);
    maxs = glm::max(maxs, vertex);
  }
  const math::Vec3 front = level.planes[face.plane].normal * (face.back_side ? -0.25f : 0.25f);
  const math::Vec3 step = (maxs - mins) / static_cast<float>(kSteps);
  for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
    const math::Vec3 number(i % kSteps, i / kSteps % kSteps, i / kSteps / kSteps);
    const world::Contents contents =
        level.leaf(world::find_leaf(level, mins + (number + 0.5f) * step + front)).contents;
    if (contents != world::Contents::kSky && contents != world::Contents::kSolid) return true;
  }
  return false;
}

// The faces that are drawn from above.
Faces find_faces_from_above(const world::Level& level, bool is_overview) {
  render::Scene scene;
  scene.level = &level;
  const math::Bounds& bounds = level.world().bounds;
  scene.camera.origin_world = (bounds.mins + bounds.maxs) * 0.5f + math::Vec3(0, 0, 4000);
  scene.camera.angles_deg.x = 90;
  scene.camera.projection = render::Projection::kOrthographic;
  scene.is_overview = is_overview;
  StageParts parts;
  const render::FrameContext context = parts.context(scene);
  const render::LevelTables tables = render::make_level_tables(level);
  const render::VisibleFaces visible =
      render::find_visible_faces(context, render::make_view_frame(scene, 64, 64), tables);
  Faces faces;
  for (const auto& list : {visible.faces, visible.deferred_faces})
    for (const render::VisibleFace& face : list) faces.insert(static_cast<std::uint32_t>(face.face));
  return faces;
}

// Fills every third leaf of a level with sky or with solid space, as compilers of levels with such faces do.
TEST(Overview, LeavesOutFacesWhoseFrontIsSkyOrSolid) {
  world::Level level = *small_level().level;
  for (std::size_t leaf = 1; leaf < level.leaves.size(); leaf += 3)
    level.leaves[leaf].contents = leaf % 2 == 0 ? world::Contents::kSky : world::Contents::kSolid;
  const Faces all = find_faces_from_above(level, false), seen = find_faces_from_above(level, true);
  EXPECT_GT(all.size(), seen.size());
  Faces expected;
  for (const std::uint32_t face : all)
    if (has_open_front(level, level.faces[face])) expected.insert(face);
  EXPECT_EQ(seen, expected);
  EXPECT_GT(seen.size(), 20u);
}

TEST(Overview, KeepsAllFacesOfALevelWithoutThem) {
  const DrawableLevel small = small_level();
  EXPECT_EQ(find_faces_from_above(*small.level, true), find_faces_from_above(*small.level, false));
}

}  // namespace
}  // namespace temblor::test
