#include "compiler/textures/texture_axes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "base/text.h"
#include "support/game_data.h"
#include "support/levels/bsp_faces.h"
#include "support/random.h"

namespace temblor::compiler {
namespace {

using formats::MapAlignment;
using formats::MapTexturing;
using math::Vec2d;
using math::Vec3d;

constexpr Vec2d kSize(64, 32);

MapTexturing standard(Vec2d offset, double rotation_deg, Vec2d scale) {
  MapTexturing texturing;
  texturing.offset = offset;
  texturing.rotation_deg = rotation_deg;
  texturing.scale = scale;
  return texturing;
}

void expect_near(const Vec3d& got, const Vec3d& expected) {
  EXPECT_LT(glm::length(got - expected), 1e-12) << got.x << ' ' << got.y << ' ' << got.z << ", expected "
                                                << expected.x << ' ' << expected.y << ' ' << expected.z;
}

// How an upright viewer sees the side: on walls, t goes down and s along x or y; on floors and ceilings, s
// goes along x and t along -y.
TEST(TextureAxes, StandardAlignmentOfTheSixDirections) {
  struct {
    Vec3d normal, s, t;
  } const cases[] = {
      {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}}, {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
      {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
      {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
  };
  for (const auto& [normal, s, t] : cases) {
    const SideAxes got = make_side_axes(MapTexturing{}, normal, kSize);
    EXPECT_FALSE(got.replaced);
    EXPECT_EQ(got.axes.s_axis, s);
    EXPECT_EQ(got.axes.t_axis, t);
  }
}

TEST(TextureAxes, StandardAlignmentTakesTheNearestDirectionFloorsFirst) {
  const auto s_axis = [](const Vec3d& normal) {
    return make_side_axes(MapTexturing{}, glm::normalize(normal), kSize).axes.s_axis;
  };
  EXPECT_EQ(s_axis({0.6, 0, 0.8}), Vec3d(1, 0, 0));
  EXPECT_EQ(s_axis({0.8, 0, 0.6}), Vec3d(0, 1, 0));
  // At 45 degrees, floors come before walls and x before y, whatever the last bit of the normal.
  for (const double off : {-1e-9, 0.0, 1e-9}) {
    EXPECT_EQ(s_axis({1 + off, 0, 1}), Vec3d(1, 0, 0));
    EXPECT_EQ(s_axis({1, 1 + off, 0}), Vec3d(0, 1, 0));
    EXPECT_EQ(s_axis({-1, -1 - off, 0}), Vec3d(0, 1, 0));
  }
}

TEST(TextureAxes, StandardRotationScaleAndOffset) {
  const TextureAxes floor = make_side_axes(standard({16, -8}, 90, {2, 0.5}), {0, 0, 1}, kSize).axes;
  EXPECT_EQ(floor.s_axis, Vec3d(0, 0.5, 0));  // exact, since it is a quarter turn
  EXPECT_EQ(floor.t_axis, Vec3d(2, 0, 0));
  EXPECT_EQ(floor.at({0, 0, 100}), Vec2d(16, -8));
  EXPECT_EQ(floor.at({4, 4, 0}), Vec2d(18, 0));
  const double half = std::sqrt(0.5);
  const TextureAxes wall = make_side_axes(standard({0, 0}, -45, {-1, 1}), {0, 1, 0}, kSize).axes;
  expect_near(wall.s_axis, {-half, 0, half});
  expect_near(wall.t_axis, {-half, 0, -half});
}

TEST(TextureAxes, ValveAxesAreScaledButNotRotated) {
  MapTexturing texturing = standard({8, 4}, 30, {2, -4});
  texturing.alignment = MapAlignment::kValve;
  texturing.s_axis = {1, 0, 0};
  texturing.t_axis = {0, 0.6, -0.8};
  const SideAxes got = make_side_axes(texturing, {0, -0.8, -0.6}, kSize);
  EXPECT_FALSE(got.replaced);
  expect_near(got.axes.s_axis, {0.5, 0, 0});
  expect_near(got.axes.t_axis, {0, -0.15, 0.2});
  EXPECT_EQ(got.axes.at(Vec3d(0.0)), Vec2d(8, 4));
}

// The two directions are along the parallel and down the meridian, as on a globe.
TEST(TextureAxes, BrushPrimitivesMeasureAlongTheSide) {
  for (const auto& [normal, x, y] :
       std::initializer_list<std::array<Vec3d, 3>>{{Vec3d{1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
                                                   {Vec3d{0, 1, 0}, {-1, 0, 0}, {0, 0, -1}},
                                                   {Vec3d{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},
                                                   {Vec3d{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
                                                   {Vec3d{0.6, 0, 0.8}, {0, 1, 0}, {0.8, 0, -0.6}}}) {
    expect_near(brush_primitive_axes(normal)[0], x);
    expect_near(brush_primitive_axes(normal)[1], y);
  }
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    const Vec3d normal = glm::normalize(Vec3d(random.in_cube(1)));
    const auto [x, y] = brush_primitive_axes(normal);
    EXPECT_LT(std::abs(glm::dot(x, normal)) + std::abs(glm::dot(y, normal)) + std::abs(glm::dot(x, y)),
              1e-12);
    EXPECT_NEAR(glm::length(x) * glm::length(y), 1, 1e-12);
  }
}

TEST(TextureAxes, BrushPrimitivesCountWholeTextures) {
  MapTexturing texturing;
  texturing.alignment = MapAlignment::kBrushPrimitive;
  texturing.matrix = {{{1.0 / 64, 0, 0.5}, {0, 1.0 / 32, -0.25}}};
  const TextureAxes axes = make_side_axes(texturing, {1, 0, 0}, kSize).axes;
  EXPECT_EQ(axes.s_axis, Vec3d(0, 1, 0));
  EXPECT_EQ(axes.t_axis, Vec3d(0, 0, -1));
  EXPECT_EQ(axes.at(Vec3d(0.0)), Vec2d(32, -8));
}

TEST(TextureAxes, ReplacesUnusableAxes) {
  const auto is_replaced = [](const Vec3d& s, const Vec3d& t, Vec2d scale = Vec2d(1, 1)) {
    MapTexturing texturing = standard({0, 0}, 0, scale);
    texturing.alignment = MapAlignment::kValve;
    texturing.s_axis = s;
    texturing.t_axis = t;
    const SideAxes got = make_side_axes(texturing, {0, 0, 1}, kSize);
    if (got.replaced) {
      EXPECT_EQ(got.axes.s_axis, Vec3d(1, 0, 0));
      EXPECT_EQ(got.axes.t_axis, Vec3d(0, -1, 0));
    }
    return got.replaced;
  };
  EXPECT_FALSE(is_replaced({1, 0, 0}, {0.5, 0.5, 8}));
  EXPECT_TRUE(is_replaced({0, 0, 0}, {0, 1, 0}));
  EXPECT_TRUE(is_replaced({1, 0, 0}, {-2, 0, 0}));
  EXPECT_TRUE(is_replaced({1, 0, 0}, {0, 0, 1}));
  EXPECT_TRUE(is_replaced({1, 0, 0}, {0, 1, 0}, {1e-300, 1}));
  EXPECT_TRUE(is_replaced({1, 0, 0}, {0, 1, 0}, {1, 1e300}));
  EXPECT_TRUE(is_replaced({1e300, 0, 0}, {0, 1e300, 0}));
}

TEST(TextureAxes, FarOffsetsLoseWholeRepetitions) {
  const TextureAxes axes = make_side_axes(standard({0x1p40 + 5, -1e300}, 0, {1, 1}), {0, 0, 1}, kSize).axes;
  EXPECT_EQ(axes.s_offset, 5);
  EXPECT_LE(std::abs(axes.t_offset), 16 * kSize.y);
  EXPECT_EQ(make_side_axes(standard({1 << 20, 0}, 0, {1, 1}), {0, 0, 1}, kSize).axes.s_offset, 1 << 20);
}

TEST(TextureAxes, TexinfoHoldsTheSameNumbers) {
  const formats::BspTexinfo texinfo = to_texinfo({{1, 2, 3}, 4, {5, 6, 7}, 8}, 9, 1);
  EXPECT_EQ(texinfo, (formats::BspTexinfo{{1, 2, 3}, 4, {5, 6, 7}, 8, 9, 1}));
}

// The sides of a map, by plane (rounded, so that equal ones match) and texture.
using PlaneKey = std::tuple<long, long, long, long, std::string>;

PlaneKey plane_key(const Vec3d& normal, double distance, const std::string& texture) {
  return {std::lround(normal.x * 1000), std::lround(normal.y * 1000), std::lround(normal.z * 1000),
          std::lround(distance * 10), base::to_lower(texture)};
}

// The distance in texels between two places on a repeating texture.
double gap(double a, double b, double size) {
  return std::abs(std::remainder(a - b, size));
}

// Other tools made the faces of finished levels from the same maps, so some side in the face's plane must
// give each of its corners the same place on the texture.
TEST(TextureAxes, StockLevelsAgree) {
  DATA_FOLDER_OR_SKIP(data);
  std::size_t compared = 0, agreed = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "mapsrc")) {
    const auto level_path = data / "id1" / "maps" / entry.path().stem().replace_extension(".bsp");
    if (!std::filesystem::exists(level_path)) continue;
    SCOPED_TRACE(entry.path().stem());
    const auto map = formats::read_map(base::as_text(test::read_file(entry.path())));
    const auto bsp = formats::read_bsp(test::read_file(level_path));
    ASSERT_TRUE(map.ok() && bsp.ok());

    std::multimap<PlaneKey, const formats::MapSide*> sides;
    for (const formats::MapEntity& entity : map->entities)
      for (const formats::MapBrush& brush : entity.brushes)
        for (const formats::MapSide& side : brush.sides) {
          const auto& p = side.points_world;
          const Vec3d normal = glm::normalize(glm::cross(p[0] - p[1], p[2] - p[1]));
          sides.emplace(plane_key(normal, glm::dot(normal, p[1]), side.texture), &side);
        }

    for (const formats::BspFace& face : bsp->faces) {
      const formats::BspTexinfo& texinfo = bsp->texinfos[face.texinfo];
      if (texinfo.flags != 0) continue;  // sky and liquids: their s and t do not matter
      const formats::BspMiptex& miptex = bsp->miptexes[static_cast<std::size_t>(texinfo.miptex)];
      const double sign = face.side != 0 ? -1 : 1;
      const Vec3d normal = Vec3d(bsp->planes[face.plane].normal) * sign;
      const double distance = double{bsp->planes[face.plane].distance} * sign;
      const auto [first, last] = sides.equal_range(plane_key(normal, distance, miptex.name));
      if (first == last) continue;  // an entity moved to its origin, or the key fell on the next number
      const Vec2d size(miptex.width, miptex.height);
      const auto corners = test::list_vertices(*bsp, face);
      ++compared;
      agreed += std::any_of(first, last, [&, s = &texinfo](const auto& key_and_side) {
        const SideAxes got = make_side_axes(key_and_side.second->texturing, normal, size);
        return std::all_of(corners.begin(), corners.end(), [&](const math::Vec3& corner) {
          const Vec2d ours = got.axes.at(Vec3d(corner));
          const double theirs_s = glm::dot(Vec3d(corner), Vec3d(s->s_axis)) + double{s->s_offset};
          const double theirs_t = glm::dot(Vec3d(corner), Vec3d(s->t_axis)) + double{s->t_offset};
          constexpr double kTexels = 0.02;
          return gap(ours.x, theirs_s, size.x) < kTexels && gap(ours.y, theirs_t, size.y) < kTexels;
        });
      });
    }
  }
  EXPECT_GT(compared, 10000u);
  EXPECT_GE(static_cast<double>(agreed), 0.999 * static_cast<double>(compared));
}

}  // namespace
}  // namespace temblor::compiler
