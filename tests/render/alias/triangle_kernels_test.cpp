// Triangle kernels against definitions in exact and double arithmetic: which pixels a triangle covers, and
// their depth, texel, and light; and every instruction set against the scalar reference.
#include "render/alias/triangle_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "render/simd_targets.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using render::ScreenVertex;
using render::TexelPoint;

constexpr int kModelCanvasWidth = 97, kModelCanvasHeight = 61, kSkinWidth = 61, kSkinHeight = 43;
constexpr float kUntouched = -1;

struct Mesh {
  std::vector<ScreenVertex> vertices;
  std::vector<TexelPoint> texels;
  std::vector<std::uint32_t> triangles;
};

// The skin encodes the positions of its texels. The colors show them unchanged under any light, or show only
// the light.
std::vector<std::uint8_t> numbered_skin() {
  std::vector<std::uint8_t> skin(kSkinWidth * kSkinHeight);
  for (std::size_t i = 0; i < skin.size(); ++i) skin[i] = static_cast<std::uint8_t>(i * 31 % 251);
  return skin;
}

template <typename Pixel>
struct TriangleCanvas {
  // Memory past the last row, filled like the picture, reveals writes beyond it.
  std::vector<Pixel> pixels = std::vector<Pixel>(kModelCanvasWidth * kModelCanvasHeight + 64, Pixel{77});
  std::vector<float> depth = std::vector<float>(kModelCanvasWidth * kModelCanvasHeight + 64, kUntouched);
  bool operator==(const TriangleCanvas& other) const {
    return pixels == other.pixels &&
           std::memcmp(depth.data(), other.depth.data(), depth.size() * sizeof(float)) == 0;
  }
};

template <typename Pixel>
struct Colors {
  std::vector<Pixel> table;
  Colors() : table(64 * 256) {
    Random random(5);
    for (Pixel& entry : table) entry = static_cast<Pixel>(random.bits());
    if (sizeof(Pixel) == 4)
      for (std::size_t i = 0; i < 256; ++i)
        table[i] = static_cast<Pixel>(i >= 224 ? table[i] & 0xffffffu : table[i] | 0xff000000u);
  }
};

template <typename Pixel>
render::TriangleJob make_job(const Mesh& mesh, const std::vector<std::uint8_t>& skin,
                             const std::vector<Pixel>& colors, bool perspective) {
  return {mesh.vertices.data(),
          mesh.texels.data(),
          mesh.triangles.data(),
          mesh.vertices.size(),
          mesh.triangles.size() / 3,
          skin.data(),
          kSkinWidth,
          kSkinHeight,
          colors.data(),
          {32768, 20000, 9000},
          perspective,
          false,
          false,
          {}};
}

struct Fronts {
  std::vector<std::uint32_t> numbers;
  std::vector<render::TriangleRows> rows;
  render::FrontTriangles found;
};

template <auto Find>
Fronts find_fronts(const render::TriangleJob& job) {
  const std::size_t room = job.triangle_count + render::kFrontsSpare;
  Fronts fronts{std::vector<std::uint32_t>(room), std::vector<render::TriangleRows>(room), {}};
  fronts.found = {fronts.numbers.data(), fronts.rows.data(), 0};
  Find(job, fronts.found);
  return fronts;
}

// Adds what SIMD kernels need.
template <auto Draw>
void draw_fronts(render::TriangleJob job, const render::TriangleTarget& target) {
  const Fronts fronts = find_fronts<render::find_front_triangles_simd>(job);
  job.fronts = fronts.found;
  Draw(job, target);
}

ScreenVertex random_vertex(Random& random, double spread_px, bool snapped) {
  const auto coordinate = [&](int size) {
    const double px = size / 2.0 + random.uniform(-spread_px, spread_px);
    return static_cast<std::int32_t>(std::lround(snapped ? std::round(px) * 256 : px * 256));
  };
  return {coordinate(kModelCanvasWidth), coordinate(kModelCanvasHeight),
          static_cast<float>(random.log_uniform(0.001, 0.1)), static_cast<float>(random.uniform(0, 16320))};
}

TexelPoint random_texel(Random& random) {
  return {static_cast<float>(random.below(kSkinWidth)) + 0.5f,
          static_cast<float>(random.below(kSkinHeight)) + 0.5f};
}

