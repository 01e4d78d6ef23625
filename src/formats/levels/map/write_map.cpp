// Writes .map texts in the style of editors: one side in each line, and comments with the numbers of entities
// and brushes. Numbers are written with as many digits as reading them back needs.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "formats/levels/map.h"

namespace temblor::formats {
namespace {

using Out = std::back_insert_iterator<std::string>;

void write_vector(Out out, const math::Vec3d& vector) {
  fmt::format_to(out, "{} {} {}", vector.x, vector.y, vector.z);
}

// Quotes a name that would be read as something else without quotes. After a matrix, a parenthesis belongs to
// the name.
void write_texture(Out out, const MapSide& side) {
  const std::string_view name = side.texture;
  const bool opens_matrix =
      name.starts_with('(') && side.texturing.alignment != MapAlignment::kBrushPrimitive;
  const bool is_bare =
      !name.empty() && !opens_matrix && !name.starts_with(';') && !name.starts_with("//") &&
      std::ranges::none_of(name, [](char c) { return static_cast<unsigned char>(c) <= ' '; });
  const std::string_view quote = is_bare ? "" : "\"";
  fmt::format_to(out, " {}{}{}", quote, name, quote);
}

void write_texturing(Out out, const MapSide& side) {
  const MapTexturing& texturing = side.texturing;
  switch (texturing.alignment) {
    case MapAlignment::kBrushPrimitive: {
      const auto& [s, t] = texturing.matrix;
      fmt::format_to(out, " ( ( {} {} {} ) ( {} {} {} ) )", s[0], s[1], s[2], t[0], t[1], t[2]);
      write_texture(out, side);
      return;
    }
    case MapAlignment::kStandard:
      write_texture(out, side);
      fmt::format_to(out, " {} {}", texturing.offset.x, texturing.offset.y);
      break;
    case MapAlignment::kValve:
      write_texture(out, side);
      fmt::format_to(out, " [ ");
      write_vector(out, texturing.s_axis);
      fmt::format_to(out, " {} ] [ ", texturing.offset.x);
      write_vector(out, texturing.t_axis);
      fmt::format_to(out, " {} ]", texturing.offset.y);
      break;
  }
  fmt::format_to(out, " {} {} {}", texturing.rotation_deg, texturing.scale.x, texturing.scale.y);
}

void write_side(Out out, const MapSide& side) {
  for (const math::Vec3d& point : side.points_world) {
    fmt::format_to(out, "( ");
    write_vector(out, point);
    fmt::format_to(out, " ) ");
  }
  write_texturing(out, side);
  if (side.flags) fmt::format_to(out, " {} {} {}", (*side.flags)[0], (*side.flags)[1], (*side.flags)[2]);
  fmt::format_to(out, "\n");
}

void write_brush(Out out, const MapBrush& brush) {
  const bool has_primitives = std::ranges::any_of(brush.sides, [](const MapSide& side) {
    return side.texturing.alignment == MapAlignment::kBrushPrimitive;
  });
  fmt::format_to(out, "{}", has_primitives ? "{\nbrushDef\n{\n" : "{\n");
  for (const MapSide& side : brush.sides) write_side(out, side);
  fmt::format_to(out, "{}", has_primitives ? "}\n}\n" : "}\n");
}

}  // namespace

std::string write_map(const Map& map) {
  std::string text;
  const Out out = std::back_inserter(text);
  for (std::size_t e = 0; e < map.entities.size(); ++e) {
    const MapEntity& entity = map.entities[e];
    fmt::format_to(out, "// entity {}\n{{\n", e);
    for (const auto& [key, value] : entity.fields.pairs) fmt::format_to(out, "\"{}\" \"{}\"\n", key, value);
    for (std::size_t b = 0; b < entity.brushes.size(); ++b) {
      fmt::format_to(out, "// brush {}\n", b);
      write_brush(out, entity.brushes[b]);
    }
    fmt::format_to(out, "}}\n");
  }
  return text;
}

}  // namespace temblor::formats
