// A map made to show the usual faults of light at seams, in corners and beside thin walls, compared with
// light that is computed from its brushes alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "compiler/light/lit_map.h"
#include "math/vec.h"
#include "support/effort.h"
#include "support/levels/room_map.h"
#include "world/face_at.h"
#include "world/level.h"

namespace temblor::test {
namespace {

using math::Vec3d;

struct HalfSpace {
  Vec3d normal{0.0};  // outward
  double distance = 0;
};
struct Solid {
  std::vector<HalfSpace> sides;
  std::string texture = "stone";
  std::string alignment = "0 0 0 1 1";  // as the .map has it: offsets, degrees, scales
};
struct Lamp {
  Vec3d place_world{0.0};
  double value = 0;
};

Solid box(const Vec3d& mins, const Vec3d& maxs) {
  Solid solid;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d normal(0.0);
    normal[axis] = 1;
    solid.sides.push_back({normal, maxs[axis]});
    solid.sides.push_back({-normal, -mins[axis]});
  }
  return solid;
}

Solid cut(Solid solid, const Vec3d& normal, const Vec3d& through) {
  const Vec3d unit = glm::normalize(normal);
  solid.sides.push_back({unit, glm::dot(unit, through)});
  return solid;
}

std::string brush_text(const Solid& solid) {
  std::string text = "{\n";
  for (const HalfSpace& side : solid.sides) {
    const Vec3d point = side.normal * side.distance;
    const Vec3d beside = std::abs(side.normal.z) > 0.9 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
    const Vec3d u = glm::normalize(glm::cross(beside, side.normal)) * 64.0;
    const Vec3d w = glm::cross(u, side.normal);
    for (const Vec3d& corner : {point, point + u, point + w})
      text += fmt::format("( {:.6f} {:.6f} {:.6f} ) ", corner.x, corner.y, corner.z);
    text += fmt::format("{} {}\n", solid.texture, solid.alignment);
  }
  return text + "}\n";
}

// The share of a segment at which it enters a solid; nothing if it does not.
bool is_blocked(const Solid& solid, const Vec3d& from, const Vec3d& to) {
  double enter = 0, leave = 1;
  for (const HalfSpace& side : solid.sides) {
    const double a = glm::dot(side.normal, from) - side.distance;
    const double b = glm::dot(side.normal, to) - side.distance;
    if (a >= 0 && b >= 0) return false;
    if (a > 0) enter = std::max(enter, a / (a - b));
    if (b > 0) leave = std::min(leave, a / (a - b));
  }
  return enter < leave;
}

struct TestMap {
  std::vector<Solid> world, detail;
  std::vector<Lamp> lamps;

  bool is_clear(const Vec3d& from, const Vec3d& to) const {
    const auto blocks = [&](const Solid& solid) { return is_blocked(solid, from, to); };
    return std::none_of(world.begin(), world.end(), blocks) &&
           std::none_of(detail.begin(), detail.end(), blocks);
  }
  struct Light {
    double value = 0;    // in steps of the light map
    unsigned lamps = 0;  // a bit for each that shines there
  };
  // The formula of linear lights.
  Light sample_light(const Vec3d& point, const Vec3d& normal) const {
    Light light;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      const Lamp& lamp = lamps[i];
      const Vec3d way = lamp.place_world - point;
      const double distance = glm::length(way), cosine = glm::dot(way, normal) / distance;
      if (cosine <= 0 || !is_clear(point, lamp.place_world)) continue;
      if (distance >= lamp.value) continue;
      light.value += (lamp.value - distance) * (0.5 + 0.5 * cosine) * 0.5;
      light.lamps |= 1u << i;
    }
    light.value = std::min(255.0, light.value);
    return light;
  }
};

// A floor of tiles that have nothing in common but their plane.
void add_floor(std::vector<Solid>& io_world) {
  constexpr std::array<const char*, 5> kAlignments{"0 0 0 1 1", "5 11 0 1 1", "0 0 30 1 1", "3 3 45 1 1",
                                                   "0 0 0 0.5 1.5"};
  const std::vector<std::vector<double>> rows{
      {-320, -190, -70, 100, 320}, {-320, -230, 20, 210, 320}, {-320, -100, 60, 320}};
  const std::array<double, 4> y{-192, -50, 77, 192};
  std::size_t tile = 0;
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t i = 0; i + 1 < rows[row].size(); ++i, ++tile) {
      Solid solid = box({rows[row][i], y[row], -16}, {rows[row][i + 1], y[row + 1], 0});
      solid.texture = fmt::format("tile{}", tile % 3);
      solid.alignment = kAlignments[tile % kAlignments.size()];
      io_world.push_back(std::move(solid));
    }
}

