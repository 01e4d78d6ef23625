// Faces with very many vertices are split, because GL engines keep 64 of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/bsp/faces/vertices.h"
#include "compiler/drafts.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using compiler::FaceLoop;
using math::Vec3d;

constexpr std::size_t kMaxVertices = 60;

double measure_loop(const FaceLoop& loop, const compiler::VertexSet& vertices) {
  compiler::Winding winding;
  for (const std::uint32_t vertex : loop) winding.push_back(vertices.points()[vertex]);
  return compiler::area(winding);
}

// A random convex polygon in a plane, with vertices on its corners and many on its sides.
FaceLoop make_polygon(Random& random, compiler::VertexSet& out_vertices) {
  std::vector<double> angles(3 + random.below(5));
  for (double& angle : angles) angle = random.uniform(0, 6.28);
  std::ranges::sort(angles);
  std::vector<Vec3d> corners;
  for (const double angle : angles) corners.emplace_back(512 * std::cos(angle), 512 * std::sin(angle), 7);
  FaceLoop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d begin = corners[i], end = corners[(i + 1) % corners.size()];
    const std::size_t pieces = 1 + random.below(90);
    for (std::size_t k = 0; k < pieces; ++k) {
      const std::uint32_t vertex = out_vertices.find_or_add(
          begin + (end - begin) * (static_cast<double>(k) / static_cast<double>(pieces)));
      if (std::ranges::find(loop, vertex) == loop.end()) loop.push_back(vertex);
    }
  }
  return loop;
}

TEST(LongFaces, PiecesCoverThePolygonOnce) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    compiler::VertexSet vertices;
    const FaceLoop loop = make_polygon(random, vertices);
    const auto pieces = compiler::split_long_loop(loop, kMaxVertices, vertices);
    if (loop.size() <= kMaxVertices) {
      EXPECT_EQ(pieces, std::vector<FaceLoop>{loop});
      continue;
    }
    double sum = 0;
    for (const FaceLoop& piece : pieces) {
      EXPECT_LE(piece.size(), kMaxVertices);
      EXPECT_GE(piece.size(), 3u);
      const double area = measure_loop(piece, vertices);
      EXPECT_GT(area, 0);
      sum += area;
    }
    EXPECT_NEAR(sum, measure_loop(loop, vertices), 1e-6 * sum);
  }
}

TEST(LongFaces, APoolWithARimOfTilesIsSplit) {
  const compiler::DraftResult result = compile_draft(tiled_pool_text());
  EXPECT_FALSE(result.leak);
  EXPECT_EQ(find_level_fault(result), "");
  const auto longest =
      std::ranges::max_element(result.draft.bsp.faces, {}, &formats::BspFace::surfedge_count);
  EXPECT_LE(longest->surfedge_count, kMaxVertices);
  EXPECT_GT(longest->surfedge_count, kMaxVertices / 2) << "the surface was split";
  EXPECT_NEAR(measure_area_looking_up(result, "*water1", 0), 512 * 512, 1);
}

}  // namespace
}  // namespace temblor::test
