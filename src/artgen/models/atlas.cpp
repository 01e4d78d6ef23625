#include "artgen/models/atlas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace temblor::artgen {
namespace {

using math::Vec2d;

// The widths are tried in order. Stock engines accept skins of at most 480 rows.
constexpr std::array<std::int32_t, 4> kWidths = {64, 128, 256, 512};
constexpr std::int32_t kMaxHeight = 480;
// The factor for the density if no size fits.
constexpr double kThinner = 0.93;

// The bounding box of a chart, in units.
struct ChartBox {
  Vec2d mins{std::numeric_limits<double>::max()}, maxs{std::numeric_limits<double>::lowest()};
};

std::vector<ChartBox> chart_boxes(const Mesh& mesh) {
  std::vector<ChartBox> boxes(mesh.chart_shapes.size());
  for (const MeshTriangle& triangle : mesh.triangles) {
    ChartBox& box = boxes[triangle.chart];
    for (const MeshCorner& corner : triangle.corners) {
      box.mins = glm::min(box.mins, corner.position);
      box.maxs = glm::max(box.maxs, corner.position);
    }
  }
  return boxes;
}

// Shelf packing: charts in rows, the highest first. Returns nothing if they do not fit.
std::optional<Atlas> pack(const std::vector<ChartBox>& boxes, double density, std::int32_t width,
                          std::int32_t max_rows) {
  struct Size {
    std::int32_t across, up;
  };
  Atlas atlas{width, 0, density, std::vector<ChartPlacement>(boxes.size())};
  std::vector<Size> sizes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec2d extent = (boxes[i].maxs - boxes[i].mins) * density;
    atlas.charts[i].swapped = extent.y > extent.x;
    const Vec2d lying = atlas.charts[i].swapped ? Vec2d(extent.y, extent.x) : extent;
    // One free texel on each side, and one because positions are rounded.
    sizes.push_back({static_cast<std::int32_t>(std::ceil(lying.x)) + 3,
                     static_cast<std::int32_t>(std::ceil(lying.y)) + 3});
  }
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a].up > sizes[b].up; });
  std::int32_t x = 0, y = 0, row = 0;
  for (const std::size_t chart : order) {
    const Size& size = sizes[chart];
    if (size.across > width) return {};
    if (x + size.across > width) {
      y += row;
      x = row = 0;
    }
    row = std::max(row, size.up);
    ChartPlacement& position = atlas.charts[chart];
    const Vec2d low = position.swapped ? Vec2d(boxes[chart].mins.y, boxes[chart].mins.x) : boxes[chart].mins;
    position.shift = Vec2d(x + 1, y + 1) - low * density;
    x += size.across;
  }
  atlas.height = y + row;
  if (atlas.height > max_rows) return {};
  return atlas;
}

}  // namespace

Vec2d Atlas::texel(std::uint32_t chart, const Vec2d& position) const {
  const ChartPlacement& at = charts[chart];
  const Vec2d lying = at.swapped ? Vec2d(position.y, position.x) : position;
  return glm::floor(lying * density + at.shift + 0.5);
}

Atlas lay_out_charts(const Mesh& mesh, double density) {
  const std::vector<ChartBox> boxes = chart_boxes(mesh);
  while (true) {
    for (const std::int32_t width : kWidths)
      if (const auto atlas = pack(boxes, density, width, width == kWidths.back() ? kMaxHeight : width))
        return *atlas;
    density *= kThinner;
  }
}

}  // namespace temblor::artgen
