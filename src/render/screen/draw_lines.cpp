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

// Cuts off the part where `inside`, which is linear along the piece, is negative; nothing if that is all.
template <typename Inside>
std::optional<LinePiece> cut(const LinePiece& piece, Inside inside) {
  const double from = inside(piece.from), to = inside(piece.to);
  if (!(from >= 0 || to >= 0)) return std::nullopt;
  if (from >= 0 && to >= 0) return piece;
  const math::Vec3d border = piece.from + (piece.to - piece.from) * (from / (from - to));
  return from >= 0 ? LinePiece{piece.from, border} : LinePiece{border, piece.to};
}

int to_pixel(double at, int axis, const ViewFrame& view) {
  return std::clamp(static_cast<int>(std::lround(at)), 0, (axis == 0 ? view.width : view.height) - 1);
}

// `depth`: the frame's, for a line with a depth test; otherwise empty.
void draw_piece(const LinePiece& piece, formats::Rgb color, const ViewFrame& view,
                std::span<const float> depth, Painter& io_painter) {
  const LineSteps steps = find_line_steps(piece, view);
  for (int i = steps.first; i <= steps.last; ++i) {
    const math::Vec3d at = steps.at(i);
    const int j = to_pixel(at[steps.across], steps.across, view);
    const int x = steps.along == 0 ? i : j, y = steps.along == 0 ? j : i;
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(x);
    if (!depth.empty() && at.z + std::abs(at.z) * kLineDepthSlack < depth[pixel]) continue;
    io_painter.put(pixel, color);
  }
}

bool is_finite(const math::Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

std::optional<LinePiece> project_line(const Line& line, const ViewFrame& view) {
  if (!is_finite(line.from_world) || !is_finite(line.to_world)) return std::nullopt;
  const LinePiece whole{view.to_view(math::Vec3d(line.from_world)), view.to_view(math::Vec3d(line.to_world))};
  const auto before_eye = cut(whole, [&](const math::Vec3d& p) { return p.z - view.near_z; });
  if (!before_eye) return std::nullopt;
  // The cut may be nearer by a rounding error.
  const auto to_screen = [&](math::Vec3d p) {
    p.z = std::max(p.z, view.near_z);
    return math::Vec3d(view.to_screen(p), view.depth(p.z));
  };
  std::optional<LinePiece> seen = LinePiece{to_screen(before_eye->from), to_screen(before_eye->to)};
  for (int axis = 0; axis < 2 && seen; ++axis) {
    const int last = (axis == 0 ? view.width : view.height) - 1;
    seen = cut(*seen, [&](const math::Vec3d& p) { return p[axis]; });
    if (seen) seen = cut(*seen, [&](const math::Vec3d& p) { return last - p[axis]; });
  }
  return seen;
}

LineSteps find_line_steps(const LinePiece& piece, const ViewFrame& view) {
  const math::Vec3d size = piece.to - piece.from;
  const int along = std::abs(size.x) >= std::abs(size.y) ? 0 : 1;
  const bool is_forward = size[along] >= 0;
  const math::Vec3d &from = is_forward ? piece.from : piece.to, &to = is_forward ? piece.to : piece.from;
  const math::Vec3d slope = size[along] != 0 ? size / size[along] : math::Vec3d(0.0);
  return {along, 1 - along, to_pixel(from[along], along, view), to_pixel(to[along], along, view),
          from,  slope};
}

void draw_lines(std::span<const Line> lines, const ViewFrame& view, const formats::Palette& palette,
                FrameBuffer& io_frame) {
  Painter painter(palette, io_frame);
  for (const Line& line : lines) {
    const std::span<const float> depth =
        line.is_depth_tested ? std::as_const(io_frame).depth() : std::span<const float>();
    if (const auto piece = project_line(line, view)) draw_piece(*piece, line.color, view, depth, painter);
  }
}

}  // namespace temblor::render