TestMap make_test_map() {
  TestMap map;
  add_floor(map.world);
  for (const auto& [mins, maxs] : std::vector<std::pair<Vec3d, Vec3d>>{
           {{-320, -192, 192}, {320, 192, 208}},   // ceiling
           {{-336, -192, -16}, {-320, 192, 208}},  // walls
           {{320, -192, -16}, {336, 192, 208}},
           {{-336, -208, -16}, {336, -192, 208}},
           {{-336, 192, -16}, {336, 208, 208}},
           {{-4, -192, 0}, {4, 96, 192}},      // a thin wall, open at one end
           {{200, -192, 0}, {208, -80, 192}},  // two more, around a closet without a door
           {{208, -88, 0}, {320, -80, 192}},
           {{-300, -180, 0}, {-200, -100, 16}}})  // a step
    map.world.push_back(box(mins, maxs));
  map.world.push_back(cut(box({-300, 60, 0}, {-172, 150, 80}), {-0.5, 0, 1}, {-300, 60, 0}));  // a slope
  map.detail.push_back(box({-166, -76, 0}, {-134, -44, 192}));
  Solid turned = box({60, 60, 0}, {120, 120, 100});
  for (const Vec3d& way : {Vec3d(1, 1, 0), Vec3d(1, -1, 0), Vec3d(-1, 1, 0), Vec3d(-1, -1, 0)})
    turned = cut(std::move(turned), way, Vec3d(90, 90, 0) + way * 16.0);
  map.detail.push_back(std::move(turned));
  map.lamps = {{{-160, 10, 120}, 300}, {{-60, 140, 60}, 200}, {{-12, -100, 40}, 250}, {{150, 170, 150}, 150}};
  return map;
}

std::string get_text(const TestMap& map) {
  std::string brushes, detail;
  for (const Solid& solid : map.world) brushes += brush_text(solid);
  for (const Solid& solid : map.detail) detail += brush_text(solid);
  std::string text = entity_text("worldspawn", "", brushes) + entity_text("func_detail", "", detail) +
                     point_text("info_player_start", {-250, 0, 40}) +
                     point_text("info_null", {260, -130, 60});
  for (const Lamp& lamp : map.lamps)
    text += entity_text("light", fmt::format("\"origin\" \"{} {} {}\"\n\"light\" \"{}\"", lamp.place_world.x,
                                             lamp.place_world.y, lamp.place_world.z, lamp.value));
  return text;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  unsigned some = 0, all = ~0u;  // a bit for each lamp that shines somewhere, and everywhere

  bool has_shadow_edge() const { return some != all; }
};

// The least and the most light within a distance of a point in its plane, as far as one can go there.
Range light_around(const TestMap& map, const Vec3d& place, const Vec3d& normal, double radius) {
  const Vec3d beside = std::abs(normal.z) > 0.9 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
  const Vec3d u = glm::normalize(glm::cross(beside, normal)), w = glm::cross(u, normal);
  const Vec3d lifted = place + normal;
  Range range;
  constexpr double kStep = 4;
  for (double x = -radius; x <= radius; x += kStep)
    for (double y = -radius; y <= radius; y += kStep) {
      const Vec3d point = lifted + u * x + w * y;
      if (x * x + y * y > radius * radius || !map.is_clear(lifted, point)) continue;
      const TestMap::Light light = map.sample_light(point, normal);
      range = {std::min(range.low, light.value), std::max(range.high, light.value), range.some | light.lamps,
               range.all & light.lamps};
    }
  return range;
}