// Unconnected triangles of all sizes, some far beyond the picture, some slivers.
Mesh random_mesh(Random& random, int triangles, bool snapped = false) {
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const double spread = random.log_uniform(0.3, random.chance(0.2) ? 30000 : 100);
    const double x = random.uniform(-50, 50) * 256, y = random.uniform(-30, 30) * 256;
    for (int corner = 0; corner < 3; ++corner) {
      ScreenVertex vertex = random_vertex(random, spread, snapped);
      if (!snapped) {
        vertex.x += static_cast<std::int32_t>(x);
        vertex.y += static_cast<std::int32_t>(y);
      }
      if (corner == 2 && random.chance(0.1)) vertex.x = mesh.vertices.back().x + 1;
      mesh.triangles.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(vertex);
      mesh.texels.push_back(random_texel(random));
    }
  }
  return mesh;
}

std::int64_t cross(const ScreenVertex& a, const ScreenVertex& b, std::int64_t x, std::int64_t y) {
  return (std::int64_t{b.x} - a.x) * (y - a.y) - (x - a.x) * (std::int64_t{b.y} - a.y);
}

// By the definition: on the inner side of all three sides; on a side, if it is a left or top one.
bool covers(const ScreenVertex* corner[3], int pixel_x, int pixel_y) {
  const std::int64_t x = std::int64_t{pixel_x} * 256, y = std::int64_t{pixel_y} * 256;
  if (cross(*corner[0], *corner[1], corner[2]->x, corner[2]->y) <= 0) return false;
  for (int i = 0; i < 3; ++i) {
    const ScreenVertex &a = *corner[i], &b = *corner[(i + 1) % 3];
    const std::int64_t inside = cross(a, b, x, y);
    const bool left_or_top = b.y < a.y || (b.y == a.y && b.x > a.x);
    if (inside < 0 || (inside == 0 && !left_or_top)) return false;
  }
  return true;
}

