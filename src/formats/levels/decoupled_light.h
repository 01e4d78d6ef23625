// BSPX DECOUPLED_LM: light maps whose samples lie on a grid of their own, independent of the texture. For
// each face, 40 bytes:
//
//    0  width u16, height u16   of the light map in samples
//    4  offset i32              into `lighting`, like light_offset; -1: the face has no light
//    8  x axis f32[3], x offset f32
//   24  y axis f32[3], y offset f32
//
// The sample at column x, row y lies where dot(position, x axis) + x offset == x, and y likewise. Each light
// style has width x height samples. The face's styles are those of read_face_styles() (scaled_light.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::formats {

// The light map of one face.
struct DecoupledLightMap {
  std::uint16_t width = 0, height = 0;
  std::int32_t offset = -1;  // -1: none. Whether all samples are inside of `lighting` is not checked
  math::Vec3 x_axis{0.0f};
  float x_offset = 0;
  math::Vec3 y_axis{0.0f};
  float y_offset = 0;
  bool operator==(const DecoupledLightMap&) const = default;
};

// Returns one map for each face; nothing if the level has no DECOUPLED_LM. Fails if the lump is not as large
// as the faces need, or if an offset is below -1, or if a number of a map with light is not within
// +-kBspMaxCoordinate.
base::Result<std::vector<DecoupledLightMap>> read_decoupled_light(const Bsp& bsp);

// Replaces the level's DECOUPLED_LM. `maps`: one for each face; empty: only removes it.
void set_decoupled_light(std::span<const DecoupledLightMap> maps, Bsp& io_bsp);

}  // namespace temblor::formats