// Points of a face on a grid, at some distance from its edges.
std::vector<Vec3d> points_on(const world::Level& level, const world::Face& face, double step, double inside) {
  std::vector<Vec3d> corners;
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i)
    corners.emplace_back(level.vertices[level.surfedge_start(std::size_t{face.first_surfedge} + i)]);
  const Vec3d normal = world::compute_face_plane(level, face).normal;
  Vec3d mins = corners[0], maxs = corners[0];
  for (const Vec3d& corner : corners) {
    mins = glm::min(mins, corner);
    maxs = glm::max(maxs, corner);
  }
  const Vec3d beside = std::abs(normal.z) > 0.9 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
  const Vec3d u = glm::normalize(glm::cross(beside, normal)), w = glm::cross(u, normal);
  const double reach = glm::length(maxs - mins) / 2;
  const Vec3d middle = corners[0] + ((mins + maxs) * 0.5 - corners[0]) -
                       normal * glm::dot((mins + maxs) * 0.5 - corners[0], normal);
  std::vector<Vec3d> points;
  for (double x = -reach; x <= reach; x += step)
    for (double y = -reach; y <= reach; y += step) {
      const Vec3d point = middle + u * x + w * y;
      bool is_inside = true;
      for (std::size_t i = 0; i < corners.size() && is_inside; ++i) {
        const Vec3d way = corners[(i + 1) % corners.size()] - corners[i];
        // Clockwise, seen from the front.
        is_inside = glm::dot(glm::cross(glm::normalize(way), point - corners[i]), normal) < -inside;
      }
      if (is_inside) points.push_back(point);
    }
  return points;
}

// A luxel stands for every 16 units (24 if the texture is stretched) and is the mean of the square around it.
// So the light that is shown comes from within that distance, and half a step, along each axis.
constexpr double kFootprint = 1.5 * 16 * 1.42, kStretchedFootprint = kFootprint * 1.5;
constexpr double kSteps = 2.5;  // of 255

bool is_stretched(const world::Level& level, const world::Face& face) {
  return glm::length(level.texture_axes[face.axes].t_axis) < 0.9f;
}

TEST(LightCorners, ShownLightIsWithinTheComputedLight) {
  const TestMap map = make_test_map();
  for (const int extra : {1, effort(4, 2)}) {
    const auto level = lit_map(get_text(map), {{.extra = extra}, {}});
    int dark = 0, lit = 0, edges = 0;
    for (const world::Face& face : level->faces) {
      const Vec3d normal = world::compute_face_plane(*level, face).normal;
      const double radius = is_stretched(*level, face) ? kStretchedFootprint : kFootprint;
      for (const Vec3d& place : points_on(*level, face, effort(14, 40), 1.5)) {
        const Range range = light_around(map, place, normal, radius);
        const double shown = shown_light(*level, face, place).x;
        // Where no line reaches a lamp, there is no light at all.
        const double more = range.high == 0 ? 0 : kSteps;
        ASSERT_TRUE(shown >= range.low - kSteps && shown <= range.high + more)
            << fmt::format("extra {}: {} where it is {} to {}, at {} {} {}, facing {} {} {}", extra, shown,
                           range.low, range.high, place.x, place.y, place.z, normal.x, normal.y, normal.z);
        ++(range.high == 0 ? dark : range.low > 0 ? lit : edges);
      }
    }
    EXPECT_GT(dark, effort(2000, 150));
    EXPECT_GT(lit, effort(2000, 150));
    EXPECT_GT(edges, effort(300, 30));
  }
}

constexpr double kSeamSteps = 4;

// Faces of one plane that meet show the same light on both sides of their seam, whatever cut them and however
// their textures are aligned: within kSeamSteps, and at the edge of a shadow, which two grids sample
// differently, within half of its height.
TEST(LightCorners, NoStripesBetweenFacesOfOnePlane) {
  const TestMap map = make_test_map();
  const auto level = lit_map(get_text(map));
  int seams = 0, at_shadows = 0;
  for (std::size_t a = 0; a < level->faces.size(); ++a)
    for (std::size_t b = a + 1; b < level->faces.size(); ++b) {
      const world::Face &one = level->faces[a], &other = level->faces[b];
      if (one.plane != other.plane || one.back_side != other.back_side) continue;
      const Vec3d normal = world::compute_face_plane(*level, one).normal;
      for (const Vec3d& place : points_on(*level, one, 1.5, 0.5)) {
        if (glm::length(world::find_nearest_point(*level, other, place) - place) > 2) continue;
        const Range range = light_around(map, place, normal, kStretchedFootprint);
        const double step = std::abs(shown_light(*level, one, place).x - shown_light(*level, other, place).x);
        ++(range.has_shadow_edge() ? at_shadows : seams);
        EXPECT_LE(step, range.has_shadow_edge() ? (range.high - range.low) / 2 : kSeamSteps)
            << fmt::format("at {} {} {}, light {} to {}", place.x, place.y, place.z, range.low, range.high);
      }
    }
  EXPECT_GT(seams, 300);
  EXPECT_GT(at_shadows, 100);
}

}  // namespace
}  // namespace temblor::test
