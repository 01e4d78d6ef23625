#include "compiler/light/lit_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/compile_level.h"
#include "support/levels/room_map.h"
#include "world/face_at.h"

namespace temblor::test {
std::shared_ptr<const world::Level> lit_map(const std::string& text, const LitMapOptions& options) {
  base::Jobs jobs(2, base::JobBackend::kStdThread);
  compiler::CompileOptions how;
  how.light = options.light;
  compiler::CompileWatcher nobody;
  compiler::Warnings warnings;
  compiler::Build build;
  const compiler::CompileReport report =
      compiler::compile_level({parse_map(text), {}, options.palette}, how, {jobs, nobody, warnings}, build)
          .value();
  CHECK(!report.leak);
  return world::make_level(std::move(build.bsp), "test map").value();
}

math::Vec3d shown_light(const world::Level& level, const world::Face& face, const math::Vec3d& place,
                        std::uint8_t style) {
  const auto last = face.styles.begin() + face.style_count;
  const auto found = std::find(face.styles.begin(), last, style);
  if (face.light == world::kNoLight || found == last) return math::Vec3d(0.0);
  const int width = face.light_width(), height = face.light_height();
  const std::size_t first = face.light + static_cast<std::size_t>(found - face.styles.begin()) *
                                             static_cast<std::size_t>(width * height);
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  const auto along = [](double texel, int mins, int luxels) {
    return std::clamp((texel - mins) / 16, 0.0, static_cast<double>(luxels - 1));
  };
  const double s =
      along(glm::dot(place, math::Vec3d(axes.s_axis)) + double{axes.s_offset}, face.texture_mins[0], width);
  const double t =
      along(glm::dot(place, math::Vec3d(axes.t_axis)) + double{axes.t_offset}, face.texture_mins[1], height);
  const double part_x = s - std::floor(s), part_y = t - std::floor(t);
  math::Vec3d light(0.0);
  for (const int row : {0, 1})
    for (const int column : {0, 1}) {
      const int x = std::min(static_cast<int>(s) + column, width - 1);
      const int y = std::min(static_cast<int>(t) + row, height - 1);
      const double share = (column == 1 ? part_x : 1 - part_x) * (row == 1 ? part_y : 1 - part_y);
      const std::size_t sample = first + static_cast<std::size_t>(y * width + x);
      for (int channel = 0; channel < 3; ++channel)
        light[channel] += share * (level.light_rgb.empty()
                                       ? level.light[sample]
                                       : level.light_rgb[sample * 3 + static_cast<std::size_t>(channel)]);
    }
  return light;
}

const world::Face& face_under(const world::Level& level, const math::Vec3d& place,
                              const math::Vec3d& normal) {
  const auto found = std::find_if(level.faces.begin(), level.faces.end(), [&](const world::Face& face) {
    return glm::dot(world::compute_face_plane(level, face).normal, normal) > 0.99 &&
           glm::length(world::find_nearest_point(level, face, place) - place) < 0.01;
  });
  CHECK(found != level.faces.end(), "no face at {} {} {}", place.x, place.y, place.z);
  return *found;
}

}  // namespace temblor::test