TEST(TriangleKernels, CoverExactlyWhatTheFillRuleSays) {
  const auto skin = numbered_skin();
  const Colors<std::uint8_t> colors;
  for (int seed = 0; seed < effort(400, 40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Mesh mesh = random_mesh(random, 1, seed % 2 == 0);
    TriangleCanvas<std::uint8_t> canvas;
    render::draw_triangles_u8_scalar(
        make_job(mesh, skin, colors.table, true),
        {canvas.pixels.data(), canvas.depth.data(), kModelCanvasWidth, 0, 0, kModelCanvasHeight});
    const ScreenVertex* corner[3] = {&mesh.vertices[0], &mesh.vertices[1], &mesh.vertices[2]};
    for (int y = 0; y < kModelCanvasHeight; ++y)
      for (int x = 0; x < kModelCanvasWidth; ++x)
        ASSERT_EQ(canvas.depth[static_cast<std::size_t>(y * kModelCanvasWidth + x)] != kUntouched,
                  covers(corner, x, y))
            << "seed " << seed << " pixel " << x << " " << y;
  }
}

// A field of triangles that share their sides: every pixel inside its outline is covered once, none outside.
TEST(TriangleKernels, CoverPixelsAlongSharedSidesOnce) {
  const auto skin = numbered_skin();
  const Colors<std::uint8_t> colors;
  constexpr std::uint32_t kCells = 9;
  for (int seed = 0; seed < effort(60, 10); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Mesh field;
    for (std::uint32_t row = 0; row <= kCells; ++row)
      for (std::uint32_t column = 0; column <= kCells; ++column) {
        const bool border = row == 0 || column == 0 || row == kCells || column == kCells;
        const double push = border ? 0 : 4;
        field.vertices.push_back({static_cast<std::int32_t>((4 + column * 9 + random.uniform(0, push)) * 256),
                                  static_cast<std::int32_t>((3 + row * 6 + random.uniform(0, push)) * 256),
                                  0.5f, 0});
        field.texels.push_back(random_texel(random));
      }
    std::vector<int> writes(kModelCanvasWidth * kModelCanvasHeight);
    for (std::uint32_t row = 0; row < kCells; ++row)
      for (std::uint32_t column = 0; column < kCells; ++column) {
        const std::uint32_t a = row * (kCells + 1) + column, c = a + kCells + 1;
        for (const auto& triangle : {std::array{a, a + 1, c + 1}, std::array{a, c + 1, c}}) {
          Mesh one = field;
          one.triangles.assign(triangle.begin(), triangle.end());
          TriangleCanvas<std::uint8_t> canvas;
          render::draw_triangles_u8_scalar(
              make_job(one, skin, colors.table, true),
              {canvas.pixels.data(), canvas.depth.data(), kModelCanvasWidth, 0, 0, kModelCanvasHeight});
          for (std::size_t i = 0; i < writes.size(); ++i) writes[i] += canvas.depth[i] != kUntouched;
        }
      }
    for (int y = 0; y < kModelCanvasHeight; ++y)
      for (int x = 0; x < kModelCanvasWidth; ++x) {
        const bool inside = x >= 4 && x < 4 + 81 && y >= 3 && y < 3 + 54;
        ASSERT_EQ(writes[static_cast<std::size_t>(y * kModelCanvasWidth + x)], inside ? 1 : 0)
            << "seed " << seed << " pixel " << x << " " << y;
      }
  }
}

// The values at a pixel, by barycentric weights in double.
struct AtPixel {
  double depth, s, t, affine_s, affine_t;
};
AtPixel reference_at(const Mesh& mesh, int x, int y) {
  const ScreenVertex* v = mesh.vertices.data();
  double weight[3];
  const auto area = static_cast<double>(cross(v[0], v[1], v[2].x, v[2].y));
  for (int i = 0; i < 3; ++i)
    weight[i] = static_cast<double>(cross(v[(i + 1) % 3], v[(i + 2) % 3], x * 256, y * 256)) / area;
  AtPixel at{};
  for (std::size_t i = 0; i < 3; ++i) {
    at.depth += weight[i] * v[i].depth;
    at.s += weight[i] * v[i].depth * mesh.texels[i].s;
    at.t += weight[i] * v[i].depth * mesh.texels[i].t;
    at.affine_s += weight[i] * mesh.texels[i].s;
    at.affine_t += weight[i] * mesh.texels[i].t;
  }
  at.s /= at.depth;
  at.t /= at.depth;
  return at;
}

TEST(TriangleKernels, DepthAndTexelsAreWithinTheirErrors) {
  // Skins that show s, and t.
  std::vector<std::uint8_t> s_skin(kSkinWidth * kSkinHeight), t_skin = s_skin;
  for (int i = 0; i < kSkinWidth * kSkinHeight; ++i) {
    s_skin[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i % kSkinWidth);
    t_skin[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i / kSkinWidth);
  }
  std::vector<std::uint8_t> identity(64 * 256);
  for (std::size_t i = 0; i < identity.size(); ++i) identity[i] = static_cast<std::uint8_t>(i);
  std::size_t compared = 0;
  for (int seed = 0; seed < effort(400, 60); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Mesh mesh = random_mesh(random, 1);
    const float least = std::min({mesh.vertices[0].depth, mesh.vertices[1].depth, mesh.vertices[2].depth});
    const float most = std::max({mesh.vertices[0].depth, mesh.vertices[1].depth, mesh.vertices[2].depth});
    for (const bool perspective : {false, true}) {
      TriangleCanvas<std::uint8_t> s_canvas, t_canvas;
      render::draw_triangles_u8_scalar(
          make_job(mesh, s_skin, identity, perspective),
          {s_canvas.pixels.data(), s_canvas.depth.data(), kModelCanvasWidth, 0, 0, kModelCanvasHeight});
      render::draw_triangles_u8_scalar(
          make_job(mesh, t_skin, identity, perspective),
          {t_canvas.pixels.data(), t_canvas.depth.data(), kModelCanvasWidth, 0, 0, kModelCanvasHeight});
      for (int y = 0; y < kModelCanvasHeight; ++y)
        for (int x = 0; x < kModelCanvasWidth; ++x) {
          const auto i = static_cast<std::size_t>(y * kModelCanvasWidth + x);
          if (s_canvas.depth[i] == kUntouched) continue;
          ++compared;
          const AtPixel at = reference_at(mesh, x, y);
          // Depth: a millionth of the triangle's range, and of itself.
          ASSERT_NEAR(s_canvas.depth[i], at.depth, 2e-6 * (most - least) + 2e-7 * at.depth)
              << "seed " << seed;
          // Texels: those at the exact coordinate, or up to half a texel away where the affine error allows
          // it.
          const double error = perspective ? render::kAffineErrorTexels + 0.03 : 0.01;
          const double s = perspective ? at.s : at.affine_s, t = perspective ? at.t : at.affine_t;
          ASSERT_GE(s_canvas.pixels[i] + 1 + error, s) << "seed " << seed;
          ASSERT_LE(s_canvas.pixels[i] - error, s) << "seed " << seed;
          ASSERT_GE(t_canvas.pixels[i] + 1 + error, t) << "seed " << seed;
          ASSERT_LE(t_canvas.pixels[i] - error, t) << "seed " << seed;
        }
    }
  }
  EXPECT_GT(compared, static_cast<std::size_t>(effort(10000, 1000)));
}

template <typename Pixel, auto Plain, auto Vector>
void expect_twins() {
  const auto skin = numbered_skin();
  const Colors<Pixel> colors;
  for (int seed = 0; seed < effort(150, 15); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Mesh mesh = random_mesh(random, 300, seed % 3 == 0);
    render::TriangleJob job = make_job(mesh, skin, colors.table, seed % 2 == 0);
    job.has_short_rows = seed % 4 < 2;
    job.always_perspective = seed % 5 == 0;
    TriangleCanvas<Pixel> expected, drawn;
    // In two bands; SIMD draws only one of them.
    const int middle = static_cast<int>(random.below(kModelCanvasHeight));
    Plain(job, {expected.pixels.data(), expected.depth.data(), kModelCanvasWidth, 0, 0, kModelCanvasHeight});
    draw_fronts<Vector>(job, {drawn.pixels.data(), drawn.depth.data(), kModelCanvasWidth, 0, 0, middle});
    draw_fronts<Vector>(
        job, {drawn.pixels.data(), drawn.depth.data(), kModelCanvasWidth, 0, middle, kModelCanvasHeight});
    ASSERT_TRUE(expected == drawn) << "seed " << seed;
  }
}

TEST(TriangleKernels, SimdMatchesTheScalarReference) {
  for_each_simd_target([] {
    expect_twins<std::uint8_t, render::draw_triangles_u8_scalar, render::draw_triangles_u8_simd>();
    expect_twins<std::uint32_t, render::draw_triangles_u32_scalar, render::draw_triangles_u32_simd>();
  });
}

TEST(TriangleKernels, SimdFindsTheSameFrontTriangles) {
  const auto skin = numbered_skin();
  const Colors<std::uint8_t> colors;
  for_each_simd_target([&] {
    for (int seed = 0; seed < effort(300, 50); ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      Mesh mesh = random_mesh(random, static_cast<int>(random.below(70)), seed % 3 == 0);
      for (ScreenVertex& vertex : mesh.vertices) {
        if (random.chance(0.05)) vertex.x = random.chance(0.5) ? 65536 * 256 : -65536 * 256;
        if (random.chance(0.05)) vertex.y = random.chance(0.5) ? 65536 * 256 : -65536 * 256;
      }
      const render::TriangleJob job = make_job(mesh, skin, colors.table, true);
      const Fronts expected = find_fronts<render::find_front_triangles_scalar>(job);
      const Fronts found = find_fronts<render::find_front_triangles_simd>(job);
      ASSERT_EQ(found.found.count, expected.found.count) << "seed " << seed;
      for (std::size_t i = 0; i < found.found.count; ++i) {
        ASSERT_EQ(found.numbers[i], expected.numbers[i]) << "seed " << seed;
        ASSERT_EQ(found.rows[i].first, expected.rows[i].first) << "seed " << seed;
        ASSERT_EQ(found.rows[i].end, expected.rows[i].end) << "seed " << seed;
      }
    }
  });
}

// Coordinates at the limits of projection, and NaN, never write outside the picture's memory.
TEST(TriangleKernels, WriteOnlyToThePicture) {
  const auto skin = numbered_skin();
  const Colors<std::uint32_t> colors;
  for (int seed = 0; seed < effort(300, 50); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Mesh mesh = random_mesh(random, 20);
    for (ScreenVertex& vertex : mesh.vertices) {
      if (random.chance(0.2)) vertex.x = random.chance(0.5) ? 65536 * 256 : -65536 * 256;
      if (random.chance(0.2)) vertex.y = random.chance(0.5) ? 65536 * 256 : -65536 * 256;
      if (random.chance(0.05)) vertex.depth = random.chance(0.5) ? HUGE_VALF : std::nanf("");
      if (random.chance(0.05)) vertex.light = random.chance(0.5) ? -HUGE_VALF : std::nanf("");
    }
    TriangleCanvas<std::uint32_t> canvas;
    const render::TriangleTarget target{canvas.pixels.data(), canvas.depth.data(), kModelCanvasWidth, 0, 5,
                                        kModelCanvasHeight};
    render::draw_triangles_u32_scalar(make_job(mesh, skin, colors.table, true), target);
    draw_fronts<render::draw_triangles_u32_simd>(make_job(mesh, skin, colors.table, true), target);
    for (std::size_t i = 0; i < canvas.pixels.size(); ++i) {
      const bool is_outside = i < 5 * kModelCanvasWidth || i >= kModelCanvasWidth * kModelCanvasHeight;
      ASSERT_TRUE(!is_outside || canvas.pixels[i] == 77) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace temblor::test
