// Lights that project a texture, as a slide projector does (_project_texture). The picture is a pyramid of
// light with its tip at the light; points outside are dark, and those inside take the color of their texel.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/light/sources/directions.h"
#include "compiler/light/sources/light_source.h"
#include "compiler/report.h"
#include "formats/images/palette.h"
#include "formats/levels/entities.h"
#include "math/vec.h"
#include "world/level.h"

namespace temblor::compiler {

// The pyramid and its picture.
struct Projection {
  std::string texture;
  std::string light;               // for messages
  Frame axes;                      // forward: the middle of the picture; right and up: its sides
  float half_width = 1;            // of the picture at distance 1
  std::uint32_t width = 0;         // in texels; 0: no picture, so the light is not changed
  std::uint32_t height = 0;        // in texels
  std::vector<math::Vec3> texels;  // width x height, 0 to 1, row by row from the top
};

// Reads _project_texture, _project_mangle (yaw pitch roll; default: the direction of the cone, or down) and
// _project_fov (degrees from side to side, 1 to 170, default 90). Returns nothing without _project_texture.
std::optional<Projection> read_projection(const formats::Entity& entity, const std::optional<Cone>& cone);

// Takes the pictures from the level's textures. Warns about those that the level lacks. Without a palette,
// pictures are gray.
void load_pictures(const world::Level& level, const std::optional<formats::Palette>& palette,
                   std::span<Projection> io_projections, Warnings& io_warnings);

// The color in the direction from the light, which may have any length: between texels, it is interpolated.
math::Vec3 find_projected_color(const Projection& projection, const math::Vec3& from_light);

// The mean color over a parallelogram around a place, whose sides are `across` and `along`.
math::Vec3 compute_projected_mean(const Projection& projection, const math::Vec3& from_light,
                                  const math::Vec3& across, const math::Vec3& along);

}  // namespace temblor::compiler
