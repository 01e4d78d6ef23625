// The edge table and its scan against a slow definition: a pixel shows, of all polygons that the ray through
// its center hits, the one with the smallest key. The spans are the same for any division of the rows into
// bands.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "render/edges/edge_table.h"
#include "render/edges/span_table.h"
#include "support/effort.h"
#include "support/pictures/screen_polygons.h"
#include "support/pictures/stage_parts.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using math::Vec2d;
using math::Vec3d;
using render::EdgeTable;
using render::SurfaceIndex;
using render::ViewFrame;

// A span with the draw that the scan assigned to it.
struct ScannedSpan {
  int y, x, count;
  std::uint32_t draw;
  auto operator<=>(const ScannedSpan&) const = default;
};

// Scans a table with all the context that a scan needs. Returns spans in the order of the screen.
std::vector<ScannedSpan> scan(const EdgeTable& table, const render::Scene& scene, const ViewFrame& view,
                              int band_rows, int threads = 1) {
  StageParts parts({.threads = threads, .job_backend = base::JobBackend::kStdThread, .band_rows = band_rows});
  const render::SpanTable spans = render::scan_edges(parts.context(scene), view, table);
  std::vector<ScannedSpan> all;
  int next_row = 0;
  for (const render::Band& band : spans.bands) {
    EXPECT_EQ(band.first_row, next_row);
    next_row += band.row_count;
    EXPECT_TRUE(std::is_sorted(band.draws.begin(), band.draws.end()));
    for (std::size_t position = 0; position < band.draws.size(); ++position) {
      render::PixelSum sum;
      for (std::uint32_t i = band.span_begin[position]; i < band.span_begin[position + 1]; ++i) {
        const render::Span& span = band.spans[i];
        EXPECT_TRUE(span.y >= band.first_row && span.y < next_row);
        all.push_back({span.y, span.x, span.count, band.draws[position]});
        for (std::uint64_t pixel = 0; pixel < span.count; ++pixel) {
          ++sum.pixels;
          sum.x += span.x + pixel;
          sum.y += span.y;
        }
      }
      EXPECT_EQ(band.sums[position].pixels, sum.pixels);
      EXPECT_EQ(band.sums[position].x, sum.x);
      EXPECT_EQ(band.sums[position].y, sum.y);
    }
  }
  EXPECT_EQ(next_row, view.height);
  std::sort(all.begin(), all.end());
  return all;
}

