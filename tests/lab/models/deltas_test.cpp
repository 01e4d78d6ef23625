// Walks around the visible side of models, against the engine's scan lines.
#include "lab/models/deltas/deltas.h"

#include <gtest/gtest.h>

#include <set>

#include "lab/model_pictures.h"
#include "lab/models/deltas/mesh_neighbors.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

using lab::MeshNeighbors;

// Closed models have a neighbor at each side, also across the seam of the skin.
TEST(MeshNeighbors, SurroundEachTriangle) {
  for (const auto& model : {small_model(sphere_mdl()), small_model(box_mdl())}) {
    const MeshNeighbors neighbors(*model);
    EXPECT_EQ(2 * neighbors.edge_count(), 3 * model->triangles.size());
    for (std::uint32_t i = 0; i < model->triangles.size(); ++i)
      for (const MeshNeighbors::Side& side : neighbors.sides(i)) {
        ASSERT_NE(side.neighbor, MeshNeighbors::kNone) << i;
        const auto& back = neighbors.sides(side.neighbor);
        EXPECT_TRUE(std::ranges::any_of(back, [&](const MeshNeighbors::Side& other) {
          return other.neighbor == i && other.edge == side.edge;
        })) << i;
      }
    EXPECT_TRUE(neighbors.match(*model));
    EXPECT_FALSE(neighbors.match(*small_model(many_pose_mdl())));
  }
}

// Every front triangle is in a walk with many seeds once. A walk with one seed is its beginning.
TEST(VisibleWalks, ReachAllFrontTriangles) {
  const auto model = small_model(sphere_mdl());
  const MeshNeighbors neighbors(*model);
  for (int seed = 0; seed < effort(200, 30); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<render::ScreenVertex> vertices(model->vertex_count);
    for (render::ScreenVertex& vertex : vertices) {
      vertex.x = static_cast<std::int32_t>(random.below(10000));
      vertex.y = static_cast<std::int32_t>(random.below(10000));
      vertex.depth = static_cast<float>(random.uniform(0.001, 1));
    }
    render::TriangleJob job{};
    job.vertices = vertices.data();
    job.triangles = model->triangles.front().data();
    job.vertex_count = vertices.size();
    job.triangle_count = model->triangles.size();
    std::set<std::uint32_t> fronts;
    for (std::uint32_t i = 0; i < model->triangles.size(); ++i) {
      const render::MeshTriangle& corner = model->triangles[i];
      const auto side = [&](std::size_t p, std::size_t q) {
        const render::ScreenVertex &first = vertices[corner[0]], &x = vertices[corner[p]],
                                   &y = vertices[corner[q]];
        return (std::int64_t{x.x} - first.x) * (std::int64_t{y.y} - first.y);
      };
      if (side(1, 2) > side(2, 1)) fronts.insert(i);
    }
    base::Arena arena;
    const lab::VisibleWalk all = lab::walk_visible_side(job, neighbors, true, arena);
    EXPECT_EQ(std::set<std::uint32_t>(all.triangles.begin(), all.triangles.end()), fronts) << seed;
    EXPECT_EQ(all.triangles.size(), fronts.size()) << seed;
    const lab::VisibleWalk one = lab::walk_visible_side(job, neighbors, false, arena);
    EXPECT_EQ(one.seeds, 1u);
    ASSERT_LE(one.triangles.size(), all.triangles.size());
    EXPECT_TRUE(std::ranges::equal(one.triangles, all.triangles.first(one.triangles.size()))) << seed;
    EXPECT_EQ(one.triangles.size() == all.triangles.size(), all.seeds == 1) << seed;
  }
}

// Only the order of triangles differs, which shows where depths are equal.
TEST(Deltas, AreTheEnginesScanLines) {
  const DrawableLevel drawable = small_level();
  for (const render::PixelFormat format : {render::PixelFormat::kIndexed, render::PixelFormat::kRgb}) {
    std::size_t differing = 0, missing = 0;
    for (int seed = 0; seed < effort(20, 4); ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      ModelScene models(drawable, random, {.least = 15, .most = 600, .spread = 0.8, .count = 12});
      models.scene.view_weapon = &models.weapon;
      const render::Settings affine{.alias_raster = render::AliasRaster::kAffine};
      ModelPictures engine(drawable, nullptr, format), walked(drawable, "deltas", format);
      ModelPictures one_seed(drawable, "deltas:seeds=1", format);
      const FrameCopy right = engine.copy(models.scene, affine);
      differing += differing_pixels(right, walked.copy(models.scene, affine));
      missing += differing_pixels(right, one_seed.copy(models.scene, affine));
    }
    EXPECT_LT(differing, 20u);
    EXPECT_GE(missing, differing);
  }
}

}  // namespace
}  // namespace temblor::test
