// Outlines of models, and the pixels that floods reach within them.
#include <gtest/gtest.h>

#include <map>

#include "lab/model_pictures.h"
#include "lab/models/flood/flooded_picture.h"
#include "lab/models/flood/outline.h"
#include "support/effort.h"

namespace temblor::test {
namespace {

// A tetrahedron on the screen, in whole pixels. Texels are numbers of vertices.
struct Tetrahedron {
  std::array<render::ScreenVertex, 4> vertices{};
  std::array<render::TexelPoint, 4> texels{{{0.5f, 0.5f}, {1.5f, 0.5f}, {2.5f, 0.5f}, {3.5f, 0.5f}}};
  std::array<std::uint32_t, 12> corners{0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
  std::array<std::uint8_t, 4> skin{1, 2, 3, 4};
  std::vector<std::uint8_t> colormap;
  render::TriangleJob job{};

  explicit Tetrahedron(Random& random) {
    for (render::ScreenVertex& vertex : vertices) {
      vertex.x = static_cast<std::int32_t>(random.below(60)) * render::kSubpixels;
      vertex.y = static_cast<std::int32_t>(random.below(60)) * render::kSubpixels;
      vertex.depth = 1;
    }
    for (int i = 0; i < 64 * 256; ++i) colormap.push_back(static_cast<std::uint8_t>(i & 255));
    job.vertices = vertices.data();
    job.texels = texels.data();
    job.triangles = corners.data();
    job.vertex_count = vertices.size();
    job.triangle_count = corners.size() / 3;
    job.skin = skin.data();
    job.skin_width = 4;
    job.skin_height = 1;
    job.colors = colormap.data();
  }
  Tetrahedron(const Tetrahedron&) = delete;
  Tetrahedron& operator=(const Tetrahedron&) = delete;

  lab::MeshEdges edges() const {
    std::vector<render::MeshTriangle> triangles;
    for (std::size_t i = 0; i < 12; i += 3) triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return lab::MeshEdges(triangles);
  }

  // Twice the area of a triangle, positive for front faces.
  std::int64_t cross(std::size_t a, std::size_t b, std::size_t c) const {
    const auto side = [&](std::size_t i, std::size_t j) {
      return (std::int64_t{vertices[i].x} - vertices[a].x) * (std::int64_t{vertices[j].y} - vertices[a].y);
    };
    return side(b, c) - side(c, b);
  }
};

// Front triangles by the definition, and edges by counting them.
TEST(Outlines, AreEdgesWithOneFrontTriangle) {
  for (int seed = 0; seed < effort(500, 50); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Tetrahedron solid(random);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> fronts;
    std::size_t vertices = 0;
    std::array<bool, 4> is_seen{};
    for (std::size_t i = 0; i < 12; i += 3) {
      if (solid.cross(solid.corners[i], solid.corners[i + 1], solid.corners[i + 2]) <= 0) continue;
      for (std::size_t side = 0; side < 3; ++side) {
        const std::uint32_t a = solid.corners[i + side], b = solid.corners[i + (side + 1) % 3];
        ++fronts[std::minmax(a, b)];
        vertices += !is_seen[a];
        is_seen[a] = true;
      }
    }
    std::erase_if(fronts, [](const auto& edge) { return edge.second != 1; });
    base::Arena arena;
    const lab::Outline outline = lab::find_outline(solid.job, solid.edges(), arena);
    EXPECT_EQ(outline.vertices.size(), vertices) << seed;
    EXPECT_EQ(outline.edges.size(), fronts.size()) << seed;
    for (const lab::OutlineEdge& edge : outline.edges)
      EXPECT_TRUE(fronts.contains(std::minmax(edge.from, edge.to))) << seed;
  }
}

// A convex model has all pixels of its triangles, and no pixel is more than one away from them.
TEST(FloodedPictures, FillConvexModels) {
  int filled = 0;
  for (int seed = 0; seed < effort(300, 40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Tetrahedron solid(random);
    base::Arena arena;
    const lab::FloodedPicture picture =
        lab::flood_model(solid.job, solid.edges(), render::PixelFormat::kIndexed, arena, arena);
    // Whether the point lies in a front triangle that is larger by `margin` pixels.
    const auto is_inside = [&](int x, int y, double margin) {
      for (std::size_t i = 0; i < 12; i += 3) {
        if (solid.cross(solid.corners[i], solid.corners[i + 1], solid.corners[i + 2]) <= 0) continue;
        bool inside = true;
        for (std::size_t side = 0; side < 3; ++side) {
          const render::ScreenVertex& a = solid.vertices[solid.corners[i + side]];
          const render::ScreenVertex& b = solid.vertices[solid.corners[i + (side + 1) % 3]];
          const double dx = (b.x - a.x) / 256.0, dy = (b.y - a.y) / 256.0;
          const double away = (dx * (y - a.y / 256.0) - dy * (x - a.x / 256.0)) / std::hypot(dx, dy);
          inside = inside && away >= -margin;
        }
        if (inside) return true;
      }
      return false;
    };
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const bool is_drawn = picture.depth[y * picture.stride + x] > 0;
        filled += is_drawn;
        if (is_inside(picture.left + x, picture.top + y, -1e-9)) {
          EXPECT_TRUE(is_drawn) << seed;
        }
        if (!is_inside(picture.left + x, picture.top + y, 1)) {
          EXPECT_FALSE(is_drawn) << seed;
        }
        const auto color = static_cast<const std::uint8_t*>(picture.pixels)[y * picture.stride + x];
        if (is_drawn) {
          EXPECT_TRUE(color >= 1 && color <= 4) << seed;
        }
      }
  }
  EXPECT_GT(filled, 1000);
}

TEST(FloodedPictures, OfModelsWithoutAreaAreEmpty) {
  Random random(1);
  Tetrahedron solid(random);
  for (render::ScreenVertex& vertex : solid.vertices) vertex.x = vertex.y = 2560;
  base::Arena arena;
  EXPECT_EQ(lab::flood_model(solid.job, solid.edges(), render::PixelFormat::kRgb, arena, arena).width, 0);
}

}  // namespace
}  // namespace temblor::test
