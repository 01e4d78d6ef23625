#include "artgen/textures/layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>

#include "artgen/scripts/ramp_names.h"
#include "base/bytes.h"
#include "base/hash.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

std::string describe_unknown_ramp(std::string_view name) {
  std::string names;
  for (const std::string_view ramp : kRampNames) names += fmt::format(" {}", ramp);
  return fmt::format("'{}' is not a color ramp; expected one of{}", base::quotable(name), names);
}

std::optional<Point> parse_pair(std::string_view text, char between) {
  std::array<double, 2> numbers{};
  const std::size_t end = text.find(between);
  if (end == std::string_view::npos) return {};
  const std::array parts = {text.substr(0, end), text.substr(end + 1)};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto [stop, failure] =
        std::from_chars(parts[i].data(), parts[i].data() + parts[i].size(), numbers[i]);
    if (failure != std::errc() || stop != parts[i].data() + parts[i].size() || !(std::abs(numbers[i]) < 1e4))
      return {};
  }
  return Point{numbers[0], numbers[1]};
}

// The settings that every shape accepts; see layer.h.
struct ShapeSettings {
  std::optional<Ramp> ramp;
  std::optional<double> tone;
  double shade = 0, over = 1;
  double raise = 0, bevel = 1;
  double ragged = 0;
  bool cut = false;
};

// Reads the positional color last: values that belong to the shape come before it.
ShapeSettings read_shape_settings(Arguments& arguments) {
  ShapeSettings settings;
  if (const std::optional<std::string> name = arguments.text_if_present()) {
    settings.ramp = find_ramp(*name);
    if (!settings.ramp) arguments.set_error(describe_unknown_ramp(*name));
    if (const std::optional<std::string> tone = arguments.text_if_present()) {
      const auto both = parse_pair(*tone + ",0", ',');
      if (!both) arguments.set_error(fmt::format("'{}' is not a tone", base::quotable(*tone)));
      settings.tone = both.value_or(Point{}).x;
    }
  }
  settings.shade = arguments.number("shade", 0, -1, 1);
  settings.over = arguments.number("over", 1, 0.01, 256);
  settings.ragged = arguments.number("ragged", 0, 0, 64);
  settings.raise = arguments.number("raise", 0, -64, 64);
  settings.bevel = arguments.number("bevel", 1, 0.01, 64);
  settings.cut = arguments.flag("cut");
  return settings;
}

// Copies texels from `painted` where the shape covers them. `ragged` drops texels near the edge at random.
void blend_shape(const Cover& cover, const ShapeSettings& settings, std::uint64_t seed,
                 const Surface& painted, Surface& io_surface) {
  for (std::size_t i = 0; i < io_surface.cells.size(); ++i) {
    const double depth = cover.cells[i];
    if (depth <= 0 || depth < settings.ragged * hash_noise(static_cast<std::int32_t>(i), 0, seed)) continue;
    Texel& texel = io_surface.cells[i];
    texel = painted.cells[i];
    texel.tone += settings.shade * std::min(depth / settings.over, 1.0);
    texel.height += settings.raise * std::min(depth / settings.bevel, 1.0);
    if (settings.cut) texel.hole = true;
  }
}

// A ramp also fills holes; a tone alone does not.
void set_color(const ShapeSettings& settings, Surface& io_surface) {
  for (Texel& texel : io_surface.cells) {
    if (settings.ramp) texel.ramp = *settings.ramp;
    if (settings.tone) texel.tone = *settings.tone;
    if (settings.ramp) texel.hole = false;
  }
}

// The layers under a shape are painted over a copy of the whole surface, which wraps as the surface does.
// Then the covered texels are taken from it.
base::Status paint_shape(const ShapeKeyword& word, const ScriptLine& line, std::uint64_t seed,
                         Surface& io_surface) {
  Arguments arguments(line);
  Layer layer{arguments, seed};
  const Cover cover = word.cover(layer, io_surface);
  const ShapeSettings settings = read_shape_settings(arguments);
  TRY_STATUS(arguments.finish());
  Surface painted = io_surface;
  set_color(settings, painted);
  TRY_STATUS(paint_layers(line.below, seed, painted));
  blend_shape(cover, settings, seed, painted, io_surface);
  return base::Ok{};
}

