#include "artgen/textures/layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>

#include "base/bytes.h"
#include "base/hash.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

constexpr std::array<std::string_view, 16> kRampNames = {
    "gray", "brown",  "brick", "sand", "red",  "olive", "gold", "teal",
    "blue", "purple", "slate", "rust", "skin", "green", "fire", "electric"};

std::string no_such_ramp(std::string_view name) {
  std::string names;
  for (const std::string_view ramp : kRampNames) names += fmt::format(" {}", ramp);
  return fmt::format("'{}' is no ramp of the palette; there are{}", base::quotable(name), names);
}

std::optional<Point> two_numbers(std::string_view text, char between) {
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

// What every shape knows.
struct ShapeSettings {
  std::optional<Ramp> ramp;
  std::optional<double> tone;
  double shade = 0, over = 1;
  double raise = 0, bevel = 1;
  double ragged = 0;
  bool cut = false;
};

ShapeSettings shape_settings(Arguments& arguments) {
  ShapeSettings settings;
  if (const std::optional<std::string> name = arguments.text_if_there()) {
    settings.ramp = ramp_named(*name);
    if (!settings.ramp) arguments.complain(no_such_ramp(*name));
    if (const std::optional<std::string> tone = arguments.text_if_there()) {
      const auto both = two_numbers(*tone + ",0", ',');
      if (!both) arguments.complain(fmt::format("'{}' is not a tone", base::quotable(*tone)));
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

// Shows what was painted where the shape covers it.
void lay(const Cover& cover, const ShapeSettings& settings, std::uint64_t seed, const Surface& painted,
         Surface& io_surface) {
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

void set_color(const ShapeSettings& settings, Surface& io_surface) {
  for (Texel& texel : io_surface.cells) {
    if (settings.ramp) texel.ramp = *settings.ramp;
    if (settings.tone) texel.tone = *settings.tone;
    if (settings.ramp) texel.hole = false;
  }
}

base::Status paint_shape(const ShapeWord& word, const ScriptLine& line, std::uint64_t seed,
                         Surface& io_surface) {
  Arguments arguments(line);
  Layer layer{arguments, seed};
  const Cover cover = word.cover(layer, io_surface);
  const ShapeSettings settings = shape_settings(arguments);
  TRY_STATUS(arguments.finish());
  Surface painted = io_surface;
  set_color(settings, painted);
  TRY_STATUS(paint_layers(line.below, seed, painted));
  lay(cover, settings, seed, painted, io_surface);
  return base::Ok{};
}

// A picture of its own, which repeats by itself, let into the surface.
base::Status paint_inlay(const ScriptLine& line, std::uint64_t seed, Surface& io_surface) {
  Arguments arguments(line);
  const Point at = point(arguments, "at", {});
  const Point size = extent(arguments, "size", {16, 16});
  const ShapeSettings settings = shape_settings(arguments);
  const auto left = static_cast<std::int32_t>(at.x), top = static_cast<std::int32_t>(at.y);
  const auto width = static_cast<std::int32_t>(size.x), height = static_cast<std::int32_t>(size.y);
  if (width < 1 || height < 1 || width > io_surface.width || height > io_surface.height)
    arguments.complain(
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

template <typename Word>
const Word* find_word(std::span<const std::span<const Word>> tables, std::string_view word) {
  for (const std::span<const Word> table : tables)
    for (const Word& known : table)
      if (known.word == word) return &known;
  return nullptr;
}

base::Status paint_layer(const ScriptLine& line, std::uint64_t seed, Surface& io_surface) {
  if (line.word == "inlay") return paint_inlay(line, seed, io_surface);
  const std::array shapes = {drawn_words(), grown_words()};
  if (const ShapeWord* shape = find_word<ShapeWord>(shapes, line.word))
    return paint_shape(*shape, line, seed, io_surface);
  const std::array layers = {material_words(), structure_words(), relief_words()};
  const LayerWord* layer_word = find_word<LayerWord>(layers, line.word);
  if (layer_word == nullptr) return script_error(line, "there is no such layer of a texture");
  if (!line.below.empty()) return script_error(line.below.front(), "no layer can stand under this one");
  Arguments arguments(line);
  Layer layer{arguments, seed};
  layer_word->paint(layer, io_surface);
  return arguments.finish();
}

}  // namespace

// A layer's seed comes from its word and how many such words were before it, so that a line more does not
// change what the others look like.
base::Status paint_layers(std::span<const ScriptLine> lines, std::uint64_t seed, Surface& io_surface) {
  std::map<std::string_view, std::uint64_t> count_of_word;
  for (const ScriptLine& line : lines) {
    const std::uint64_t word = base::hash_of_bytes(base::as_bytes(line.word));
    TRY_STATUS(paint_layer(line, base::hash_with(base::hash_with(seed, word), count_of_word[line.word]++),
                           io_surface));
  }
  return base::Ok{};
}

Point point(Arguments& arguments, std::string_view name, Point otherwise) {
  if (!arguments.has(name)) return otherwise;
  const std::string text = arguments.text(name, "");
  const std::optional<Point> found = two_numbers(text, ',');
  if (!found) arguments.complain(fmt::format("{}={} is not X,Y", name, base::quotable(text)));
  return found.value_or(otherwise);
}

Point extent(Arguments& arguments, std::string_view name, Point otherwise) {
  if (!arguments.has(name)) return otherwise;
  const std::string text = arguments.text(name, "");
  const std::string both = text.find('x') == std::string::npos ? fmt::format("{}x{}", text, text) : text;
  const std::optional<Point> found = two_numbers(both, 'x');
  if (!found || found->x <= 0 || found->y <= 0) {
    arguments.complain(fmt::format("{}={} is not WIDTHxHEIGHT", name, base::quotable(text)));
    return otherwise;
  }
  return *found;
}

std::optional<Ramp> ramp_named(std::string_view name) {
  const auto found = std::find(kRampNames.begin(), kRampNames.end(), name);
  if (found == kRampNames.end()) return {};
  return static_cast<Ramp>(found - kRampNames.begin());
}

Ramp ramp(Arguments& arguments, std::string_view name, Ramp otherwise) {
  if (!arguments.has(name)) return otherwise;
  const std::string text = arguments.text(name, "");
  const std::optional<Ramp> found = ramp_named(text);
  if (!found) arguments.complain(no_such_ramp(text));
  return found.value_or(otherwise);
}

NoiseLumps noise_lumps(Arguments& arguments, const Surface& surface, Point usual_lump,
                       std::int32_t usual_octaves) {
  const Point lump = extent(arguments, "lump", usual_lump);
  return noise_lumps(surface, lump, arguments.integer("octaves", usual_octaves, 1, 6));
}

NoiseLumps noise_lumps(const Surface& surface, Point lump, std::int32_t octaves) {
  return {times_in(surface.width, lump.x), times_in(surface.height, lump.y), octaves};
}

std::int32_t times_in(double side, double length) {
  return std::max(1, static_cast<std::int32_t>(std::lround(side / length)));
}

double wrapped(double value, double period) {
  return value - period * std::floor(value / period);
}

}  // namespace temblor::artgen
