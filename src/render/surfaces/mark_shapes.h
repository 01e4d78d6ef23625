// The shapes of marks, without their color: small pictures that are generated once, in several sizes (like
// mip levels), so that a mark looks the same on every mip level of the surface that it is painted on.
//
// Shapes use only +, -, *, /, and square roots, so they are identical on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/marks.h"

namespace temblor::render {

// The effect of a mark on one point.
struct MarkTexel {
  float opacity;  // 0 to 1
  float shade;    // 0 to 1: from the first color of the mark's ink to the last
};

// All shapes in all sizes; immutable.
class MarkShapes {
 public:
  static constexpr int kKinds = 3;
  // Different shapes of one kind.
  static constexpr int kVariants = 4;
  static constexpr int kSide = 64;  // texels of the largest size
  // Each level has half the size of the one before; the last is a single texel.
  static constexpr int kLevels = 7;

  MarkShapes();

  // The shape at (u, v), -1 to 1 across it, interpolated between the texels of size `level`; clear outside.
  MarkTexel at(MarkKind kind, int variant, int level, float u, float v) const;

 private:
  // A square of side x side texels with a clear border of one texel, so that interpolation needs no bounds
  // check.
  struct Picture {
    int side = 0;
    std::vector<MarkTexel> texels;  // shade is multiplied by opacity, so that means are right
    MarkTexel& texel(int x, int y) { return texels[index(x, y)]; }
    const MarkTexel& texel(int x, int y) const { return texels[index(x, y)]; }
    std::size_t index(int x, int y) const { return static_cast<std::size_t>((y + 1) * (side + 2) + x + 1); }
  };
  static Picture make_picture(MarkKind kind, int variant);
  static Picture make_smaller(const Picture& picture);
  static std::size_t number(MarkKind kind, int variant, int level) {
    return static_cast<std::size_t>((static_cast<int>(kind) * kVariants + variant) * kLevels + level);
  }

  std::vector<Picture> pictures_;
};

}  // namespace temblor::render
