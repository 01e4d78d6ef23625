// Hot loop. Scalar, like the engine's subdivision: each step depends on the one before.
#include "lab/models/split_triangles.h"

#include <algorithm>

#include "render/alias/affine_triangle.h"

namespace temblor::lab {

namespace {

// x and y in whole pixels; s and t in 1/65536 texel; light in the units of TriangleJob's colors.
struct SplitCorner {
  std::int32_t x, y, s, t, light;
  float depth;
};

constexpr float kTexelSteps = 65536.0f;

constexpr bool is_long(const SplitCorner& a, const SplitCorner& b) {
  const auto x = static_cast<std::uint32_t>(b.x - a.x + 1), y = static_cast<std::uint32_t>(b.y - a.y + 1);
  return std::max(x, y) > 2;
}

// Slivers are halved as often as triangles with equal sides, so time grows with the square of the longest
// side. Around the eye, a model would take many seconds.
constexpr std::int32_t kMaxSide = 1024;

constexpr bool is_huge(const SplitCorner& a, const SplitCorner& b, const SplitCorner& c) {
  return std::max({a.x, b.x, c.x}) - std::min({a.x, b.x, c.x}) > kMaxSide ||
         std::max({a.y, b.y, c.y}) - std::min({a.y, b.y, c.y}) > kMaxSide;
}

template <typename Pixel, bool kSplitsLight>
class Splitter {
 public:
  Splitter(const render::TriangleJob& job, const render::TriangleTarget& target)
      : job_(job), target_(target) {}

  void draw(bool inside_screen) {
    if (inside_screen)
      for (std::size_t i = 0; i < job_.vertex_count; ++i) plot(corner(i));
    for (std::size_t i = 0; i < job_.triangle_count; ++i) {
      const std::uint32_t* index = job_.triangles + i * 3;
      SplitCorner a = corner(index[0]), b = corner(index[1]), c = corner(index[2]);
      const std::int64_t cross =
          std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
      if (cross <= 0 || is_outside(a, b, c)) continue;
      if (!inside_screen && is_huge(a, b, c)) {
        draw_rows(i);
        continue;
      }
      if (!inside_screen)
        for (const SplitCorner* drawn : {&a, &b, &c}) plot(*drawn);
      if (!kSplitsLight) b.light = c.light = a.light;
      split(a, b, c);
    }
  }

 private:
  void draw_rows(std::size_t triangle) {
    render::draw_affine_triangle(job_, triangle, target_, [&](const render::TriangleSpan& span) {
      const std::size_t first =
          static_cast<std::size_t>(span.y - target_.first_row) * static_cast<std::size_t>(target_.width) +
          static_cast<std::size_t>(span.x);
      for (std::int32_t pixel = 0; pixel < span.count; ++pixel) {
        const float lane = static_cast<float>(pixel), depth = span.depth + lane * span.depth_step;
        const std::size_t at = first + static_cast<std::size_t>(pixel);
        if (!(depth >= target_.depth[at])) continue;
        target_.depth[at] = depth;
        static_cast<Pixel*>(target_.pixels)[at] =
            render::lit_texel(job_, render::skin_texel(job_, span, lane, depth), span, lane, Pixel{});
      }
    });
  }

  SplitCorner corner(std::size_t i) const {
    const render::ScreenVertex& v = job_.vertices[i];
    const render::TexelPoint& texel = job_.texels[i];
    return {(v.x + render::kSubpixels / 2) >> 8,
            (v.y + render::kSubpixels / 2) >> 8,
            static_cast<std::int32_t>(texel.s * kTexelSteps),
            static_cast<std::int32_t>(texel.t * kTexelSteps),
            static_cast<std::int32_t>(v.light),
            v.depth};
  }

  bool is_outside(const SplitCorner& a, const SplitCorner& b, const SplitCorner& c) const {
    const std::int32_t begin = target_.row_begin, end = target_.row_end, width = target_.width;
    return (a.y < begin && b.y < begin && c.y < begin) || (a.y >= end && b.y >= end && c.y >= end) ||
           (a.x < 0 && b.x < 0 && c.x < 0) || (a.x >= width && b.x >= width && c.x >= width);
  }

  void plot(const SplitCorner& v) {
    if (v.y < target_.row_begin || v.y >= target_.row_end || v.x < 0 || v.x >= target_.width) return;
    const std::size_t at =
        static_cast<std::size_t>(v.y - target_.first_row) * static_cast<std::size_t>(target_.width) +
        static_cast<std::size_t>(v.x);
    if (!(v.depth >= target_.depth[at])) return;
    target_.depth[at] = v.depth;
    const std::uint8_t texel = job_.skin[(v.t >> 16) * job_.skin_width + (v.s >> 16)];
    render::TriangleSpan lit{};
    lit.light = static_cast<float>(v.light);
    static_cast<Pixel*>(target_.pixels)[at] = render::lit_texel(job_, texel, lit, 0, Pixel{});
  }

  // Splits the first long side among ab, bc, and ca, if any. The second recursive call is a loop.
  void split(SplitCorner a, SplitCorner b, SplitCorner c) {
    while (!is_outside(a, b, c)) {
      if (!is_long(a, b)) {
        const bool second = is_long(b, c);
        if (!second && !is_long(c, a)) return;
        const SplitCorner first = a;
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
      SplitCorner middle{(a.x + b.x) >> 1, (a.y + b.y) >> 1, (a.s + b.s) >> 1,
                         (a.t + b.t) >> 1, a.light,          (a.depth + b.depth) * 0.5f};
      if (kSplitsLight) middle.light = (a.light + b.light) >> 1;
      if (b.y < a.y || (b.y == a.y && b.x > a.x)) plot(middle);
      split(c, a, middle);
      a = c;
      c = b;
      b = middle;
    }
  }

  const render::TriangleJob& job_;
  const render::TriangleTarget& target_;
};

template <typename Pixel>
void split(const render::TriangleJob& job, const SplitRules& rules, const render::TriangleTarget& target) {
  rules.splits_light ? Splitter<Pixel, true>(job, target).draw(rules.inside_screen)
                     : Splitter<Pixel, false>(job, target).draw(rules.inside_screen);
}

}  // namespace

void split_triangles(const render::TriangleJob& job, const SplitRules& rules,
                     const render::TriangleTarget& target) {
  rules.format == render::PixelFormat::kIndexed ? split<std::uint8_t>(job, rules, target)
                                                : split<std::uint32_t>(job, rules, target);
}

}  // namespace temblor::lab
