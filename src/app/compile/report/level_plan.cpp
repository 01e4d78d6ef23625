#include "app/compile/report/level_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>

#include "app/html/html.h"
#include "formats/images/image.h"
#include "formats/images/png.h"

namespace temblor::app {
namespace {

constexpr double kHeatPx = 720, kMarginUnits = 32;

// Translates between the level and the plan, whose unit is the level's, with y down.
struct PlanFrame {
  math::Vec3d mins, maxs;

  double width() const { return maxs.x - mins.x; }
  double height() const { return maxs.y - mins.y; }
  std::pair<int, int> place(const math::Vec3d& point) const {
    return {static_cast<int>(std::lround(point.x - mins.x)), static_cast<int>(std::lround(maxs.y - point.y))};
  }
};

// The bounds of the world's faces. Those of the model hold rooms that were filled, too.
math::Bounds find_drawn_bounds(const world::Level& level) {
  const world::Model& world = level.world();
  if (world.face_count == 0) return world.bounds;
  constexpr float kFar = std::numeric_limits<float>::max();
  math::Bounds bounds{math::Vec3(kFar), math::Vec3(-kFar)};
  for (std::uint32_t i = 0; i < world.face_count; ++i) {
    const world::Face& face = level.faces[world.first_face + i];
    for (std::uint32_t k = 0; k < face.surfedge_count; ++k) {
      const math::Vec3& corner = level.vertices[level.surfedge_start(face.first_surfedge + k)];
      bounds.mins = glm::min(bounds.mins, corner);
      bounds.maxs = glm::max(bounds.maxs, corner);
    }
  }
  return bounds;
}

PlanFrame make_frame(const PlanInput& input) {
  const math::Bounds world = find_drawn_bounds(input.level);
  PlanFrame frame{math::Vec3d(world.mins), math::Vec3d(world.maxs)};
  if (input.leak)
    for (const math::Vec3d& point : input.leak->points_world) {
      frame.mins = glm::min(frame.mins, point);
      frame.maxs = glm::max(frame.maxs, point);
    }
  frame.mins -= kMarginUnits;
  frame.maxs += kMarginUnits;
  return frame;
}

// Finds the largest count on a vertical line through the tree.
class ColumnSearch {
 public:
  ColumnSearch(const world::Level& level, const std::vector<std::uint32_t>& counts)
      : level_(level), counts_(counts) {}

  std::uint32_t find_largest(const math::Vec2d& at, double low, double high) const {
    return find_below(level_.world().head, at, low, high);
  }

 private:
  std::uint32_t find_below(world::Child child, const math::Vec2d& at, double low, double high) const {
    if (child.is_leaf()) return counts_[base::to_size(child.leaf())];
    const world::Node& node = level_.node(child.node());
    const world::Plane& plane = level_.planes[node.plane];
    const math::Vec3d normal(plane.normal);
    const double base = normal.x * at.x + normal.y * at.y - double{plane.distance};
    const double at_low = base + normal.z * low, at_high = base + normal.z * high;
    if (at_low >= 0 && at_high >= 0) return find_below(node.children[0], at, low, high);
    if (at_low < 0 && at_high < 0) return find_below(node.children[1], at, low, high);
    const double middle = -base / normal.z;
    const bool is_front_low = at_low >= 0;
    return std::max(find_below(node.children[is_front_low ? 0 : 1], at, low, middle),
                    find_below(node.children[is_front_low ? 1 : 0], at, middle, high));
  }

  const world::Level& level_;
  const std::vector<std::uint32_t>& counts_;
};

// Returns the heat map as an <image>. Places without open space are transparent.
base::Result<std::string> draw_heat(const PlanInput& input, const PlanFrame& frame) {
  const std::uint32_t largest = std::max(1u, std::ranges::max(input.visible_leaves));
  const double units_per_px = std::max(1.0, std::max(frame.width(), frame.height()) / kHeatPx);
  formats::Image image;
  image.width = static_cast<std::uint32_t>(std::ceil(frame.width() / units_per_px));
  image.height = static_cast<std::uint32_t>(std::ceil(frame.height() / units_per_px));
  const ColumnSearch columns(input.level, input.visible_leaves);
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const math::Vec2d at(frame.mins.x + (x + 0.5) * units_per_px, frame.maxs.y - (y + 0.5) * units_per_px);
      const std::uint32_t count = columns.find_largest(at, frame.mins.z, frame.maxs.z);
      image.pixels.push_back(count == 0 ? 0 : heat_color(double(count) / largest));
    }
  TRY(const base::ByteVector png, formats::write_png(image));
  return fmt::format("<image class=\"heat\" width=\"{:.2f}\" height=\"{:.2f}\" href=\"{}\"/>\n",
                     image.width * units_per_px, image.height * units_per_px, make_png_uri(png));
}

// Collects lines of a plan, each once; vertical ones are only points, and are left out.
class PlanLines {
 public:
  explicit PlanLines(const PlanFrame& frame) : frame_(frame) {}

