// A recursive descent parser: one member function for each part of the grammar in map.h. Errors name the
// current entity and brush, counted from 0 as in the comments of editors, and the line.
#include "formats/levels/map.h"

#include <cmath>
#include <span>
#include <utility>

#include "base/text.h"
#include "formats/levels/map/scanner.h"

namespace temblor::formats {
namespace {

class MapReader {
 public:
  explicit MapReader(std::string_view text) : scanner_(text) {}

  base::Result<Map> read();

 private:
  base::Status read_entity();
  base::Status read_pair(Entity& io_fields);
  base::Status read_brush(std::vector<MapBrush>& io_brushes);
  base::Status read_sides(std::vector<MapSide>& io_sides);
  base::Status read_patch();
  base::Status read_side(MapSide& out_side);
  base::Status read_texture(std::string& out_name);
  base::Status read_standard(MapTexturing& out_texturing);
  base::Status read_valve(MapTexturing& out_texturing);
  base::Status read_rotation_and_scale(MapTexturing& io_texturing);
  base::Status read_matrix(MapTexturing& out_texturing);
  base::Status read_flags(std::optional<MapSideFlags>& out_flags);
  base::Status read_row(char open, std::span<double> out_numbers, char close);
  base::Status read_point(math::Vec3d& out_point);
  base::Status read_number(double& out_number);
  base::Status expect(char expected);

  template <typename... Args>
  base::Error malformed(fmt::format_string<Args...> format, Args&&... args) {
    return malformed_on(scanner_.line(), format, std::forward<Args>(args)...);
  }
  template <typename... Args>
  base::Error malformed_on(std::uint32_t line, fmt::format_string<Args...> format, Args&&... args) const {
    return base::malformed("{}line {}: {}", place(), line, fmt::format(format, std::forward<Args>(args)...));
  }
  std::string place() const;
  std::string next_token();

