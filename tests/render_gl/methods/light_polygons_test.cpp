// Dynamic lights as polygons (WorldMethod::kLightPolygons): the light of the polygons, and the CPU's
// pictures.
#include "render_gl/passes/light_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_gl/methods/method_views.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::render_gl {
namespace {

// The shares of a triangle's corners at a point of its plane; one is negative outside of it.
std::array<double, 3> find_shares(const LightCorner* corners, const math::Vec3d& point) {
  const math::Vec3d a(corners[0].position), b(corners[1].position), c(corners[2].position);
  const math::Vec3d normal = glm::cross(b - a, c - a);
  const double area = glm::dot(normal, normal);
  if (area < 1e-9) return {-1, -1, -1};
  return {glm::dot(glm::cross(c - b, point - b), normal) / area,
          glm::dot(glm::cross(a - c, point - c), normal) / area,
          glm::dot(glm::cross(b - a, point - a), normal) / area};
}

struct FoundLight {
  int triangles = 0;  // that have the point inside
  double light = 0;
};

FoundLight find_light(const std::vector<LightCorner>& triangles, const math::Vec3d& point) {
  FoundLight found;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::array<double, 3> shares = find_shares(&triangles[i], point);
    if (*std::ranges::min_element(shares) <= 0) continue;
    ++found.triangles;
    for (std::size_t corner = 0; corner < 3; ++corner)
      found.light += shares[corner] * double{triangles[i + corner].light};
  }
  return found;
}

// A random point between the corners of a face.
math::Vec3d any_point(std::span<const render::OutlineCorner> corners, test::Random& io_random) {
  math::Vec3d sum(0.0);
  double weights = 0;
  for (const render::OutlineCorner& corner : corners) {
    const double weight = io_random.uniform(0.01, 1);
    sum += math::Vec3d(corner.position) * weight;
    weights += weight;
  }
  return sum / weights;
}

TEST(GlLightPolygonShapes, HaveTheLightOfTheirFace) {
  const test::DrawableLevel drawable = test::small_level({.wide_faces = true}, "wide");
  const world::Level& level = *drawable.level;
  const render::FaceOutlines outlines = render::make_face_outlines(level);
  test::Random random(1);
  std::vector<LightCorner> triangles;
  int inside = 0, outside = 0;
  for (std::size_t number = 0; number < level.faces.size(); ++number) {
    const world::Face& face = level.faces[number];
    if (!render::has_surface(face)) continue;
    const render::FaceOutline& outline = outlines.faces[number];
    const auto corners = std::span(outlines.corners).subspan(outline.first_corner, outline.corner_count);
    const render::FacePlacement placed = render::place_face(level, face, render::ModelView{});
    const math::Vec3d origin = any_point(corners, random) + placed.normal * random.uniform(-60, 60);
    const auto light = render::light_on_face({.origin_world = math::Vec3(origin), .radius = 150, .least = 20},
                                             placed, false);
    if (!light) continue;
    triangles.clear();
    for (int t = 0; t < outline.tiles.t; ++t)
      for (int s = 0; s < outline.tiles.s; ++s)
        add_light_polygons({level, face, corners, s, t}, *light, triangles);
    for (int i = 0; i < 20; ++i) {
      const math::Vec3d point = any_point(corners, random);
      const double s = glm::dot(placed.s_axis, point) + placed.s_offset;
      const double t = glm::dot(placed.t_axis, point) + placed.t_offset;
      const double distance = render::distance_on_face(*light, static_cast<float>(s), static_cast<float>(t));
      if (std::abs(distance - light->reach) < 0.1) continue;
      const FoundLight found = find_light(triangles, point);
      const bool is_inside = distance < light->reach;
      EXPECT_EQ(found.triangles, is_inside ? 1 : 0) << "face " << number;
      if (is_inside) {
        EXPECT_NEAR(found.light, light->at_nearest - distance, 0.1) << "face " << number;
      }
      ++(is_inside ? inside : outside);
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(outside, 200);
}

// Measured 0.96 to 0.99 within 2 of 255, and 0.997 or more within 10. The rest lies at the rims of lights,
// and at the middle of near ones, where 16 texels between samples are far.
void check_light_polygons(RendererPair& pair, const test::DrawableLevel& drawable, int views,
                          const ViewContents& contents) {
  EXPECT_GE(compare_views(pair, drawable, WorldMethod::kLightPolygons, views, contents).mean,
            test::kQuick ? 0.8 : 0.94);
  EXPECT_GE(compare_views(pair, drawable, WorldMethod::kLightPolygons, views, contents, 10).mean,
            test::kQuick ? 0.95 : 0.99);
}

// Without lights, only the order of the passes differs from kLightPass.
TEST(GlLightPolygons, ShowTheCpusPictureWithoutLights) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  const EqualShares shares = compare_views(
      pair, drawable, WorldMethod::kLightPolygons, test::effort(16, 8),
      {.lights = 0, .with_marks = true, .with_fog = true, .with_opacity = true, .with_styles = true});
  EXPECT_GE(shares.mean, test::kQuick ? 0.99 : 0.998);
  EXPECT_GE(shares.worst, 0.99);
}

TEST(GlLightPolygons, ShowDynamicLights) {
  const test::DrawableLevel small = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, small);
  check_light_polygons(pair, small, test::effort(20, 3),
                       {.with_marks = true, .with_fog = true, .with_opacity = true});
  check_light_polygons(pair, small, test::effort(20, 3), {.with_turns = true});
  const test::DrawableLevel wide = test::small_level({.wide_faces = true, .colored_light = true}, "wide");
  RENDERER_PAIR_OR_SKIP(wide_pair, wide, ClipControl::kNo);
  check_light_polygons(wide_pair, wide, test::effort(10, 3), {});
}

TEST(GlLightPolygons, ShowDynamicLightsOfStockLevels) {
  DATA_FOLDER_OR_SKIP(data);
  for (const char* name : {"start", "lq_e1m2"}) {
    const test::DrawableLevel level = test::stock_level(data, name);
    RENDERER_PAIR_OR_SKIP(pair, level);
    check_light_polygons(pair, level, test::effort(20, 2), {});
  }
}

// A light that moves uploads its polygons, and no grid of light.
TEST(GlLightPolygons, UploadPolygonsOnly) {
  const test::DrawableLevel drawable = test::small_level();
  RENDERER_PAIR_OR_SKIP(pair, drawable);
  pair.gl().set_method(WorldMethod::kLightPolygons);
  NumberedView view(*drawable.level, 1, {.lights = 0});
  const auto count_uploads = [&] {
    pair.compare(view.scene, {});
    return pair.gl().cache_counts().uploads;
  };
  EXPECT_GT(count_uploads(), 1u);
  EXPECT_EQ(count_uploads(), 0u);
  std::array<render::DynamicLight, 1> light = {
      render::DynamicLight{.origin_world = view.viewpoint.camera.origin_world, .radius = 200}};
  view.scene.lights = light;
  EXPECT_EQ(count_uploads(), 1u);
  light.front().origin_world.x += 8;
  EXPECT_EQ(count_uploads(), 1u);
}

}  // namespace
}  // namespace temblor::render_gl