// The draw of every pixel, row by row. Fails if spans leave a gap, overlap, or are empty.
std::vector<std::uint32_t> list_pixels(const std::vector<ScannedSpan>& spans, const ViewFrame& view) {
  std::vector<std::uint32_t> pixels;
  for (const ScannedSpan& span : spans) {
    EXPECT_GT(span.count, 0);
    EXPECT_EQ(static_cast<std::size_t>(span.y) * static_cast<std::size_t>(view.width) +
                  static_cast<std::size_t>(span.x),
              pixels.size());
    pixels.insert(pixels.end(), static_cast<std::size_t>(span.count), span.draw);
  }
  EXPECT_EQ(pixels.size(), static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  return pixels;
}

void expect_same_in_any_bands(const EdgeTable& table, const render::Scene& scene, const ViewFrame& view) {
  const std::vector<ScannedSpan> whole = scan(table, scene, view, view.height);
  for (const int band_rows : {1, 2, 7, 64})
    ASSERT_EQ(scan(table, scene, view, band_rows), whole) << "bands of " << band_rows;
  ASSERT_EQ(scan(table, scene, view, 3, 2), whole) << "on two threads";
}

struct HandMadeCase {
  ViewFrame view;
  std::vector<ScreenPolygon> polygons;

  explicit HandMadeCase(Random& random) {
    view.width = static_cast<int>(1 + random.below(150));
    view.height = static_cast<int>(1 + random.below(100));
    for (std::size_t i = random.below(random.chance(0.5) ? 5 : 60); i > 0; --i)
      polygons.push_back(any_polygon(view, random));
  }
  void expect_as_defined() const {
    const HandMadeTable table(view, polygons);
    const std::vector<std::uint32_t> pixels = list_pixels(scan(table.view(), {}, view, view.height), view);
    const auto wanted = find_shown_draws(view, polygons);
    ASSERT_EQ(pixels.size(), wanted.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
      if (wanted[i]) {
        ASSERT_EQ(pixels[i], *wanted[i])
            << "pixel " << i % static_cast<std::size_t>(view.width) << ", "
            << i / static_cast<std::size_t>(view.width) << " of " << view.width << "x" << view.height;
      }
    expect_same_in_any_bands(table.view(), {}, view);
  }
};

TEST(ScanEdges, ShowsThePolygonWithTheSmallestKey) {
  for (int seed = 0; seed < effort(150, 15); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    HandMadeCase hand_made(random);
    // All different, in any order.
    for (std::size_t i = 0; i < hand_made.polygons.size(); ++i)
      hand_made.polygons[i].key = static_cast<render::SortKey>(random.below(1000) * 1000 + i);
    hand_made.expect_as_defined();
    if (::testing::Test::HasFatalFailure()) return;
  }
}

// Planes that do not cross, some with the same key: among these the nearest is in front. Orthographic depths
// are negative.
TEST(ScanEdges, ShowsTheNearestOfEqualKeys) {
  for (int seed = 0; seed < effort(150, 15); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    HandMadeCase hand_made(random);
    const double sign = random.chance(0.3) ? -1 : 1;
    const double dx = random.uniform(-0.4, 0.4) / hand_made.view.width;
    const double dy = random.uniform(-0.4, 0.4) / hand_made.view.height;
    std::vector<double> nearness;
    for (std::size_t i = 0; i < hand_made.polygons.size(); ++i)
      nearness.push_back(sign * std::pow(1.03, static_cast<double>(i) + 1));
    for (std::size_t i = 0; i < hand_made.polygons.size(); ++i) {
      std::swap(nearness[i], nearness[i + random.below(nearness.size() - i)]);
      hand_made.polygons[i].key = static_cast<render::SortKey>(1 + random.below(3));
      hand_made.polygons[i].depth = {nearness[i], nearness[i] * dx, nearness[i] * dy};
    }
    hand_made.expect_as_defined();
    if (::testing::Test::HasFatalFailure()) return;
  }
}

// Two walls that meet at a vertical line, one in front of it and one behind: where the second begins, both
// have the same depth, and only the gradients decide.
TEST(ScanEdges, OrdersWallsThatTouchByTheirSlopes) {
  ViewFrame view;
  view.width = 64;
  view.height = 8;
  // From x = 20 on, one comes nearer and the other recedes; both reach to x = 50.
  for (const bool nearer_first : {false, true}) {
    std::vector<ScreenPolygon> walls(2);
    for (std::size_t i = 0; i < 2; ++i) {
      const double slope = (i == 0) == nearer_first ? 0.01 : -0.01;
      walls[i] = {{{20.25, -5}, {50.5, -5}, {50.5, 20}, {20.25, 20}}, 1, {1 - slope * 20.25, slope, 0}};
    }
    const HandMadeTable table(view, walls);
    const auto pixels = list_pixels(scan(table.view(), {}, view, view.height), view);
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x)
        ASSERT_EQ(pixels[static_cast<std::size_t>(y * view.width + x)], x < 21 || x > 50 ? 0u
                                                                        : nearer_first   ? 1u
                                                                                         : 2u)
            << x << ", " << y;
  }
}

// Planes with the same key that cross: where the second begins, the front one changes from row to row,
// although the same edges cross all rows in the same order.
TEST(ScanEdges, ComparesDepthsOnEveryRow) {
  ViewFrame view;
  view.width = 64;
  view.height = 48;
  for (const double dy : {-0.01, 0.01}) {
    std::vector<ScreenPolygon> walls(2);
    walls[0] = {{{10.5, -5}, {40.5, -5}, {40.5, 60}, {10.5, 60}}, 1, {1 - dy * 20.25, 0, dy}};
    walls[1] = {{{20.5, -5}, {50.5, -5}, {50.5, 60}, {20.5, 60}}, 1, {1, 0, 0}};
    const HandMadeTable table(view, walls);
    const auto pixels = list_pixels(scan(table.view(), {}, view, view.height), view);
    for (int y = 0; y < view.height; ++y) {
      const bool first_in_front = dy * (y - 20.25) > 0;
      for (int x = 0; x < view.width; ++x) {
        const std::uint32_t overlap = first_in_front ? 1 : 2;
        ASSERT_EQ(pixels[static_cast<std::size_t>(y * view.width + x)], x < 11 || x > 50 ? 0u
                                                                        : x < 21         ? 1u
                                                                        : x > 40         ? 2u
                                                                                         : overlap)
            << x << ", " << y;
      }
    }
  }
}

// From row 20 on, two edges enter from the right, and the first polygon's two have ended: as many as before.
TEST(ScanEdges, TellsEdgesThatComeFromThoseThatEnd) {
  Random random(0);
  HandMadeCase hand_made(random);
  hand_made.view.width = 64;
  hand_made.view.height = 40;
  hand_made.polygons = {
      {{{10.5, -5}, {30.5, -5}, {30.5, 19.5}, {10.5, 19.5}}, 1, {}},
      {{{161.5, -5}, {300, -5}, {300, 60}, {-98.5, 60}}, 3, {}},
      {{{162.5, -5}, {300, -5}, {300, 60}, {-97.5, 60}}, 2, {}},
  };
  hand_made.expect_as_defined();
}

// A band of one row is scanned without reusing a row above. Edges have few positions, so that many meet, and
// planes cross.
TEST(ScanEdges, FindsOnEveryRowWhatItFindsWithoutTheRowAbove) {
  for (int seed = 0; seed < effort(150, 15); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    HandMadeCase hand_made(random);
    for (ScreenPolygon& polygon : hand_made.polygons) {
      polygon.key = static_cast<render::SortKey>(1 + random.below(4));
      polygon.depth = {random.uniform(0.5, 2), random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
      if (random.chance(0.5))
        for (Vec2d& corner : polygon.corners) corner = Vec2d(std::round(corner.x / 8) * 8, corner.y);
    }
    const HandMadeTable table(hand_made.view, hand_made.polygons);
    expect_same_in_any_bands(table.view(), {}, hand_made.view);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

// ---- Tables from emit_edges: triangles between a few points share their edges in every way there is.

// The level's faces without its tree.
EdgeTable emit(const world::Level& level, const ViewFrame& view, std::span<const render::VisibleFace> faces,
               StageParts& io_parts) {
  render::Scene scene;
  scene.level = &level;
  render::VisibleFaces visible;
  visible.faces = faces;
  return render::emit_edges(io_parts.context(scene), view, visible, render::make_face_outlines(level));
}

struct Triangle {
  std::array<std::uint32_t, 3> vertices;
  render::SortKey key;
};

// Points around the eye, and triangles between them that face it: in front, behind, and across the near
// plane.
struct SolidCase {
  static constexpr std::uint32_t kNoTriangle = 0xffffffff;
  world::Level level;
  ViewFrame view;
  std::vector<Triangle> triangles;
  std::vector<render::VisibleFace> faces;

  explicit SolidCase(Random& random) {
    make_view(random);
    make_vertices(random);
    level.edges.push_back({});  // no surfedge can say edge 0 backwards: unused, as in files
    for (std::size_t i = 1 + random.below(random.chance(0.5) ? 6 : 40); i > 0; --i) add_triangle(random);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      faces.push_back({base::to_index<world::FaceIndex>(i), triangles[i].key});
      // A file may name a face twice in its tree. Behind its first surface it changes nothing.
      if (random.chance(0.1)) faces.push_back({faces.back().face, triangles[i].key + 500});
    }
  }

  // Twice the volume between the pixel's ray and the side from a to b, seen from the eye (in parallel
  // projection, from the pixel): the sign says on which side the ray passes.
  double passes(const Vec3d& a, const Vec3d& b, const Vec2d& at) const {
    if (view.perspective) return glm::dot(Vec3d(at, 1), glm::cross(a, b));
    const Vec3d from = a - Vec3d(at, 0), to = b - Vec3d(at, 0);
    return from.x * to.y - from.y * to.x;
  }
  // Whether the pixel's ray hits the triangle beyond the near plane; nothing if rounding decides.
  std::optional<bool> hits(const Triangle& triangle, int x, int y) const {
    const Vec2d at((x - view.center_x) / view.pixels_per_unit, -(y - view.center_y) / view.pixels_per_unit);
    std::array<Vec3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = view.to_view(Vec3d(level.vertices[triangle.vertices[i]]));
    double least = 1e300, most = -1e300;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d &a = corners[i], &b = corners[(i + 1) % 3];
      const double side = passes(a, b, at) / (1 + glm::length(a) * glm::length(b));
      if (std::abs(side) < 1e-9) return std::nullopt;
      least = std::min(least, side);
      most = std::max(most, side);
    }
    if (least < 0 && most > 0) return false;
    const Vec3d normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double distance = glm::dot(normal, corners[0]);
    const double z = view.perspective ? distance / glm::dot(normal, Vec3d(at, 1))
                                      : (distance - normal.x * at.x - normal.y * at.y) / normal.z;
    if (std::abs(z - view.near_z) < 1e-6) return std::nullopt;
    return z > view.near_z;
  }
  std::optional<std::uint32_t> triangle_at(int x, int y) const {
    std::optional<std::uint32_t> shown = kNoTriangle;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::optional<bool> hit = hits(triangles[i], x, y);
      if (!hit) return std::nullopt;
      if (*hit && (*shown == kNoTriangle || triangles[i].key < triangles[*shown].key))
        shown = static_cast<std::uint32_t>(i);
    }
    return shown;
  }

 private:
  void make_view(Random& random) {
    view.width = static_cast<int>(1 + random.below(120));
    view.height = static_cast<int>(1 + random.below(90));
    view.perspective = random.chance(0.7);
    view.eye_world = Vec3d(random.in_cube(100));
    view.axes = math::basis_from_angles(random.in_cube(180));
    view.center_x = view.width / 2.0 - 0.5;
    view.center_y = view.height / 2.0 - 0.5;
    view.pixels_per_unit = view.perspective ? random.log_uniform(0.2, 2) * view.width
                                            : random.log_uniform(0.01, 0.3) * view.width;
  }
  void make_vertices(Random& random) {
    const double size = random.log_uniform(1, 200), ahead = random.uniform(-0.5, 1.5) * size;
    for (int i = 0; i < 14; ++i) {
      const Vec3d middle = view.eye_world + view.axes.forward * ahead;
      level.vertices.push_back(math::Vec3(middle + Vec3d(random.in_cube(size))));
    }
  }
  void add_triangle(Random& random) {
    std::array<std::uint32_t, 3> vertices;
    for (std::uint32_t& vertex : vertices) vertex = static_cast<std::uint32_t>(random.below(14));
    if (vertices[0] == vertices[1] || vertices[1] == vertices[2] || vertices[2] == vertices[0]) return;
    const Vec3d a(level.vertices[vertices[0]]), b(level.vertices[vertices[1]]),
        c(level.vertices[vertices[2]]);
    // Clockwise seen from the front: (c - a) x (b - a) points to the front.
    const Vec3d normal = glm::cross(c - a, b - a);
    const double towards_eye =
        view.perspective ? glm::dot(normal, view.eye_world - a) : -glm::dot(normal, view.axes.forward);
    if (std::abs(towards_eye) < 1e-3 * glm::length(normal)) return;
    if (towards_eye < 0) std::swap(vertices[1], vertices[2]);

    world::Face face{};
    face.kind = world::FaceKind::kUnlit;
    face.first_surfedge = static_cast<std::uint32_t>(level.surfedges.size());
    face.surfedge_count = 3;
    level.faces.push_back(face);
    for (std::size_t i = 0; i < 3; ++i)
      level.surfedges.push_back(surfedge(vertices[i], vertices[(i + 1) % 3]));
    const auto key = static_cast<render::SortKey>(random.below(1000) * 1000 + triangles.size() + 1);
    triangles.push_back({vertices, key});
  }
  // The edge between the two vertices; added if there is none yet.
  std::int32_t surfedge(std::uint32_t from, std::uint32_t to) {
    if (const auto found = edge_of_.find({from, to}); found != edge_of_.end()) return found->second;
    const auto number = static_cast<std::int32_t>(level.edges.size());
    formats::BspEdge edge;
    edge.vertices = {from, to};
    level.edges.push_back(edge);
    edge_of_[{from, to}] = number;
    edge_of_[{to, from}] = -number;
    return number;
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int32_t> edge_of_;
};

TEST(EmittedEdges, ShowTheTriangleWithTheSmallestKey) {
  int pixels_checked = 0, triangles_shown = 0;
  for (int seed = 0; seed < effort(400, 30); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const SolidCase solid(random);
    StageParts parts;
    const EdgeTable table = emit(solid.level, solid.view, solid.faces, parts);
    const auto pixels = list_pixels(scan(table, {}, solid.view, solid.view.height), solid.view);
    ASSERT_FALSE(::testing::Test::HasFailure());
    // Draws are surfaces, since no face has tiles.
    for (int y = 0; y < solid.view.height; ++y)
      for (int x = 0; x < solid.view.width; ++x) {
        const std::optional<std::uint32_t> expected = solid.triangle_at(x, y);
        if (!expected) continue;
        const std::uint32_t draw = pixels[static_cast<std::size_t>(y * solid.view.width + x)];
        const std::uint32_t shown =
            draw == 0 ? SolidCase::kNoTriangle
                      : static_cast<std::uint32_t>(base::to_size(table.surfaces[draw].face));
        ASSERT_EQ(shown, *expected) << fmt::format("pixel {}, {} of {}x{}, {} triangles", x, y,
                                                   solid.view.width, solid.view.height,
                                                   solid.triangles.size());
        ++pixels_checked;
        triangles_shown += draw != 0;
      }
    expect_same_in_any_bands(table, {}, solid.view);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(triangles_shown, pixels_checked / 10);
  EXPECT_LT(triangles_shown, pixels_checked / 10 * 9);
}

// ---- Tiles: a face of more than 256 texels shows, at each pixel, the tile that contains its texel.

struct TiledCase {
  world::Level level;
  render::Scene scene;
  ViewFrame view;
  StageParts parts;
  EdgeTable table;

  explicit TiledCase(Random& random) {
    const double texels_per_unit = random.log_uniform(0.5, 8);
    level.planes.push_back({{0, 0, 1}, 0, 2});
    level.texture_axes.push_back({{static_cast<float>(texels_per_unit), 0.25f, 0},
                                  0,
                                  {0, -static_cast<float>(texels_per_unit), 0},
                                  0});
    level.vertices = {{-200, -200, 0}, {-200, 200, 0}, {200, 200, 0}, {200, -200, 0}};
    level.edges = {{}, {{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}};
    level.surfedges = {1, 2, 3, 4};
    world::Face face{};
    face.kind = world::FaceKind::kLit;
    face.light = 0;
    face.surfedge_count = 4;
    const auto reach = static_cast<std::int32_t>(std::ceil((200 * texels_per_unit + 50) / 16)) * 16;
    face.texture_mins = {-reach, -reach};
    face.texture_extents = {2 * reach, 2 * reach};
    level.faces.push_back(face);
    level.leaves.resize(1);
    world::Model model{};
    model.head = {-1};
    level.models.push_back(model);
    scene.level = &level;
    scene.camera.origin_world = random.in_cube(150);
    scene.camera.origin_world.z = static_cast<float>(random.log_uniform(0.5, 300));
    scene.camera.angles_deg = math::Vec3(math::Vec3d(random.uniform(5, 90), random.uniform(0, 360), 0));
    if (random.chance(0.4)) scene.camera.projection = render::Projection::kOrthographic;
    scene.camera.units_per_pixel = static_cast<float>(random.log_uniform(0.2, 4));
    view = render::make_view_frame(scene, 160, 100);
    const render::VisibleFace visible{world::FaceIndex{0}, 1};
    table = emit(level, view, {&visible, 1}, parts);
  }
  TiledCase(const TiledCase&) = delete;
  TiledCase& operator=(const TiledCase&) = delete;

  // The point on z = 0 that a pixel shows, in texels from the face's first texel.
  Vec2d texels_at(int x, int y) const {
    const Vec3d aside =
        (view.axes.right * (x - view.center_x) - view.axes.up * (y - view.center_y)) / view.pixels_per_unit;
    const Vec3d origin = view.perspective ? view.eye_world : view.eye_world + aside;
    const Vec3d ray = view.perspective ? view.axes.forward + aside : view.axes.forward;
    const Vec3d point = origin - ray * (origin.z / ray.z);
    const world::TextureAxes& axes = level.texture_axes[0];
    const world::Face& face = level.faces[0];
    return {glm::dot(point, Vec3d(axes.s_axis)) - face.texture_mins[0],
            glm::dot(point, Vec3d(axes.t_axis)) - face.texture_mins[1]};
  }
};

TEST(ScanEdges, CutsLargeFacesAtTheirTiles) {
  int checked = 0;
  for (int seed = 0; seed < effort(80, 6); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const TiledCase tiled(random);
    const auto pixels =
        list_pixels(scan(tiled.table, tiled.scene, tiled.view, tiled.view.height), tiled.view);
    ASSERT_FALSE(::testing::Test::HasFailure());
    const render::TileGrid grid = render::tile_grid(tiled.level.faces[0]);
    for (int y = 0; y < tiled.view.height; ++y)
      for (int x = 0; x < tiled.view.width; ++x) {
        const std::uint32_t draw = pixels[static_cast<std::size_t>(y * tiled.view.width + x)];
        if (draw == 0) continue;
        const Vec2d tile = tiled.texels_at(x, y) / 256.0;
        const auto is_border = [](double at) { return std::abs(at - std::round(at)) < 1e-7; };
        if (is_border(tile.x) || is_border(tile.y)) continue;
        ASSERT_EQ(draw - 1, static_cast<std::uint32_t>(std::floor(tile.y)) * grid.s +
                                static_cast<std::uint32_t>(std::floor(tile.x)))
            << x << ", " << y;
        ++checked;
      }
    expect_same_in_any_bands(tiled.table, tiled.scene, tiled.view);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(checked, effort(80, 6) * 1000);
}

}  // namespace
}  // namespace temblor::test