  map::Scanner scanner_;
  Map map_;
  bool in_entity_ = false;
  std::optional<std::size_t> brush_;  // index of the current brush; patches count too
  std::size_t brushes_begun_ = 0;
};

std::string MapReader::place() const {
  if (!in_entity_) return "";
  std::string place = fmt::format("entity {}", map_.entities.size() - 1);
  if (const std::string_view name = map_.entities.back().fields.classname(); !name.empty())
    place += fmt::format(" ({})", base::quotable(name));
  if (brush_) place += fmt::format(", brush {}", *brush_);
  return place + ", ";
}

std::string MapReader::next_token() {
  if (scanner_.peek() == '\0') return "the end of the text";
  return fmt::format("\"{}\"", base::quotable(scanner_.run()));
}

base::Status MapReader::expect(char expected) {
  if (scanner_.accept(expected)) return base::Ok{};
  const std::uint32_t line = scanner_.line();
  return malformed_on(line, "expected \"{}\", found {}", expected, next_token());
}

base::Status MapReader::read_number(double& out_number) {
  const auto number = scanner_.number();
  if (!number) {
    const std::uint32_t line = scanner_.line();
    return malformed_on(line, "expected a finite number, found {}", next_token());
  }
  out_number = *number;
  return base::Ok{};
}

base::Status MapReader::read_row(char open, std::span<double> out_numbers, char close) {
  TRY_STATUS(expect(open));
  for (double& number : out_numbers) TRY_STATUS(read_number(number));
  return expect(close);
}

base::Status MapReader::read_point(math::Vec3d& out_point) {
  const std::uint32_t line = scanner_.line();
  std::array<double, 3> numbers{};
  TRY_STATUS(read_row('(', numbers, ')'));
  for (const double number : numbers)
    if (std::abs(number) > kMapMaxCoordinate)
      return malformed_on(line, "the coordinate {} is beyond +-{}", number, kMapMaxCoordinate);
  out_point = {numbers[0], numbers[1], numbers[2]};
  return base::Ok{};
}

base::Status MapReader::read_texture(std::string& out_name) {
  if (scanner_.peek() != '"') {
    out_name = scanner_.run();
    return out_name.empty() ? base::Status(malformed("the text ends, expected a texture name")) : base::Ok{};
  }
  const auto name = scanner_.quoted();
  if (!name) return malformed("this quote is not closed on its line");
  out_name = *name;
  return base::Ok{};
}

base::Status MapReader::read_rotation_and_scale(MapTexturing& io_texturing) {
  TRY_STATUS(read_number(io_texturing.rotation_deg));
  for (const int axis : {0, 1}) {
    TRY_STATUS(read_number(io_texturing.scale[axis]));
    if (io_texturing.scale[axis] == 0) io_texturing.scale[axis] = 1;
  }
  return base::Ok{};
}

base::Status MapReader::read_standard(MapTexturing& out_texturing) {
  out_texturing.alignment = MapAlignment::kStandard;
  TRY_STATUS(read_number(out_texturing.offset.x));
  TRY_STATUS(read_number(out_texturing.offset.y));
  return read_rotation_and_scale(out_texturing);
}

base::Status MapReader::read_valve(MapTexturing& out_texturing) {
  out_texturing.alignment = MapAlignment::kValve;
  std::array<double, 4> s{}, t{};
  TRY_STATUS(read_row('[', s, ']'));
  TRY_STATUS(read_row('[', t, ']'));
  out_texturing.s_axis = {s[0], s[1], s[2]};
  out_texturing.t_axis = {t[0], t[1], t[2]};
  out_texturing.offset = {s[3], t[3]};
  return read_rotation_and_scale(out_texturing);
}

base::Status MapReader::read_matrix(MapTexturing& out_texturing) {
  out_texturing.alignment = MapAlignment::kBrushPrimitive;
  TRY_STATUS(expect('('));
  for (auto& row : out_texturing.matrix) TRY_STATUS(read_row('(', row, ')'));
  return expect(')');
}

// Reads up to three flags, if there are any. They are 32-bit integers, signed or unsigned; MapSideFlags keeps
// the bits.
base::Status MapReader::read_flags(std::optional<MapSideFlags>& out_flags) {
  const auto is_number_next = [&] {
    const char next = scanner_.peek();
    return (next >= '0' && next <= '9') || next == '-' || next == '+';
  };
  if (!is_number_next()) return base::Ok{};
  out_flags.emplace();
  for (std::int32_t& flag : *out_flags) {
    if (!is_number_next()) break;
    const auto number = scanner_.whole_number();
    if (!number) {
      const std::uint32_t line = scanner_.line();
      return malformed_on(line, "expected the flags of a side (32-bit integers), found {}", next_token());
    }
    flag = *number;
  }
  return base::Ok{};
}

// A matrix comes before the texture name, the other alignments after it, so the next character decides.
base::Status MapReader::read_side(MapSide& out_side) {
  out_side.line = scanner_.line();
  for (math::Vec3d& point : out_side.points_world) TRY_STATUS(read_point(point));
  if (scanner_.peek() == '(') {
    TRY_STATUS(read_matrix(out_side.texturing));
    TRY_STATUS(read_texture(out_side.texture));
  } else {
    TRY_STATUS(read_texture(out_side.texture));
    TRY_STATUS(scanner_.peek() == '[' ? read_valve(out_side.texturing) : read_standard(out_side.texturing));
  }
  return read_flags(out_side.flags);
}

base::Status MapReader::read_sides(std::vector<MapSide>& io_sides) {
  while (scanner_.peek() == '(') TRY_STATUS(read_side(io_sides.emplace_back()));
  return base::Ok{};
}

// Skips a patch. Its texture name may start with a brace; everything after it is numbers and parentheses, so
// the next brace ends it.
base::Status MapReader::read_patch() {
  TRY_STATUS(expect('{'));
  std::string texture;
  TRY_STATUS(read_texture(texture));
  for (char next = scanner_.peek(); next != '}' && next != '{' && next != '\0'; next = scanner_.peek())
    if (scanner_.word().empty()) break;
  return expect('}');
}

base::Status MapReader::read_brush(std::vector<MapBrush>& io_brushes) {
  MapBrush brush;
  brush.line = scanner_.line();
  brush_ = brushes_begun_++;
  TRY_STATUS(expect('{'));
  bool is_patch = false;
  while (!scanner_.accept('}')) {
    const char next = scanner_.peek();
    if (next == '\0') return malformed_on(brush.line, "this brush is never closed");
    if (next == '{') return malformed("unexpected brace inside of the brush from line {}", brush.line);
    if (next == '(') {
      TRY_STATUS(read_sides(brush.sides));
      continue;
    }
    const std::uint32_t line = scanner_.line();
    const std::string_view keyword = scanner_.word();
    if (keyword == "patchDef2" || keyword == "patchDef3") {
      TRY_STATUS(read_patch());
      is_patch = true;
    } else if (keyword == "brushDef") {
      TRY_STATUS(expect('{'));
      TRY_STATUS(read_sides(brush.sides));
      TRY_STATUS(expect('}'));
    } else {
      return malformed_on(line, "expected a side or the closing brace of the brush, found \"{}\"",
                          base::quotable(keyword.empty() ? scanner_.run() : keyword));
    }
  }
  brush_.reset();
  if (!is_patch || !brush.sides.empty()) io_brushes.push_back(std::move(brush));
  return base::Ok{};
}

base::Status MapReader::read_pair(Entity& io_fields) {
  const std::uint32_t line = scanner_.line();
  const auto is_text_next = [&] {
    const char next = scanner_.peek();
    return next != '\0' && next != '{' && next != '}';
  };
  constexpr std::string_view kNotClosed = "this quote is not closed on its line";

  std::string_view key;
  if (scanner_.peek() != '"') {
    key = scanner_.word();
  } else if (const auto quoted = scanner_.quoted()) {
    key = *quoted;
  } else {
    return malformed("{}", kNotClosed);
  }
  if (!is_text_next()) return malformed_on(line, "the key \"{}\" has no value", base::quotable(key));

  if (scanner_.peek() != '"') {
    io_fields.pairs.emplace_back(key, scanner_.word());
  } else if (auto value = scanner_.quoted_value()) {
    io_fields.pairs.emplace_back(key, std::move(*value));
  } else {
    return malformed("{}", kNotClosed);
  }
  return base::Ok{};
}

// The entity is added to the map before its contents are read, so that errors can name it.
base::Status MapReader::read_entity() {
  const std::uint32_t line = scanner_.line();
  if (!scanner_.accept('{'))
    return malformed_on(line, "expected the opening brace of an entity, found {}", next_token());
  MapEntity& entity = map_.entities.emplace_back();
  entity.line = line;
  in_entity_ = true;
  brushes_begun_ = 0;
  while (!scanner_.accept('}')) {
    const char next = scanner_.peek();
    if (next == '\0') return malformed_on(line, "this entity is never closed");
    TRY_STATUS(next == '{' ? read_brush(entity.brushes) : read_pair(entity.fields));
  }
  in_entity_ = false;
  return base::Ok{};
}

base::Result<Map> MapReader::read() {
  while (scanner_.peek() != '\0') TRY_STATUS(read_entity());
  return std::move(map_);
}

}  // namespace

base::Result<Map> read_map(std::string_view text) {
  return MapReader(text).read();
}

}  // namespace temblor::formats