  void add(const math::Vec3d& from, const math::Vec3d& to) {
    auto a = frame_.place(from), b = frame_.place(to);
    if (b < a) std::swap(a, b);
    if (a != b) lines_.insert({a, b});
  }
  std::string path(const char* name) const {
    std::string text = fmt::format("<path class=\"{}\" d=\"", name);
    for (const auto& [a, b] : lines_)
      text += fmt::format("M{} {}L{} {}", a.first, a.second, b.first, b.second);
    return text + "\"/>\n";
  }

 private:
  const PlanFrame& frame_;
  std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> lines_;
};

std::string draw_walls(const world::Level& level, const PlanFrame& frame) {
  PlanLines lines(frame);
  const world::Model& world = level.world();
  for (std::uint32_t i = 0; i < world.face_count; ++i) {
    const world::Face& face = level.faces[world.first_face + i];
    const auto corner = [&](std::uint32_t k) {
      return math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + k % face.surfedge_count)]);
    };
    for (std::uint32_t k = 0; k < face.surfedge_count; ++k) lines.add(corner(k), corner(k + 1));
  }
  return lines.path("walls");
}

std::string draw_portals(const compiler::PortalSet& portals, const PlanFrame& frame) {
  PlanLines lines(frame);
  for (const compiler::Portal& portal : portals.portals) {
    const std::vector<math::Vec3d>& corners = portal.winding_world;
    for (std::size_t k = 0; k < corners.size(); ++k) lines.add(corners[k], corners[(k + 1) % corners.size()]);
  }
  return lines.path("portals");
}

// Draws a dot of a constant size on the screen: a line of length zero with a round cap.
std::string draw_dot(const PlanFrame& frame, const math::Vec3d& at, const char* name,
                     std::string_view title) {
  const auto [x, y] = frame.place(at);
  return fmt::format("<path class=\"dot {}\" d=\"M{} {}h0\"><title>{}</title></path>\n", name, x, y,
                     escape_html(title));
}

std::string draw_places(const PlanInput& input, const PlanFrame& frame) {
  const double text_units = std::max(frame.width(), frame.height()) / 50;
  std::string text = "<g class=\"places\">\n";
  for (const formats::Entity& entity : input.level.entities)
    if (entity.classname() == "info_player_start")
      if (const auto origin = entity.find_vec3("origin"))
        text += draw_dot(frame, math::Vec3d(*origin), "start", "info_player_start");
  for (std::size_t i = 0; i < input.busy_places.size(); ++i) {
    const auto [x, y] = frame.place(math::Vec3d(input.busy_places[i].center_world));
    text += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{:.0f}\">{}</text>\n", x, y, text_units, i + 1);
  }
  return text + "</g>\n";
}

std::string draw_leak_path(const compiler::LeakPath& leak, const PlanFrame& frame) {
  std::string text = "<g class=\"leak\">\n<path class=\"way\" d=\"";
  for (std::size_t i = 0; i < leak.points_world.size(); ++i) {
    const auto [x, y] = frame.place(leak.points_world[i]);
    text += fmt::format("{}{} {}", i == 0 ? 'M' : 'L', x, y);
  }
  return text + "\"/>\n" + draw_dot(frame, leak.points_world.front(), "inside", leak.classname) +
         draw_dot(frame, leak.points_world.back(), "outside", "outside") + "</g>\n";
}

}  // namespace

// Interpolates between colors that get brighter all the way, so that the map also reads in gray.
std::uint32_t heat_color(double share) {
  constexpr std::array<std::array<double, 3>, 5> kStops = {
      {{40, 42, 96}, {96, 44, 130}, {176, 58, 108}, {230, 116, 62}, {250, 220, 96}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto stop = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  std::uint32_t color = 0xff;
  for (std::size_t k = 0; k < 3; ++k) {
    const double part = kStops[stop][k] + (kStops[stop + 1][k] - kStops[stop][k]) * (at - double(stop));
    color = color << 8 | static_cast<std::uint32_t>(std::lround(part));
  }
  return color;
}

base::Result<std::string> draw_level_plan(const PlanInput& input) {
  const PlanFrame frame = make_frame(input);
  std::string svg = fmt::format(
      "<svg class=\"plan\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" "
      "aria-label=\"the level from above\">\n",
      frame.width(), frame.height());
  if (!input.visible_leaves.empty()) {
    TRY(const std::string heat, draw_heat(input, frame));
    svg += heat;
  }
  svg += draw_walls(input.level, frame) + draw_portals(input.portals, frame) + draw_places(input, frame);
  if (input.leak) svg += draw_leak_path(*input.leak, frame);
  return svg + "</svg>\n";
}

}  // namespace temblor::app
