// Hot loop. Scalar: each step of a flood depends on the one before.
#include "lab/models/flood/flooded_picture.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "render/alias/affine_triangle.h"

namespace temblor::lab {

namespace {

// Elements after the last pixel that the kernels of sprites may touch.
constexpr std::size_t kSpare = 64;
// A ring of pixels from which the outside is flooded, and a ring that ends each flood.
constexpr int kRings = 2;

enum class PixelState : std::uint8_t { kUnknown, kPainted, kOutside };

// The values that are interpolated along an edge.
struct EdgePoint {
  float depth, light, s, t;
};

// The nearest pixel.
std::int32_t round_pixel(std::int32_t subpixels) {
  return (subpixels + render::kSubpixels / 2) >> 8;
}

struct PictureBox {
  int left, top, right, bottom;  // inclusive
};

PictureBox find_box(const render::TriangleJob& job, std::span<const std::uint32_t> vertices) {
  constexpr int kFar = std::numeric_limits<int>::max();
  PictureBox box{kFar, kFar, -kFar, -kFar};
  for (const std::uint32_t i : vertices) {
    const int x = round_pixel(job.vertices[i].x), y = round_pixel(job.vertices[i].y);
    box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
  }
  return box;
}

template <typename Pixel>
class Flood {
 public:
  Flood(const render::TriangleJob& job, const PictureBox& box, base::Arena& arena, base::Arena& scratch)
      : job_(job),
        left_(box.left - kRings),
        top_(box.top - kRings),
        stride_(box.right - box.left + 1 + 2 * kRings),
        rows_(box.bottom - box.top + 1 + 2 * kRings) {
    const auto count = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(rows_);
    pixels_ = arena.allocate<Pixel>(count + kSpare);
    depth_ = arena.allocate_filled<float>(count + kSpare, -std::numeric_limits<float>::infinity());
    state_ = scratch.allocate_filled<PixelState>(count, PixelState::kUnknown);
    queue_ = scratch.allocate<std::int32_t>(count);
    around_ = {-1, 1, -stride_, stride_};
    add_wall();
  }

  void draw_vertex(std::uint32_t number) {
    plot(round_pixel(job_.vertices[number].x), round_pixel(job_.vertices[number].y), make_point(number));
  }

  // One pixel for each column or row, whichever are more.
  void draw_edge(const OutlineEdge& edge) {
    const EdgePoint from = make_point(edge.from), to = make_point(edge.to);
    const render::ScreenVertex &a = job_.vertices[edge.from], &b = job_.vertices[edge.to];
    const std::int32_t x = round_pixel(a.x), y = round_pixel(a.y);
    const std::int32_t dx = round_pixel(b.x) - x, dy = round_pixel(b.y) - y;
    const std::int32_t steps = std::max(std::abs(dx), std::abs(dy));
    for (std::int32_t i = 1; i < steps; ++i) {
      const float along = static_cast<float>(i) / static_cast<float>(steps);
      const auto mix = [along](float p, float q) { return p + (q - p) * along; };
      // Rounded to the nearest pixel, as integers, so that lines have no gaps.
      const auto step = [&](std::int32_t d) { return (2 * d * i + (d < 0 ? -steps : steps)) / (2 * steps); };
      plot(x + step(dx), y + step(dy),
           {mix(from.depth, to.depth), mix(from.light, to.light), mix(from.s, to.s), mix(from.t, to.t)});
    }
  }

  // A row's run of pixels at a time.
  void flood_outside() {
    std::size_t count = 0;
    queue_[count++] = stride_ + 1;  // of the ring
    while (count > 0) {
      const std::int32_t at = queue_[--count];
      if (!is_unknown(at)) continue;
      std::int32_t first = at, end = at;
      while (is_unknown(first - 1)) --first;
      while (is_unknown(end)) ++end;
      std::fill(state_.begin() + first, state_.begin() + end, PixelState::kOutside);
      for (const std::int32_t row : {-stride_, stride_})
        for (std::int32_t i = first; i < end; ++i)
          if (is_unknown(i + row) && (i == first || !is_unknown(i + row - 1))) queue_[count++] = i + row;
    }
  }

