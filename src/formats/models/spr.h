// Sprites (.spr): flat pictures that stand in the world.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

constexpr std::uint32_t kMaxSprSide = 1 << 12, kMaxSprPictures = 1 << 14;  // texels; in a file
constexpr std::int32_t kMaxSprOffset = 1 << 16;                            // units

enum class SprOrientation : std::uint32_t {
  kParallelUpright = 0,   // turned towards the view's plane, standing upright
  kFacingUpright = 1,     // turned towards the eye, standing upright
  kParallel = 2,          // in the view's plane
  kOriented = 3,          // as the entity's angles say
  kParallelOriented = 4,  // in the view's plane, rolled by the entity's roll
};

struct SprPicture {
  std::int32_t left = 0, up = 0;  // from the origin to the picture's left and top edge, in units; at most
                                  // kMaxSprOffset either way
  std::uint32_t width = 0, height = 0;  // texels, one unit each; 1 to kMaxSprSide
  std::vector<std::uint8_t> texels;     // palette indices, row by row; 255 is transparent
  bool operator==(const SprPicture&) const = default;
};

// What a frame number stands for: one picture, or a group that plays by itself; the time at which each
// picture ends, rising, in seconds.
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

base::Result<Spr> read_spr(base::Bytes bytes);
base::ByteVector write_spr(const Spr& spr);

}  // namespace temblor::formats
