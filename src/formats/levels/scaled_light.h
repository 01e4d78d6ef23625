// BSPX LMSHIFT, LMOFFSET, and LMSTYLE: light maps with samples closer together or farther apart than every 16
// texels. The usual lumps keep a light map that every engine reads. Both lie in `lighting`.
//
//   LMSHIFT     u8 for each face: a sample at each multiple of 1 << shift texels (4: every 16, as usual)
//   LMOFFSET    i32 for each face, in place of its light_offset
//   LMSTYLE     u8[4] for each face, in place of its styles; 255: unused
//   LMSTYLE16   u16[N] for each face, in place of LMSTYLE, with any N; 65535: unused
//
// LMOFFSET and LMSTYLE may be missing; then the face's own are used. Layout: FTE's description of BSPX
// (specs/bspx.txt).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats {

constexpr std::uint8_t kMaxLightShift = 15;
using FaceStyles = std::array<std::uint8_t, 4>;  // as BspFace::styles

// The light map of one face.
struct ScaledLightMap {
  std::uint8_t shift = 4;    // at most kMaxLightShift
  std::int32_t offset = -1;  // into `lighting`; -1: none. Whether all samples are inside is not checked
  FaceStyles styles{255, 255, 255, 255};
  bool operator==(const ScaledLightMap&) const = default;
};

// Returns one map for each face; nothing if the level has no LMSHIFT. Fails if a lump is not as large as the
// faces need, or if a shift, an offset, or a style is out of range.
base::Result<std::vector<ScaledLightMap>> read_scaled_light(const Bsp& bsp);

// Returns the styles of each face, from LMSTYLE16, LMSTYLE, or the faces themselves. Only the first four of
// LMSTYLE16 are kept. Fails as read_scaled_light() does.
base::Result<std::vector<FaceStyles>> read_face_styles(const Bsp& bsp);

// Replaces the level's LMSTYLE and LMSTYLE16 by the styles of each face; removes them if they are the faces'
// own.
void set_face_styles(std::span<const FaceStyles> styles, Bsp& io_bsp);

// Replaces the level's LMSHIFT, LMOFFSET, LMSTYLE, and LMSTYLE16. `maps`: one for each face; empty: only
// removes them.
void set_scaled_light(std::span<const ScaledLightMap> maps, Bsp& io_bsp);

}  // namespace temblor::formats
