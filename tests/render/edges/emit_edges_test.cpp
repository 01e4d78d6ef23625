// The edge table, down to every number, does not depend on threads or on the division of faces into jobs. And
// neighbors are those of the definition.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

#include "render/edges/edge_table.h"
#include "render/view/level_tables.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/drawable_level.h"
#include "support/pictures/stage_parts.h"
#include "support/pictures/viewpoints.h"

namespace temblor::test {
namespace {

using render::EdgeTable;

// Compares field by field, since structs have padding.
void expect_equal(const EdgeTable& expected, const EdgeTable& table) {
  ASSERT_EQ(table.edges.size(), expected.edges.size());
  for (std::size_t i = 0; i < table.edges.size(); ++i) {
    const render::Edge &edge = table.edges[i], &wanted = expected.edges[i];
    ASSERT_TRUE(edge.x_first == wanted.x_first && edge.step == wanted.step &&
                edge.first_row == wanted.first_row && edge.last_row == wanted.last_row &&
                edge.leading == wanted.leading && edge.trailing == wanted.trailing)
        << "edge " << i;
  }
  ASSERT_TRUE(
      std::equal(table.order.begin(), table.order.end(), expected.order.begin(), expected.order.end()));
  ASSERT_TRUE(std::equal(table.row_begin.begin(), table.row_begin.end(), expected.row_begin.begin(),
                         expected.row_begin.end()));
  ASSERT_EQ(table.surfaces.size(), expected.surfaces.size());
  for (std::size_t i = 0; i < table.surfaces.size(); ++i) {
    const render::ScreenSurface &surface = table.surfaces[i], &wanted = expected.surfaces[i];
    ASSERT_TRUE(surface.key == wanted.key && surface.instance == wanted.instance &&
                surface.face == wanted.face && surface.first_draw == wanted.first_draw &&
                surface.tiles.s == wanted.tiles.s && surface.tiles.t == wanted.tiles.t &&
                surface.fragment == wanted.fragment && surface.nearest_z == wanted.nearest_z)
        << "surface " << i;
  }
  ASSERT_EQ(table.fragments.size(), expected.fragments.size());
  for (std::size_t i = 0; i < table.fragments.size(); ++i) {
    const render::ScreenPlane &depth = table.fragments[i].depth, &wanted = expected.fragments[i].depth;
    ASSERT_TRUE(depth.at_origin == wanted.at_origin && depth.dx == wanted.dx && depth.dy == wanted.dy)
        << "fragment " << i;
  }
  ASSERT_EQ(table.model_views.size(), expected.model_views.size());
  ASSERT_EQ(table.draw_count, expected.draw_count);
}

void expect_same_for_any_jobs(const world::Level& level) {
  constexpr int kViews = effort(20, 10);
  const render::LevelTables level_tables = render::make_level_tables(level);
  const render::FaceOutlines outlines = render::make_face_outlines(level);
  StageParts one, two({.threads = 2, .job_backend = base::JobBackend::kStdThread}),
      four({.threads = 4, .job_backend = base::JobBackend::kStdThread});
  std::size_t fragments = 0, edges = 0;
  for (int number = 0; number < kViews; ++number) {
    SCOPED_TRACE(fmt::format("{}, view {}", level.name, number));
    Random random(static_cast<std::uint64_t>(number));
    Viewpoint viewpoint{.camera = random_camera(level, random), .brush_models = shown_brush_models(level)};
    if (number % 2 == 1) displace(level, viewpoint.brush_models, random);
    if (number % 5 == 4) viewpoint.camera.projection = render::Projection::kOrthographic;
    const render::Scene scene = viewpoint.scene(level);
    const render::ViewFrame view = render::make_view_frame(scene, 320, 200);
    for (StageParts* parts : {&one, &two, &four}) parts->arenas.frame.reset();
    const render::VisibleFaces visible = render::find_visible_faces(one.context(scene), view, level_tables);
    const EdgeTable expected = emit_edges(one.context(scene), view, visible, outlines);
    for (StageParts* parts : {&two, &four})
      for (const std::size_t faces_per_job : {std::size_t{1}, std::size_t{10}, render::kFacesPerEdgeJob}) {
        expect_equal(expected, emit_edges(parts->context(scene), view, visible, outlines, faces_per_job));
        if (testing::Test::HasFatalFailure()) return;
      }
    fragments += expected.fragments.size();
    edges += expected.edges.size();
  }
  EXPECT_GT(edges, 10u * kViews);
  EXPECT_EQ(fragments > 0, !shown_brush_models(level).empty());
}

void expect_neighbors_as_defined(const world::Level& level) {
  struct Use {
    std::size_t face;
    bool backward;
  };
  std::map<std::size_t, std::vector<Use>> uses;
  const auto edge_index = [&](const world::Face& face, std::size_t side) {
    return static_cast<std::size_t>(std::abs(level.surfedges[face.first_surfedge + side]));
  };
  for (std::size_t i = 0; i < level.faces.size(); ++i)
    for (std::size_t side = 0; side < level.faces[i].surfedge_count; ++side)
      uses[edge_index(level.faces[i], side)].push_back(
          {i, level.surfedges[level.faces[i].first_surfedge + side] < 0});
  const render::FaceOutlines outlines = render::make_face_outlines(level);
  ASSERT_EQ(outlines.faces.size(), level.faces.size());
  std::size_t shared = 0;
  for (std::size_t i = 0; i < level.faces.size(); ++i) {
    const render::FaceOutline& outline = outlines.faces[i];
    ASSERT_EQ(outline.corner_count, level.faces[i].surfedge_count);
    for (std::size_t side = 0; side < outline.corner_count; ++side) {
      const std::vector<Use>& both = uses[edge_index(level.faces[i], side)];
      world::FaceIndex expected = render::kNoNeighbor;
      if (both.size() == 2 && both[0].face != both[1].face && both[0].backward != both[1].backward)
        expected = base::to_index<world::FaceIndex>(both[0].face == i ? both[1].face : both[0].face);
      const render::OutlineCorner& corner = outlines.corners[outline.first_corner + side];
      ASSERT_EQ(corner.neighbor, expected) << "face " << i << ", side " << side;
      ASSERT_EQ(corner.position, level.vertices[level.surfedge_start(level.faces[i].first_surfedge + side)]);
      shared += expected != render::kNoNeighbor;
    }
  }
  EXPECT_GT(shared, level.surfedges.size() / 4);
}

TEST(EmitEdges, MakesTheSameTableInAnyJobsOfTheSmallLevel) {
  expect_same_for_any_jobs(*small_level().level);
}

TEST(FaceOutlines, OfTheSmallLevelAreAsDefined) {
  expect_neighbors_as_defined(*small_level().level);
}

class StockLevelEdges : public testing::TestWithParam<const char*> {};
TEST_P(StockLevelEdges, AreTheSameInAnyJobs) {
  DATA_FOLDER_OR_SKIP(data);
  expect_same_for_any_jobs(*stock_level(data, GetParam()).level);
}
TEST_P(StockLevelEdges, LieBetweenNeighborsAsDefined) {
  DATA_FOLDER_OR_SKIP(data);
  expect_neighbors_as_defined(*stock_level(data, GetParam()).level);
}
INSTANTIATE_TEST_SUITE_P(Levels, StockLevelEdges, testing::Values("start", "lq_e0m1", "lq_e1m2", "lqdm1"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace temblor::test
