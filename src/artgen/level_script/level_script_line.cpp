#include "artgen/level_script/level_script_line.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>
#include <vector>

#include "base/text.h"

namespace temblor::artgen {
namespace {

// Larger than any level that the BSP format supports.
constexpr int kMaxCoordinate = 16384;

// In the order of Side.
constexpr std::array<std::string_view, 6> kSideNames = {"east", "west", "north", "south", "up", "down"};
// In the order of Side: the settings for the textures of a space's sides.
constexpr std::array<std::string_view, 6> kSurfaceNames = {"east",  "west",    "north",
                                                           "south", "ceiling", "floor"};

// Accepts a leading plus, as in "mid+16".
std::optional<int> parse_integer(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  int value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size()) return {};
  return value >= -kMaxCoordinate && value <= kMaxCoordinate ? std::optional(value) : std::nullopt;
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

// "WxDxH", each at least 1.
std::optional<Point> parse_size(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, 'x');
  if (parts.size() != 3) return {};
  Point size(0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<int> part = parse_integer(parts[static_cast<std::size_t>(axis)]);
    if (!part || *part < 1) return {};
    size[axis] = *part;
  }
  return size;
}

bool is_position(std::string_view text) {
  return text.find(',') != std::string_view::npos;
}

}  // namespace

std::optional<Side> find_side(std::string_view name) {
  for (const Side side : kSides)
    if (kSideNames[side_index(side)] == name) return side;
  return {};
}

// After an error, a missing number counts as 0.
int LevelScriptLine::parse_coordinate(std::string_view text, int axis) {
  std::string_view rest = text;
  int value = 0;
  for (const bool end : {false, true}) {
    if (!rest.starts_with(end ? "end" : "mid")) continue;
    if (scope_.size[axis] == 0) set_error("'mid' and 'end' need a room around this line");
    value = end ? scope_.size[axis] : scope_.size[axis] / 2;
    rest.remove_prefix(3);
    if (rest.empty()) return value;
    break;
  }
  const std::optional<int> number = parse_integer(rest);
  if (!number)
    set_error(fmt::format("'{}' is not a coordinate: expected a whole number, mid or end, or mid+N or end-N",
                          base::quotable(text)));
  return value + number.value_or(0);
}

// `default_z` is the height of a position with two coordinates.
Point LevelScriptLine::parse_position(const std::string& text, int default_z) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 2 && parts.size() != 3) {
    set_error(fmt::format("'{}' is not a position X,Y or X,Y,Z", base::quotable(text)));
    return Point(0);
  }
  Point point(0, 0, default_z);
  for (std::size_t i = 0; i < parts.size(); ++i)
    point[static_cast<int>(i)] = parse_coordinate(parts[i], static_cast<int>(i));
  return point;
}

Point LevelScriptLine::position(int default_z) {
  return parse_position(next_text(), default_z);
}

Box LevelScriptLine::box() {
  const Point from = position();
  const std::string how = next_text();
  Point to = from;
  if (how == "to") {
    to = position(scope_.size.z);
  } else if (how == "size") {
    const std::string text = next_text();
    const std::optional<Point> size = parse_size(text);
    if (!size) set_error(fmt::format("'{}' is not a size WxDxH", base::quotable(text)));
    to = from + size.value_or(Point(1));
  } else {
    set_error(fmt::format("expected 'to' or 'size' after the first corner of a box, not '{}'",
                          base::quotable(how)));
    return {};
  }
  const Box box = make_bounding_box(from, to);
  if (!box.has_volume())
    set_error(fmt::format("the box {},{},{} to {},{},{} is empty", from.x, from.y, from.z, to.x, to.y, to.z));
  return box;
}

bool LevelScriptLine::is_box_next() const {
  return next_index_ < line_.values.size() && is_position(line_.values[next_index_]);
}

bool LevelScriptLine::is_wall_position_next() const {
  return next_index_ < line_.values.size() && split(line_.values[next_index_], ',').size() == 2;
}

Box LevelScriptLine::box_or(const Box& fallback) {
  return is_box_next() ? box() : fallback;
}

