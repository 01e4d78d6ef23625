#include "artgen/pictures/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "artgen/pictures/glyphs.h"
#include "artgen/pictures/words.h"

namespace temblor::artgen::pictures {
namespace {

// Settings that lines of a word have where they do not say their own.
using Settings = std::vector<std::pair<std::string, std::string>>;
using Usual = std::map<std::string, Settings>;

Placement within(const Placement& outer, const Placement& inner) {
  return {outer.to_canvas(inner.at), outer.turn_deg + inner.turn_deg, outer.scale * inner.scale};
}

base::Status draw_shape(const ScriptLine& line, const Placement& placement, Canvas& io_canvas) {
  Arguments arguments(line);
  const Outline outline = read_outline(line.word, arguments, {io_canvas.width(), io_canvas.height()});
  const Ink ink = read_ink(arguments);
  TRY_STATUS(arguments.finish());
  if (!line.below.empty()) return script_error(line.below.front(), "nothing stands below a shape");
  io_canvas.paint(outline, placement, ink);
  return base::Ok{};
}

base::Status draw_words(const ScriptLine& line, const Glyphs& glyphs, const Placement& placement,
                        Canvas& io_canvas) {
  Arguments arguments(line);
  const std::string text = arguments.text();
  const math::Vec2d place = read_point(arguments);
  const Ink ink = read_ink(arguments);
  TRY_STATUS(arguments.finish());
  std::vector<Outline> dots;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto glyph = glyphs.find(static_cast<std::uint8_t>(text[i]));
    if (text[i] == ' ') continue;
    if (glyph == glyphs.end()) return script_error(line, fmt::format("no glyph '{}' stands above", text[i]));
    for (std::int32_t y = 0; y < kGlyphSide; ++y)
      for (std::int32_t x = 0; x < kGlyphSide; ++x) {
        const math::Vec2d dot = place + math::Vec2d{static_cast<double>(i) * kGlyphSide + x, y};
        if (glyph->second.ink(x, y)) dots.push_back(make_box(dot, dot + math::Vec2d{1, 1}, 0));
      }
  }
  for (const Outline& dot : dots) io_canvas.paint(dot, placement, ink);
  return base::Ok{};
}

base::Status change_all(const ScriptLine& line, Canvas& io_canvas) {
  Arguments arguments(line);
  if (line.word == "shade") {
    const double by = arguments.number(0, 4);
    TRY_STATUS(arguments.finish());
    io_canvas.shade(by);
  } else if (line.word == "weather") {
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

base::Status set_usual(const ScriptLine& line, Usual& io_usual) {
  if (line.values.size() != 1 || !is_shape_word(line.values[0]))
    return script_error(line, fmt::format("it is followed by one of {}", shape_words()));
  io_usual[line.values[0]] = line.settings;
  return base::Ok{};
}

ScriptLine with_usual(const ScriptLine& line, const Usual& usual) {
  ScriptLine whole = line;
  const auto settings = usual.find(line.word);
  if (settings == usual.end()) return whole;
  for (const auto& setting : settings->second)
    if (std::none_of(line.settings.begin(), line.settings.end(),
                     [&](const auto& own) { return own.first == setting.first; }))
      whole.settings.push_back(setting);
  return whole;
}

base::Status draw_lines(std::span<const ScriptLine> lines, const Placement& placement, Usual usual,
                        Canvas& io_canvas);

base::Status draw_group(const ScriptLine& line, const Placement& placement, const Usual& usual,
                        Canvas& io_canvas) {
  Arguments arguments(line);
  const Placement inner = read_placement(arguments);
  TRY_STATUS(arguments.finish());
  return draw_lines(line.below, within(placement, inner), usual, io_canvas);
}

base::Status draw_lines(std::span<const ScriptLine> lines, const Placement& placement, Usual usual,
                        Canvas& io_canvas) {
  TRY(const Glyphs glyphs, read_glyphs(lines));
  for (const ScriptLine& line : lines) {
    if (line.word == "glyph") continue;
    if (line.word == "usual")
      TRY_STATUS(set_usual(line, usual));
    else if (is_shape_word(line.word))
      TRY_STATUS(draw_shape(with_usual(line, usual), placement, io_canvas));
    else if (line.word == "group")
      TRY_STATUS(draw_group(line, placement, usual, io_canvas));
    else if (line.word == "write")
      TRY_STATUS(draw_words(line, glyphs, placement, io_canvas));
    else if (line.word == "tint" || line.word == "shade" || line.word == "weather")
      TRY_STATUS(change_all(line, io_canvas));
    else
      return script_error(
          line,
          fmt::format("pictures know {}, group, usual, write, tint, shade, weather, glyph", shape_words()));
  }
  return base::Ok{};
}

}  // namespace

base::Status draw(std::span<const ScriptLine> lines, const Placement& placement, Canvas& io_canvas) {
  return draw_lines(lines, placement, {}, io_canvas);
}

}  // namespace temblor::artgen::pictures
