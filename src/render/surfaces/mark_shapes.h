// What marks look like, apart from their color: small pictures made by code once, at several sizes, so that
// a mark looks alike on every mip level of what it is painted on.
//
// Arithmetic is +, -, * and / and square roots only: the same shapes on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/marks.h"

namespace temblor::render {

struct MarkTexel {
  float opacity;  // 0 to 1
  float shade;    // 0 to 1: from the first to the last color of the mark's ink
};

class MarkShapes {
 public:
  static constexpr int kKinds = 3;
  static constexpr int kVariants = 4;  // shapes of a kind
  static constexpr int kSide = 64;     // texels of the largest size
  static constexpr int kLevels = 7;    // each half the size of the one before: the last is one texel

  MarkShapes();

  // At (u, v), -1 to 1 across the shape, interpolated between the texels of size `level`; clear outside.
  MarkTexel at(MarkKind kind, int variant, int level, float u, float v) const;

 private:
  // Of opacity 0 where clear; rows of side + 2, with a clear border.
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