// An inlay is a surface of its own, which wraps at its own sides, copied into a rectangle of the surface.
base::Status paint_inlay(const ScriptLine& line, std::uint64_t seed, Surface& io_surface) {
  Arguments arguments(line);
  const Point at = read_point(arguments, "at", {});
  const Point size = read_extent(arguments, "size", {16, 16});
  const ShapeSettings settings = read_shape_settings(arguments);
  const auto left = static_cast<std::int32_t>(at.x), top = static_cast<std::int32_t>(at.y);
  const auto width = static_cast<std::int32_t>(size.x), height = static_cast<std::int32_t>(size.y);
  if (width < 1 || height < 1 || width > io_surface.width || height > io_surface.height)
    arguments.set_error(
        fmt::format("size={}x{} is not inside {}x{}", width, height, io_surface.width, io_surface.height));
  TRY_STATUS(arguments.finish());
  Surface inlay(width, height);
  set_color(settings, inlay);
  TRY_STATUS(paint_layers(line.below, seed, inlay));
  for (std::int32_t y = 0; y < height; ++y)
    for (std::int32_t x = 0; x < width; ++x) {
      const double depth = std::min({x, y, width - 1 - x, height - 1 - y}) + 0.5;
      const double height_below = io_surface.at(left + x, top + y).height;
      Texel& texel = io_surface.at(left + x, top + y) = inlay.at(x, y);
      texel.height += height_below + settings.raise * std::min(depth / settings.bevel, 1.0);
      texel.tone += settings.shade;
      if (settings.cut) texel.hole = true;
    }
  return base::Ok{};
}

// Null if no table has the keyword.
template <typename Word>
const Word* find_keyword(std::span<const std::span<const Word>> tables, std::string_view word) {
  for (const std::span<const Word> table : tables)
    for (const Word& known : table)
      if (known.keyword == word) return &known;
  return nullptr;
}

base::Status paint_layer(const ScriptLine& line, std::uint64_t seed, Surface& io_surface) {
  if (line.keyword == "inlay") return paint_inlay(line, seed, io_surface);
  const std::array shapes = {drawn_keywords(), grown_keywords()};
  if (const ShapeKeyword* shape = find_keyword<ShapeKeyword>(shapes, line.keyword))
    return paint_shape(*shape, line, seed, io_surface);
  const std::array layers = {material_keywords(), structure_keywords(), relief_keywords()};
  const LayerKeyword* layer_keyword = find_keyword<LayerKeyword>(layers, line.keyword);
  if (layer_keyword == nullptr) return script_error(line, "unknown texture layer");
  if (!line.below.empty()) return script_error(line.below.front(), "no line can be under this layer");
  Arguments arguments(line);
  Layer layer{arguments, seed};
  layer_keyword->paint(layer, io_surface);
  return arguments.finish();
}

}  // namespace

// The seed of a layer comes from its keyword and from the number of earlier lines with that keyword. So an
// additional line changes other layers only if it has the same keyword.
base::Status paint_layers(std::span<const ScriptLine> lines, std::uint64_t seed, Surface& io_surface) {
  std::map<std::string_view, std::uint64_t> keyword_counts;
  for (const ScriptLine& line : lines) {
    const std::uint64_t word = base::hash_bytes(base::as_bytes(line.keyword));
    TRY_STATUS(paint_layer(line, base::hash_with(base::hash_with(seed, word), keyword_counts[line.keyword]++),
                           io_surface));
  }
  return base::Ok{};
}

Point read_point(Arguments& arguments, std::string_view name, Point fallback) {
  if (!arguments.has(name)) return fallback;
  const std::string text = arguments.text(name, "");
  const std::optional<Point> found = parse_pair(text, ',');
  if (!found) arguments.set_error(fmt::format("{}={} is not X,Y", name, base::quotable(text)));
  return found.value_or(fallback);
}

Point read_extent(Arguments& arguments, std::string_view name, Point fallback) {
  if (!arguments.has(name)) return fallback;
  const std::string text = arguments.text(name, "");
  const std::string both = text.find('x') == std::string::npos ? fmt::format("{}x{}", text, text) : text;
  const std::optional<Point> found = parse_pair(both, 'x');
  if (!found || found->x <= 0 || found->y <= 0) {
    arguments.set_error(fmt::format("{}={} is not WIDTHxHEIGHT", name, base::quotable(text)));
    return fallback;
  }
  return *found;
}

std::optional<Ramp> find_ramp(std::string_view name) {
  const auto found = std::find(kRampNames.begin(), kRampNames.end(), name);
  if (found == kRampNames.end()) return {};
  return static_cast<Ramp>(found - kRampNames.begin());
}

Ramp read_ramp(Arguments& arguments, std::string_view name, Ramp fallback) {
  if (!arguments.has(name)) return fallback;
  const std::string text = arguments.text(name, "");
  const std::optional<Ramp> found = find_ramp(text);
  if (!found) arguments.set_error(describe_unknown_ramp(text));
  return found.value_or(fallback);
}

NoiseLumps read_lumps(Arguments& arguments, const Surface& surface, Point default_lump,
                      std::int32_t default_octaves) {
  const Point lump = read_extent(arguments, "lump", default_lump);
  return make_lumps(surface, lump, arguments.integer("octaves", default_octaves, 1, 6));
}

NoiseLumps make_lumps(const Surface& surface, Point lump, std::int32_t octaves) {
  return {count_repeats(surface.width, lump.x), count_repeats(surface.height, lump.y), octaves};
}

std::int32_t count_repeats(double side, double length) {
  return std::max(1, static_cast<std::int32_t>(std::lround(side / length)));
}

double wrap(double value, double period) {
  return value - period * std::floor(value / period);
}

}  // namespace temblor::artgen
