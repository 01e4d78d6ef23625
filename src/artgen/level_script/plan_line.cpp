#include "artgen/level_script/plan_line.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>
#include <vector>

#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr int kFarthest = 16384;

constexpr std::array<std::string_view, 6> kSideNames = {"east", "west", "north", "south", "up", "down"};
// The settings that give a space's sides their textures.
constexpr std::array<std::string_view, 6> kSurfaceNames = {"east",  "west",    "north",
                                                           "south", "ceiling", "floor"};

std::optional<int> whole_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  int value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size()) return {};
  return value >= -kFarthest && value <= kFarthest ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<Point> size_in(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, 'x');
  if (parts.size() != 3) return {};
  Point size(0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<int> part = whole_in(parts[static_cast<std::size_t>(axis)]);
    if (!part || *part < 1) return {};
    size[axis] = *part;
  }
  return size;
}

bool looks_like_place(std::string_view text) {
  return text.find(',') != std::string_view::npos;
}

}  // namespace

std::optional<Side> side_named(std::string_view name) {
  for (const Side side : kSides)
    if (kSideNames[index_of(side)] == name) return side;
  return {};
}

int PlanLine::parse_coordinate(std::string_view text, int axis) {
  std::string_view rest = text;
  int value = 0;
  for (const bool end : {false, true}) {
    if (!rest.starts_with(end ? "end" : "mid")) continue;
    if (scope_.size[axis] == 0) complain("'mid' and 'end' are those of a room, and this line is in none");
    value = end ? scope_.size[axis] : scope_.size[axis] / 2;
    rest.remove_prefix(3);
    if (rest.empty()) return value;
    break;
  }
  const std::optional<int> number = whole_in(rest);
  if (!number)
    complain(fmt::format("'{}' is no coordinate: a whole number, or mid or end with one added",
                         base::quotable(text)));
  return value + number.value_or(0);
}

Point PlanLine::parse_place(const std::string& text, int z_otherwise) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 2 && parts.size() != 3) {
    complain(fmt::format("'{}' is no place: X,Y or X,Y,Z", base::quotable(text)));
    return Point(0);
  }
  Point point(0, 0, z_otherwise);
  for (std::size_t i = 0; i < parts.size(); ++i)
    point[static_cast<int>(i)] = parse_coordinate(parts[i], static_cast<int>(i));
  return point;
}

Point PlanLine::place(int z_otherwise) {
  return parse_place(word(), z_otherwise);
}

Box PlanLine::box() {
  const Point from = place();
  const std::string how = word();
  Point to = from;
  if (how == "to") {
    to = place(scope_.size.z);
  } else if (how == "size") {
    const std::string text = word();
    const std::optional<Point> size = size_in(text);
    if (!size) complain(fmt::format("'{}' is no size: WxDxH", base::quotable(text)));
    to = from + size.value_or(Point(1));
  } else {
    complain(fmt::format("after its first corner a box has 'to' or 'size', not '{}'", base::quotable(how)));
    return {};
  }
  const Box box = box_around(from, to);
  if (!box.has_volume())
    complain(fmt::format("the box {},{},{} to {},{},{} is empty", from.x, from.y, from.z, to.x, to.y, to.z));
  return box;
}

bool PlanLine::box_is_next() const {
  return taken_ < line_.values.size() && looks_like_place(line_.values[taken_]);
}

bool PlanLine::on_wall_is_next() const {
  return taken_ < line_.values.size() && split(line_.values[taken_], ',').size() == 2;
}

Box PlanLine::box_or(const Box& otherwise) {
  return box_is_next() ? box() : otherwise;
}

Point PlanLine::place_on_wall(Side side) {
  const std::string text = word();
  const std::vector<std::string_view> parts = split(text, ',');
  if (axis_of(side) == 2 || parts.size() != 2) {
    complain("what hangs on the north, east, south or west wall has a place ALONG,Z there");
    return Point(0);
  }
  const int along = 1 - axis_of(side);
  Point point(0);
  point[1 - along] = is_upper(side) ? scope_.size[1 - along] : 0;
  point[along] = parse_coordinate(parts[0], along);
  point.z = parse_coordinate(parts[1], 2);
  return point;
}

