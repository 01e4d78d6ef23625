// A picture that a mark shows, such as graffiti: a true-color image with transparency, kept in several sizes
// like mip levels, so that it looks the same on every mip level of the surface that it is painted on.
//
// The image lies in the middle of a square whose side is a power of two; each size is the mean of 2 x 2
// texels of the one before. Colors are multiplied by their opacity, so that the colors of clear texels do not
// matter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "formats/images/image.h"
#include "formats/images/palette.h"

namespace temblor::render {

// The effect of a picture on one point.
struct PictureTexel {
  formats::Rgb color;
  int opacity_256 = 0;  // 0 to 256
};

// Immutable.
class MarkPicture {
 public:
  static constexpr std::uint32_t kMaxSide = 256;  // pixels

  // Both sides of the image must be 1 to kMaxSide (CHECKed).
  explicit MarkPicture(const formats::Image& image);

  // The picture at (u, v), which are -1 to 1 along its longer side: u to the right, v down. Interpolated
  // between the texels of size `level`; clear outside.
  PictureTexel at(int level, float u, float v) const;
  int level_count() const { return static_cast<int>(levels_.size()); }
  // Pixels of the longer side.
  int longer_side() const { return longer_side_; }
  // A hash of the pixels. Equal pictures have equal hashes; different ones have different hashes except with
  // a chance of 2^-64.
  std::uint64_t hash() const { return hash_; }

 private:
  struct Texel {
    std::uint8_t r = 0, g = 0, b = 0, opacity = 0;  // colors are multiplied by opacity / 255
  };
  // A square of side x side texels with a clear border of one texel, so that interpolation needs no bounds
  // check.
  struct Level {
    explicit Level(int texels_of_side);
    int side;
    std::vector<Texel> texels;
    std::size_t index(int x, int y) const { return static_cast<std::size_t>((y + 1) * (side + 2) + x + 1); }
  };
  static Level make_first(const formats::Image& image);
  static Level make_smaller(const Level& level);

  std::vector<Level> levels_;
  int longer_side_;
  // The middle of the image, relative to the square's side; half a texel beside its middle if a side is odd.
  float middle_x_, middle_y_;
  std::uint64_t hash_;
};

}  // namespace temblor::render
