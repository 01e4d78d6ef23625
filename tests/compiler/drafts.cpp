#include "compiler/drafts.h"

#include <algorithm>
#include <vector>

#include "formats/levels/bsp_validate.h"
#include "support/levels/bsp_faces.h"
#include "support/levels/room_map.h"
#include "world/level.h"

namespace temblor::test {
namespace {

std::string_view texture_name(const formats::Bsp& bsp, const formats::BspFace& face) {
  return bsp.miptexes[static_cast<std::size_t>(bsp.texinfos[face.texinfo].miptex)].name;
}

double measure_face(const formats::Bsp& bsp, const formats::BspFace& face) {
  const std::vector<math::Vec3> corners = list_vertices(bsp, face);
  const math::Vec3d first(corners[0]);
  math::Vec3d sum(0.0);
  for (std::size_t k = 2; k < corners.size(); ++k)
    sum += glm::cross(math::Vec3d(corners[k - 1]) - first, math::Vec3d(corners[k]) - first);
  return glm::length(sum) / 2;
}

}  // namespace

std::string room_text(const std::string& more_brushes) {
  return entity_text("worldspawn", "\"wad\" \"x.wad\"",
                     walls_text(kRoomMins, kRoomMaxs, "wall") + more_brushes) +
         point_text("info_player_start", {0, 0, 32});
}

std::string tiled_pool_text() {
  constexpr double kTile = 16;
  std::string brushes = box_text({-256, -256, -64}, {256, 256, 0}, "*water1");
  for (double at = -256; at < 256; at += kTile)
    for (const double side : {-256 - kTile, 256.0})
      for (const bool along_x : {true, false}) {
        const math::Vec3d mins = along_x ? math::Vec3d(at, side, -64) : math::Vec3d(side, at, -64);
        brushes +=
            box_text(mins, mins + math::Vec3d(kTile, kTile, 64), fmt::format("tile{}", int(at + 256) % 3));
      }
  const math::Vec3d outer(256 + kTile);
  return entity_text("worldspawn", "",
                     walls_text({-outer.x, -outer.y, -64}, {outer.x, outer.y, 128}, "wall") + brushes) +
         point_text("info_player_start", {0, 0, 32});
}

compiler::DraftResult compile_draft(const std::string& map_text, const compiler::DraftOptions& options,
                                    int threads) {
  base::Jobs jobs(threads);
  compiler::Warnings warnings;
  return compiler::make_draft(
             parse_map(map_text), [](std::string_view) { return math::Vec2d(64, 64); }, options, jobs,
             warnings)
      .value();
}

std::shared_ptr<const world::Level> make_level_of_brushes(const formats::Map& map,
                                                          compiler::DraftOptions options) {
  base::Jobs jobs(2);
  compiler::Warnings warnings;
  options.fill_outside = false;
  const compiler::DraftResult result =
      compiler::make_draft(
          map, [](std::string_view) { return math::Vec2d(64, 64); }, options, jobs, warnings)
          .value();
  return world::make_level(result.draft.bsp, "brushes").value();
}

base::Result<compiler::DraftResult> try_compile_draft(const std::string& map_text,
                                                      compiler::Warnings& io_warnings) {
  TRY(const formats::Map map, formats::read_map(map_text));
  base::Jobs jobs(1);
  return compiler::make_draft(
      map, [](std::string_view) { return math::Vec2d(64, 64); }, {}, jobs, io_warnings);
}

std::string find_level_fault(const compiler::DraftResult& result) {
  formats::Bsp bsp = result.draft.bsp;
  for (formats::BspMiptex& texture : bsp.miptexes) texture.name.clear();
  const auto fault = formats::find_fault(bsp);
  return fault ? fault->reason : "";
}

world::Contents contents_at(const compiler::DraftResult& result, const math::Vec3& point, world::Hull hull) {
  const auto level = world::make_level(result.draft.bsp, "room").value();
  return world::hull_contents(*level, world::ModelIndex{0}, hull, point);
}

double measure_area(const compiler::DraftResult& result, std::string_view texture, int axis, int sign,
                    float at) {
  const formats::Bsp& bsp = result.draft.bsp;
  double area = 0;
  for (const formats::BspFace& face : bsp.faces) {
    const formats::BspPlane& plane = bsp.planes[face.plane];
    const float facing = plane.normal[axis] * (face.side == 0 ? 1.0f : -1.0f);
    const bool lies_there = plane.distance * plane.normal[axis] == at;
    if (facing == static_cast<float>(sign) && lies_there && texture_name(bsp, face) == texture)
      area += measure_face(bsp, face);
  }
  return area;
}

int count_faces(const compiler::DraftResult& result, std::string_view texture) {
  const formats::Bsp& bsp = result.draft.bsp;
  return static_cast<int>(std::ranges::count_if(
      bsp.faces, [&](const formats::BspFace& face) { return texture_name(bsp, face) == texture; }));
}

}  // namespace temblor::test
