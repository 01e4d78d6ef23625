// Draws triangles by recursive subdivision, John Carmack's method as described by Michael Abrash ("Surface
// Caching and Quake's Triangle Models", Graphics Programming Black Book, chapter 69).
//
//   1. All vertices are drawn as pixels, whichever way they face.
//   2. A triangle with a side longer than one pixel in x or y is split at the middle of that side. The new
//      vertex is drawn, and both halves are treated in the same way.
//
//        a                 a
//        |\                |\            Two triangles share each side. Only the one for which the side
//        | \      ->       | m           is a leading edge (upward, or level to the right)
//        |  \              |/ \          draws m.
//        c---b             c---b
//
// Nothing is scanned, which suits triangles of a few pixels. Light is that of the triangle's first vertex.
// Unlike stock Quake, depth is 1/z as a float, as in all of this renderer.
#include <algorithm>

#include "render/alias/triangle_kernels.h"

namespace temblor::render {

namespace {

// x and y in whole pixels; s and t in 1/65536 texel.
struct SplitVertex {
  std::int32_t x, y, s, t;
  float depth;
};

constexpr float kTexelSteps = 65536.0f;

// Whether a side is longer than one pixel in x or y. Branchless, since the result is unpredictable.
constexpr bool is_long(const SplitVertex& a, const SplitVertex& b) {
  const auto x = static_cast<std::uint32_t>(b.x - a.x + 1), y = static_cast<std::uint32_t>(b.y - a.y + 1);
  return std::max(x, y) > 2;
}

// Lights palette indices, at a constant light.
class IndexedLight {
 public:
  IndexedLight(const TriangleJob& job, float light) {
    const float bounded = light < kDarkestRow ? light : kDarkestRow;
    const auto row = static_cast<std::int32_t>(bounded > 0 ? bounded : 0) & ~255;
    row_ = static_cast<const std::uint8_t*>(job.colors) + row;
  }
  using Pixel = std::uint8_t;
  Pixel operator()(std::uint8_t texel) const { return row_[texel]; }

 private:
  const std::uint8_t* row_;
};

// Lights colors, at a constant light.
class RgbLight {
 public:
  RgbLight(const TriangleJob& job, float light) : colors_(static_cast<const std::uint32_t*>(job.colors)) {
    const float bounded = light < kBrightestLight ? light : kBrightestLight;
    const auto whole = static_cast<std::int32_t>(bounded > 0 ? bounded : 0);
    for (int channel = 0; channel < 3; ++channel) tinted_[channel] = (whole * job.tint[channel]) >> 15;
  }
  using Pixel = std::uint32_t;
  Pixel operator()(std::uint8_t texel) const {
    const std::uint32_t color = colors_[texel];
    if (color >> 24 == 0) return color | 0xff000000u;
    std::uint32_t lit = 0xff000000u;
    for (int channel = 0; channel < 3; ++channel) {
      const int shift = 16 - 8 * channel;
      const std::int32_t value =
          (static_cast<std::int32_t>(color >> shift & 255) * 2 * tinted_[channel] + 16384) >> 15;
      lit |= static_cast<std::uint32_t>(value < 255 ? value : 255) << shift;
    }
    return lit;
  }

 private:
  const std::uint32_t* colors_;
  std::int32_t tinted_[3];
};

template <typename Light>
// Draws one model into one band.
class Subdivider {
 public:
  Subdivider(const TriangleJob& job, const TriangleTarget& target) : job_(job), target_(target) {}

  void draw() {
    for (std::size_t i = 0; i < job_.vertex_count; ++i) plot(vertex(i), Light(job_, job_.vertices[i].light));
    for (std::size_t i = 0; i < job_.triangle_count; ++i) {
      const std::uint32_t* index = job_.triangles + i * 3;
      const SplitVertex a = vertex(index[0]), b = vertex(index[1]), c = vertex(index[2]);
      if ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) <= 0) continue;
      const std::int32_t begin = target_.row_begin, end = target_.row_end;
      if ((a.y < begin && b.y < begin && c.y < begin) || (a.y >= end && b.y >= end && c.y >= end)) continue;
      split(a, b, c, Light(job_, job_.vertices[index[0]].light));
    }
  }

 private:
  SplitVertex vertex(std::size_t i) const {
    const ScreenVertex& v = job_.vertices[i];
    const TexelPoint& texel = job_.texels[i];
    return {(v.x + kSubpixels / 2) >> 8, (v.y + kSubpixels / 2) >> 8,
            static_cast<std::int32_t>(texel.s * kTexelSteps),
            static_cast<std::int32_t>(texel.t * kTexelSteps), v.depth};
  }

  void plot(const SplitVertex& v, const Light& light) {
    if (v.y < target_.row_begin || v.y >= target_.row_end) return;
    const std::size_t at =
        static_cast<std::size_t>(v.y - target_.first_row) * static_cast<std::size_t>(target_.width) +
        static_cast<std::size_t>(v.x);
    if (!(v.depth >= target_.depth[at])) return;
    target_.depth[at] = v.depth;
    static_cast<typename Light::Pixel*>(target_.pixels)[at] =
        light(job_.skin[(v.t >> 16) * job_.skin_width + (v.s >> 16)]);
  }

  // Splits the first long side among ab, bc, and ca, if any. The second recursive call is a loop.
  void split(SplitVertex a, SplitVertex b, SplitVertex c, const Light& light) {
    while (true) {
      if (!is_long(a, b)) {
        const bool second = is_long(b, c);
        if (!second && !is_long(c, a)) return;
        const SplitVertex first = a;
        if (second) {
          a = b;
          b = c;
          c = first;
        } else {
          a = c;
          c = b;
          b = first;
        }
      }
      const SplitVertex middle{(a.x + b.x) >> 1, (a.y + b.y) >> 1, (a.s + b.s) >> 1, (a.t + b.t) >> 1,
                               (a.depth + b.depth) * 0.5f};
      if (b.y < a.y || (b.y == a.y && b.x > a.x)) plot(middle, light);
      split(c, a, middle, light);
      a = c;
      c = b;
      b = middle;
    }
  }

  const TriangleJob& job_;
  const TriangleTarget& target_;
};

}  // namespace

void subdivide_triangles_u8(const TriangleJob& job, const TriangleTarget& target) {
  Subdivider<IndexedLight>(job, target).draw();
}
void subdivide_triangles_u32(const TriangleJob& job, const TriangleTarget& target) {
  Subdivider<RgbLight>(job, target).draw();
}

}  // namespace temblor::render
