#include "artgen/pictures/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "artgen/pictures/drawing_settings.h"
#include "artgen/pictures/glyphs.h"

namespace temblor::artgen::pictures {
namespace {

// The default settings of each shape keyword, from `usual` lines.
using Settings = std::vector<std::pair<std::string, std::string>>;
using Defaults = std::map<std::string, Settings>;

// The transform that applies `inner` first.
Placement combine(const Placement& outer, const Placement& inner) {
  return {outer.to_canvas(inner.at), outer.turn_deg + inner.turn_deg, outer.scale * inner.scale};
}

base::Status draw_shape(const ScriptLine& line, const Placement& placement, Canvas& io_canvas) {
  Arguments arguments(line);
  const Outline outline = read_outline(line.keyword, arguments, {io_canvas.width(), io_canvas.height()});
  const Ink ink = read_ink(arguments);
  TRY_STATUS(arguments.finish());
  if (!line.below.empty()) return script_error(line.below.front(), "no line can be under a shape");
  io_canvas.paint(outline, placement, ink);
  return base::Ok{};
}

// Writes with a bitmap font: each dot of a glyph becomes a box of one unit.
base::Status draw_text(const ScriptLine& line, const Glyphs& glyphs, const Placement& placement,
                       Canvas& io_canvas) {
  Arguments arguments(line);
  const std::string text = arguments.text();
  const math::Vec2d position = read_point(arguments);
  const Ink ink = read_ink(arguments);
  TRY_STATUS(arguments.finish());
  std::vector<Outline> dots;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto glyph = glyphs.find(static_cast<std::uint8_t>(text[i]));
    if (text[i] == ' ') continue;
    if (glyph == glyphs.end())
      return script_error(line, fmt::format("no glyph '{}' is defined above this line", text[i]));
    for (std::int32_t y = 0; y < kGlyphSide; ++y)
      for (std::int32_t x = 0; x < kGlyphSide; ++x) {
        const math::Vec2d dot = position + math::Vec2d{static_cast<double>(i) * kGlyphSide + x, y};
        if (glyph->second.ink(x, y)) dots.push_back(make_box(dot, dot + math::Vec2d{1, 1}, 0));
      }
  }
  for (const Outline& dot : dots) io_canvas.paint(dot, placement, ink);
  return base::Ok{};
}

// The keywords that change the whole canvas: shade, weather, tint.
base::Status change_canvas(const ScriptLine& line, Canvas& io_canvas) {
  Arguments arguments(line);
  if (line.keyword == "shade") {
    const double by = arguments.number(0, 4);
    TRY_STATUS(arguments.finish());
    io_canvas.shade(by);
  } else if (line.keyword == "weather") {
    const double by = arguments.number(0, 2), lump = arguments.number("lump", 8, 0.2, 1000);
    const std::int32_t seed = arguments.integer("seed", 1, 0, 1 << 30);
    TRY_STATUS(arguments.finish());
    io_canvas.weather(by, lump, static_cast<std::uint64_t>(seed));
  } else {
    const Tone tone = read_tone(arguments, "color", {Ramp::kGray, 0});
    const double by = arguments.number(0, 1);
    const bool rim = arguments.flag("rim");
    TRY_STATUS(arguments.finish());
    io_canvas.tint(tone, by, rim);
  }
  return base::Ok{};
}

base::Status set_defaults(const ScriptLine& line, Defaults& io_defaults) {
  if (line.values.size() != 1 || !is_shape_keyword(line.values[0]))
    return script_error(line, fmt::format("expected one of {}", shape_keywords()));
  io_defaults[line.values[0]] = line.settings;
  return base::Ok{};
}

// Adds the defaults that the line does not set itself.
ScriptLine apply_defaults(const ScriptLine& line, const Defaults& defaults) {
  ScriptLine whole = line;
  const auto settings = defaults.find(line.keyword);
  if (settings == defaults.end()) return whole;
  for (const auto& setting : settings->second)
    if (std::none_of(line.settings.begin(), line.settings.end(),
                     [&](const auto& own) { return own.first == setting.first; }))
      whole.settings.push_back(setting);
  return whole;
}

// `defaults` is passed by value: `usual` lines apply until the end of their group.
base::Status draw_lines(std::span<const ScriptLine> lines, const Placement& placement, Defaults defaults,
                        Canvas& io_canvas);

base::Status draw_group(const ScriptLine& line, const Placement& placement, const Defaults& defaults,
                        Canvas& io_canvas) {
  Arguments arguments(line);
  const Placement inner = read_placement(arguments);
  TRY_STATUS(arguments.finish());
  return draw_lines(line.below, combine(placement, inner), defaults, io_canvas);
}

base::Status draw_lines(std::span<const ScriptLine> lines, const Placement& placement, Defaults defaults,
                        Canvas& io_canvas) {
  TRY(const Glyphs glyphs, read_glyphs(lines));
  for (const ScriptLine& line : lines) {
    if (line.keyword == "glyph") continue;
    if (line.keyword == "usual")
      TRY_STATUS(set_defaults(line, defaults));
    else if (is_shape_keyword(line.keyword))
      TRY_STATUS(draw_shape(apply_defaults(line, defaults), placement, io_canvas));
    else if (line.keyword == "group")
      TRY_STATUS(draw_group(line, placement, defaults, io_canvas));
    else if (line.keyword == "write")
      TRY_STATUS(draw_text(line, glyphs, placement, io_canvas));
    else if (line.keyword == "tint" || line.keyword == "shade" || line.keyword == "weather")
      TRY_STATUS(change_canvas(line, io_canvas));
    else
      return script_error(
          line,
          fmt::format("unknown keyword; pictures have {}, group, usual, write, tint, shade, weather, glyph",
                      shape_keywords()));
  }
  return base::Ok{};
}

}  // namespace

base::Status draw(std::span<const ScriptLine> lines, const Placement& placement, Canvas& io_canvas) {
  return draw_lines(lines, placement, {}, io_canvas);
}

}  // namespace temblor::artgen::pictures
