#include "compiler/light/lighting.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/matrix.hpp>
#include <limits>
#include <ostream>
#include <utility>

#include "artgen/small_level.h"
#include "compiler/drafts.h"
#include "compiler/light/light_cache.h"
#include "formats/levels/entities.h"
#include "support/levels/bsp_faces.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using math::Vec3d;

std::string with_double_quotes(std::string text) {
  std::replace(text.begin(), text.end(), '\'', '"');
  return text;
}

// How far a place is inside the corners' bounding box, ignoring the axis along `normal`.
double depth_inside(const std::vector<math::Vec3>& corners, const Vec3d& normal, const Vec3d& place) {
  math::Vec3 mins = corners[0], maxs = corners[0];
  for (const math::Vec3& corner : corners) mins = glm::min(mins, corner), maxs = glm::max(maxs, corner);
  double depth = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    if (normal[axis] == 0)
      depth = std::min({depth, place[axis] - double{mins[axis]}, double{maxs[axis]} - place[axis]});
  return depth;
}

}  // namespace

LitResult light(formats::Bsp bsp, const compiler::LightOptions& options, int threads,
                compiler::LightCache* io_cache) {
  LitResult result;
  const auto entities = formats::read_entities(bsp.entities);
  const compiler::FaceKeys keys = compiler::find_face_keys(bsp, entities.value());
  base::Jobs jobs(threads, base::JobBackend::kStdThread);
  result.bsp = std::move(bsp);
  result.summary = compiler::light_level(
                       result.bsp, keys, options, jobs, [](std::size_t, std::size_t) { return true; },
                       result.warnings, io_cache)
                       .value();
  return result;
}

formats::Bsp room_with(const RoomSetup& setup) {
  constexpr double kSkyDepth = 16;
  Vec3d maxs(kHalfRoom);
  std::string brushes;
  if (setup.sky) {
    brushes =
        box_text({-kHalfRoom, -kHalfRoom, kHalfRoom}, {kHalfRoom, kHalfRoom, kHalfRoom + kSkyDepth}, "sky1");
    maxs.z += kSkyDepth;
  }
  brushes += walls_text(Vec3d(-kHalfRoom), maxs, "wall");
  const std::string world = entity_text("worldspawn", setup.world_keys, brushes);
  // The outside is filled only if there is an entity inside.
  const std::string start = point_text("info_player_start", Vec3d(0.0));
  return compile_draft(with_double_quotes(world + setup.entities + start)).draft.bsp;
}

Vec3d luxel_place(const world::Level& level, const world::Face& face, int column, int row) {
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  const world::FacePlane plane = world::compute_face_plane(level, face);
  const glm::dmat3 rows = glm::transpose(glm::dmat3(Vec3d(axes.s_axis), Vec3d(axes.t_axis), plane.normal));
  return glm::inverse(rows) * Vec3d(face.texture_mins[0] + 16.0 * column - double{axes.s_offset},
                                    face.texture_mins[1] + 16.0 * row - double{axes.t_offset},
                                    plane.distance);
}

std::vector<RoomLuxel> room_luxels(const LitResult& lit, std::uint8_t style, double margin) {
  const auto level = world::make_level(lit.bsp, "room").value();
  std::vector<RoomLuxel> luxels;
  for (std::size_t i = 0; i < level->faces.size(); ++i) {
    const world::Face& face = level->faces[i];
    if (face.kind == world::FaceKind::kSky) continue;
    const auto corners = list_vertices(lit.bsp, lit.bsp.faces[i]);
    const Vec3d normal = world::compute_face_plane(*level, face).normal;
    const auto found = std::ranges::find(face.styles, style);
    const bool has_light = face.light != world::kNoLight && found != face.styles.end();
    const int luxels_of_style = face.light_width() * face.light_height();
    const auto luxels_before = static_cast<int>(found - face.styles.begin()) * luxels_of_style;
    for (int row = 0; row < face.light_height(); ++row)
      for (int column = 0; column < face.light_width(); ++column) {
        const Vec3d place = luxel_place(*level, face, column, row);
        if (depth_inside(corners, normal, place) < margin) continue;
        RoomLuxel& luxel = luxels.emplace_back();
        luxel.of_world = i < level->world().face_count;
        luxel.place_world = place + normal;
        luxel.normal = normal;
        if (!has_light) continue;
        const std::size_t sample =
            face.light + static_cast<std::size_t>(luxels_before + row * face.light_width() + column);
        luxel.gray = luxel.rgb[0] = luxel.rgb[1] = luxel.rgb[2] = level->light.at(sample);
        if (lit.summary.colored)
          std::copy_n(lit.summary.lit.samples.begin() + static_cast<std::ptrdiff_t>(sample * 3), 3,
                      luxel.rgb.begin());
      }
  }
  return luxels;
}

LitResult light_in_all_ways(const std::string& world_keys, const std::string& entities) {
  formats::Bsp bsp = artgen::make_small_level({.light = false});
  bsp.entities.insert(bsp.entities.find('}'),
                      world_keys + " \"_bounce\" \"1\" \"_dirt\" \"1\" \"_sunlight\" \"100\"");
  bsp.entities += "{ \"classname\" \"light\" \"origin\" \"0 0 64\" \"_color\" \"1 0.5 0\" }" + entities;
  const compiler::LightOptions options{.sky_rays = 8, .directions = true};
  LitResult once = light(bsp, options);
  EXPECT_EQ(light(bsp, options, 3).bsp, once.bsp);
  compiler::LightCache cache;
  EXPECT_EQ(light(bsp, options, 1, &cache).bsp, once.bsp);
  EXPECT_EQ(light(bsp, options, 1, &cache).bsp, once.bsp);
  EXPECT_EQ(light(once.bsp, options).bsp, once.bsp);

  const auto keys = compiler::find_face_keys(bsp, formats::read_entities(bsp.entities).value());
  base::Jobs jobs(1);
  compiler::Warnings warnings;
  std::vector<base::ByteVector> shards;
  for (std::uint32_t i = 0; i < 3; ++i)
    shards.push_back(
        compiler::light_shard(bsp, keys, options, {i, 3}, {}, jobs, compiler::kIgnoreProgress).value().bytes);
  formats::Bsp merged = bsp;
  EXPECT_TRUE(
      compiler::merge_light(merged, keys, options, {{{shards[0]}, {shards[1]}, {shards[2]}}}, jobs, warnings)
          .ok());
  EXPECT_EQ(merged, once.bsp);
  return once;
}

std::ostream& operator<<(std::ostream& io_stream, const RoomLuxel& luxel) {
  const Vec3d &at = luxel.place_world, &toward = luxel.normal;
  return io_stream << fmt::format("at {} {} {}, facing {} {} {}", at.x, at.y, at.z, toward.x, toward.y,
                                  toward.z);
}

}  // namespace temblor::test