Box PlanLine::box_on_wall(Side side, int depth) {
  const Point from = place_on_wall(side);
  const std::string how = word(), text = word();
  const std::optional<Point> size = size_in(text + "x1");
  if (how != "size" || !size) complain("what hangs on a wall has 'size' and WxH after its place");
  Point to = from + Point(0, 0, size.value_or(Point(1)).y);
  to[1 - axis_of(side) % 2] += size.value_or(Point(1)).x;
  to[axis_of(side) % 2] += is_upper(side) ? -depth : depth;
  return box_around(from, to);
}

std::string PlanLine::word() {
  ++taken_;
  return with_copy(arguments_.text());
}

std::optional<std::string> PlanLine::word_if_there() {
  ++taken_;
  std::optional<std::string> found = arguments_.text_if_there();
  if (found) found = with_copy(*found);
  return found;
}

Side PlanLine::side() {
  const std::string name = word();
  const std::optional<Side> side = side_named(name);
  if (!side)
    complain(fmt::format("'{}' is none of north, east, south, west, up, down", base::quotable(name)));
  return side.value_or(Side::kUp);
}

std::string PlanLine::text(std::string_view name, std::string_view otherwise) {
  return with_copy(arguments_.text(name, otherwise));
}

int PlanLine::whole(std::string_view name, int otherwise, int lowest, int highest) {
  return arguments_.integer(name, otherwise, lowest, highest);
}

double PlanLine::number(std::string_view name, double otherwise, double lowest, double highest) {
  return arguments_.number(name, otherwise, lowest, highest);
}

Point PlanLine::place(std::string_view name, Point otherwise) {
  if (!has(name)) return otherwise;
  return parse_place(arguments_.text(name, ""), otherwise.z);
}

Side PlanLine::side(std::string_view name, Side otherwise) {
  if (!has(name)) return otherwise;
  const std::string text = arguments_.text(name, "");
  const std::optional<Side> side = side_named(text);
  if (!side)
    complain(fmt::format("{}={} is none of north, east, south, west, up, down", name, base::quotable(text)));
  return side.value_or(otherwise);
}

std::optional<double> PlanLine::facing(std::string_view name) {
  if (!has(name)) return {};
  const std::string text = arguments_.text(name, "");
  constexpr std::array<std::pair<std::string_view, int>, 8> kCompass = {{{"east", 0},
                                                                         {"northeast", 45},
                                                                         {"north", 90},
                                                                         {"northwest", 135},
                                                                         {"west", 180},
                                                                         {"southwest", 225},
                                                                         {"south", 270},
                                                                         {"southeast", 315}}};
  for (const auto& [point, yaw] : kCompass)
    if (point == text) return scope_.placement.apply_angle(yaw);
  if (const std::optional<int> yaw = whole_in(text)) return scope_.placement.apply_angle(*yaw);
  complain(fmt::format("{}={} is neither a compass point nor degrees", name, base::quotable(text)));
  return {};
}

Surfaces PlanLine::surfaces(Surfaces otherwise) {
  const std::string walls = text("walls", "");
  for (const Side side : kSides) {
    std::string& surface = otherwise[index_of(side)];
    const bool is_wall = side != Side::kUp && side != Side::kDown;
    surface = text(kSurfaceNames[index_of(side)], is_wall && !walls.empty() ? walls : surface);
  }
  return otherwise;
}

Looks PlanLine::looks(const Box& box_world, std::string_view otherwise) {
  const std::string texture = word_if_there().value_or(std::string(otherwise));
  Box anchor = box_world;
  if (const std::string align = text("align", "self"); align == "room")
    anchor = to_world({Point(0), scope_.size});
  else if (align != "self")
    complain("align= is self or room");
  const double scale = number("scale", 1, 0.125, 16);
  const Point shift = place("shift", Point(0));
  Looks looks;
  for (const Side side : kSides) {
    const std::string_view kind = side == Side::kUp ? "top" : side == Side::kDown ? "bottom" : "side";
    looks[index_of(side)] = {text(kind, texture), anchor, math::Vec2d(scale), math::Vec2d(shift.x, shift.y)};
  }
  return looks;
}

std::string PlanLine::with_copy(std::string_view text) const {
  std::string out;
  for (const char c : text) {
    if (c == '$')
      out += scope_.copy;
    else
      out += c;
  }
  return out;
}

}  // namespace temblor::artgen
