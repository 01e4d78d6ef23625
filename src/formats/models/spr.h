// Sprites (.spr), version 1: flat pictures in the world, which turn toward the viewer or with an entity.
//
//   header, 36 bytes    0  "IDSP"
//                       4  version i32 (1)
//                       8  orientation i32          SprOrientation; unknown: parallel to the view plane
//                      12  bounding radius f32
//                      16  maximum width i32, maximum height i32
//                      24  number of frames i32
//                      28  beam length f32
//                      32  random phase i32         1: entities start animated groups at different times
//   frames             single or group (model_bytes.h) of pictures:
//   picture             0  left i32                 from the origin, usually negative
//                       4  up i32                   from the origin to the top edge
//                       8  width i32, height i32
//                      16  palette indices u8, row by row from the top; 255 is transparent
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

// Limits of a file: texels of a side, pictures of all frames together, and units from the origin to an edge.
constexpr std::uint32_t kMaxSprSide = 1 << 12, kMaxSprPictures = 1 << 14;
constexpr std::int32_t kMaxSprOffset = 1 << 16;

// How a sprite is turned.
enum class SprOrientation : std::uint32_t {
  kParallelUpright = 0,   // parallel to the view plane, upright
  kFacingUpright = 1,     // facing the eye, upright
  kParallel = 2,          // parallel to the view plane
  kOriented = 3,          // turned by the entity's angles
  kParallelOriented = 4,  // parallel to the view plane, rolled by the entity's roll
};

// One flat picture, a unit for each texel.
struct SprPicture {
  // From the origin to the left and the top edge of the picture, in units; at most kMaxSprOffset either way.
  std::int32_t left = 0, up = 0;
  std::uint32_t width = 0, height = 0;  // texels, one unit each; 1 to kMaxSprSide
  std::vector<std::uint8_t> texels;     // palette indices, row by row; 255 is transparent
  bool operator==(const SprPicture&) const = default;
};

// A frame: one picture, or an animated group with the strictly increasing end times of its pictures in
// seconds.
struct SprFrame {
  std::vector<SprPicture> pictures;  // at least one
  std::vector<float> end_times_s;    // empty: not a group
  bool operator==(const SprFrame&) const = default;
};

struct Spr {
  SprOrientation orientation = SprOrientation::kParallel;
  float bounding_radius = 0;
  std::uint32_t max_width = 0, max_height = 0;
  float beam_length = 0;
  bool random_phase = false;
  std::vector<SprFrame> frames;  // at least one
  bool operator==(const Spr&) const = default;
};

// Reads and validates a sprite. Errors name the part and its offset.
base::Result<Spr> read_spr(base::Bytes bytes);
// Writes a sprite. CHECKs the same rules. The result reads back as an equal sprite.
base::ByteVector write_spr(const Spr& spr);

}  // namespace temblor::formats