  void flood_inside() {
    std::size_t first = 0, end = 0;
    for (std::size_t i = 0; i < state_.size(); ++i)
      if (state_[i] == PixelState::kPainted) queue_[end++] = static_cast<std::int32_t>(i);
    while (first < end) {
      const std::int32_t at = queue_[first++];
      const auto from = static_cast<std::size_t>(at);
      for (const std::int32_t step : around_) {
        const auto to = static_cast<std::size_t>(at + step);
        if (state_[to] != PixelState::kUnknown) continue;
        state_[to] = PixelState::kPainted;
        pixels_[to] = pixels_[from];
        depth_[to] = depth_[from];
        queue_[end++] = at + step;
      }
    }
  }

  FloodedPicture picture() const {
    const std::int64_t first = std::int64_t{kRings} * stride_ + kRings;
    return {left_ + kRings, top_ + kRings,          stride_ - 2 * kRings, rows_ - 2 * kRings,
            stride_,        pixels_.data() + first, depth_.data() + first};
  }

 private:
  EdgePoint make_point(std::uint32_t number) const {
    const render::ScreenVertex& vertex = job_.vertices[number];
    const render::TexelPoint& texel = job_.texels[number];
    return {vertex.depth, vertex.light, texel.s, texel.t};
  }

  bool is_unknown(std::int32_t at) const {
    return state_[static_cast<std::size_t>(at)] == PixelState::kUnknown;
  }

  void add_wall() {
    for (std::int32_t x = 0; x < stride_; ++x) {
      mark_wall(x);
      mark_wall((rows_ - 1) * stride_ + x);
    }
    for (std::int32_t y = 0; y < rows_; ++y) {
      mark_wall(y * stride_);
      mark_wall(y * stride_ + stride_ - 1);
    }
  }
  void mark_wall(std::int32_t at) { state_[static_cast<std::size_t>(at)] = PixelState::kOutside; }

  void plot(std::int32_t x, std::int32_t y, const EdgePoint& values) {
    const auto at = static_cast<std::size_t>((y - top_) * stride_ + (x - left_));
    if (!(values.depth >= depth_[at])) return;
    state_[at] = PixelState::kPainted;
    depth_[at] = values.depth;
    render::TriangleSpan pixel{};
    pixel.s = values.s;
    pixel.t = values.t;
    pixel.light = values.light;
    pixels_[at] =
        render::lit_texel(job_, render::skin_texel(job_, pixel, 0, values.depth), pixel, 0, Pixel{});
  }

  const render::TriangleJob& job_;
  std::int32_t left_, top_, stride_, rows_;
  std::span<Pixel> pixels_;
  std::span<float> depth_;
  std::span<PixelState> state_;
  std::span<std::int32_t> queue_;
  std::array<std::int32_t, 4> around_{};  // from a pixel to its neighbors
};

template <typename Pixel>
FloodedPicture flood(const render::TriangleJob& job, const Outline& outline, base::Arena& arena,
                     base::Arena& scratch) {
  Flood<Pixel> flood(job, find_box(job, outline.vertices), arena, scratch);
  for (const std::uint32_t vertex : outline.vertices) flood.draw_vertex(vertex);
  for (const OutlineEdge& edge : outline.edges) flood.draw_edge(edge);
  flood.flood_outside();
  flood.flood_inside();
  return flood.picture();
}

}  // namespace

FloodedPicture flood_model(const render::TriangleJob& job, const MeshEdges& edges, render::PixelFormat format,
                           base::Arena& arena, base::Arena& scratch) {
  const Outline outline = find_outline(job, edges, scratch);
  if (outline.vertices.empty()) return {};
  return format == render::PixelFormat::kIndexed ? flood<std::uint8_t>(job, outline, arena, scratch)
                                                 : flood<std::uint32_t>(job, outline, arena, scratch);
}

}  // namespace temblor::lab
