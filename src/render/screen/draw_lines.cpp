// Each line is cut at the near plane, projected, and cut at the frame's sides. The rest of it takes one pixel
// in each column, or in each row if it is steep.
#include "render/screen/draw_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "render/screen/painter.h"

namespace temblor::render {

namespace {

// A line is hidden only by what is nearer than this share of its own distance.
constexpr double kDepthSlack = 1.0 / 256;

template <typename Vector>
struct Piece {
  Vector from, to;
};

// Cuts off the part where `inside`, which is linear along the piece, is negative; nothing if that is all.
template <typename Vector, typename Inside>
std::optional<Piece<Vector>> cut(const Piece<Vector>& piece, Inside inside) {
  const double from = inside(piece.from), to = inside(piece.to);
  if (!(from >= 0 || to >= 0)) return std::nullopt;
  if (from >= 0 && to >= 0) return piece;
  const Vector border = piece.from + (piece.to - piece.from) * (from / (from - to));
  return from >= 0 ? Piece<Vector>{piece.from, border} : Piece<Vector>{border, piece.to};
}

// The part of a line that is on the screen: x, y, and depth, which is linear there.
std::optional<Piece<math::Vec3d>> project(const Line& line, const ViewFrame& view) {
  const Piece<math::Vec3d> whole{view.to_view(math::Vec3d(line.from_world)),
                                 view.to_view(math::Vec3d(line.to_world))};
  const auto before_eye = cut(whole, [&](const math::Vec3d& p) { return p.z - view.near_z; });
  if (!before_eye) return std::nullopt;
  // The cut may be nearer by a rounding error.
  const auto to_screen = [&](math::Vec3d p) {
    p.z = std::max(p.z, view.near_z);
    return math::Vec3d(view.to_screen(p), view.depth(p.z));
  };
  std::optional<Piece<math::Vec3d>> seen =
      Piece<math::Vec3d>{to_screen(before_eye->from), to_screen(before_eye->to)};
  for (int axis = 0; axis < 2 && seen; ++axis) {
    const int last = (axis == 0 ? view.width : view.height) - 1;
    seen = cut(*seen, [&](const math::Vec3d& p) { return p[axis]; });
    if (seen) seen = cut(*seen, [&](const math::Vec3d& p) { return last - p[axis]; });
  }
  return seen;
}

// `depth`: the frame's, for a line with a depth test; otherwise empty.
void draw_piece(Piece<math::Vec3d> piece, formats::Rgb color, const ViewFrame& view,
                std::span<const float> depth, Painter& io_painter) {
  const math::Vec3d size = piece.to - piece.from;
  const int along = std::abs(size.x) >= std::abs(size.y) ? 0 : 1, across = 1 - along;
  if (size[along] < 0) std::swap(piece.from, piece.to);
  const double slope = size[along] != 0 ? size[across] / size[along] : 0;
  const double depth_slope = size[along] != 0 ? size.z / size[along] : 0;
  const auto to_pixel = [&](double at, int axis) {
    return std::clamp(static_cast<int>(std::lround(at)), 0, (axis == 0 ? view.width : view.height) - 1);
  };
  const int last = to_pixel(piece.to[along], along);
  for (int i = to_pixel(piece.from[along], along); i <= last; ++i) {
    const int j = to_pixel(piece.from[across] + slope * (i - piece.from[along]), across);
    const int x = along == 0 ? i : j, y = along == 0 ? j : i;
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(x);
    const double nearness = piece.from.z + depth_slope * (i - piece.from[along]);
    // Lines on a wall are in front of it.
    if (!depth.empty() && nearness + std::abs(nearness) * kDepthSlack < depth[pixel]) continue;
    io_painter.put(pixel, color);
  }
}

bool is_finite(const math::Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

void draw_lines(std::span<const Line> lines, const ViewFrame& view, const formats::Palette& palette,
                FrameBuffer& io_frame) {
  Painter painter(palette, io_frame);
  for (const Line& line : lines) {
    if (!is_finite(line.from_world) || !is_finite(line.to_world)) continue;
    const std::span<const float> depth =
        line.is_depth_tested ? std::as_const(io_frame).depth() : std::span<const float>();
    if (const auto piece = project(line, view)) draw_piece(*piece, line.color, view, depth, painter);
  }
}

}  // namespace temblor::render