Point LevelScriptLine::wall_position(Side side) {
  const std::string text = next_text();
  const std::vector<std::string_view> parts = split(text, ',');
  if (side_axis(side) == 2 || parts.size() != 2) {
    set_error("on the north, east, south or west wall a position is ALONG,Z");
    return Point(0);
  }
  const int along = 1 - side_axis(side);
  Point point(0);
  point[1 - along] = is_upper(side) ? scope_.size[1 - along] : 0;
  point[along] = parse_coordinate(parts[0], along);
  point.z = parse_coordinate(parts[1], 2);
  return point;
}

Box LevelScriptLine::wall_box(Side side, int depth) {
  const Point from = wall_position(side);
  const std::string how = next_text(), text = next_text();
  const std::optional<Point> size = parse_size(text + "x1");
  if (how != "size" || !size) set_error("expected 'size WxH' after the position on the wall");
  Point to = from + Point(0, 0, size.value_or(Point(1)).y);
  to[1 - side_axis(side) % 2] += size.value_or(Point(1)).x;
  to[side_axis(side) % 2] += is_upper(side) ? -depth : depth;
  return make_bounding_box(from, to);
}

std::string LevelScriptLine::next_text() {
  ++next_index_;
  return substitute_copy(arguments_.text());
}

std::optional<std::string> LevelScriptLine::next_text_if_present() {
  ++next_index_;
  std::optional<std::string> found = arguments_.text_if_present();
  if (found) found = substitute_copy(*found);
  return found;
}

Side LevelScriptLine::side() {
  const std::string name = next_text();
  const std::optional<Side> side = find_side(name);
  if (!side)
    set_error(fmt::format("'{}' is not one of north, east, south, west, up, down", base::quotable(name)));
  return side.value_or(Side::kUp);
}

std::string LevelScriptLine::text(std::string_view name, std::string_view fallback) {
  return substitute_copy(arguments_.text(name, fallback));
}

int LevelScriptLine::integer(std::string_view name, int fallback, int lowest, int highest) {
  return arguments_.integer(name, fallback, lowest, highest);
}

double LevelScriptLine::number(std::string_view name, double fallback, double lowest, double highest) {
  return arguments_.number(name, fallback, lowest, highest);
}

Point LevelScriptLine::position(std::string_view name, Point fallback) {
  if (!has(name)) return fallback;
  return parse_position(arguments_.text(name, ""), fallback.z);
}

Side LevelScriptLine::side(std::string_view name, Side fallback) {
  if (!has(name)) return fallback;
  const std::string text = arguments_.text(name, "");
  const std::optional<Side> side = find_side(text);
  if (!side)
    set_error(
        fmt::format("{}={} is not one of north, east, south, west, up, down", name, base::quotable(text)));
  return side.value_or(fallback);
}

std::optional<double> LevelScriptLine::facing(std::string_view name) {
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
  if (const std::optional<int> yaw = parse_integer(text)) return scope_.placement.apply_angle(*yaw);
  set_error(fmt::format("{}={} must be a compass point (north, southeast ...) or a whole number of degrees",
                        name, base::quotable(text)));
  return {};
}

// The setting of a single wall has priority over walls=, which has priority over `fallback`.
Surfaces LevelScriptLine::surfaces(Surfaces fallback) {
  const std::string walls = text("walls", "");
  for (const Side side : kSides) {
    std::string& surface = fallback[side_index(side)];
    const bool is_wall = side != Side::kUp && side != Side::kDown;
    surface = text(kSurfaceNames[side_index(side)], is_wall && !walls.empty() ? walls : surface);
  }
  return fallback;
}

Looks LevelScriptLine::looks(const Box& box_world, std::string_view fallback) {
  const std::string texture = next_text_if_present().value_or(std::string(fallback));
  Box anchor = box_world;
  if (const std::string align = text("align", "self"); align == "room")
    anchor = to_world({Point(0), scope_.size});
  else if (align != "self")
    set_error("align= must be self or room");
  const double scale = number("scale", 1, 0.125, 16);
  const Point shift = position("shift", Point(0));
  Looks looks;
  for (const Side side : kSides) {
    const std::string_view kind = side == Side::kUp ? "top" : side == Side::kDown ? "bottom" : "side";
    looks[side_index(side)] = {text(kind, texture), anchor, math::Vec2d(scale),
                               math::Vec2d(shift.x, shift.y)};
  }
  return looks;
}

std::string LevelScriptLine::substitute_copy(std::string_view text) const {
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
