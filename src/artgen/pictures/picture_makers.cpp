#include "artgen/pictures/picture_makers.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "artgen/pictures/canvas.h"
#include "artgen/pictures/drawing.h"
#include "artgen/pictures/drawing_settings.h"
#include "formats/archives/wad.h"
#include "formats/images/image.h"
#include "formats/images/picture.h"
#include "formats/images/png.h"
#include "formats/models/spr.h"

namespace temblor::artgen {
namespace {

using namespace pictures;

constexpr std::int32_t kMaxSide = 1024;  // pixels

// Small pictures get more samples per pixel, because each of their pixels is more visible.
std::int32_t choose_fineness(std::int32_t width, std::int32_t height) {
  constexpr std::int32_t kLarge = 128 * 128;
  return width * height > kLarge ? 3 : 6;
}

// The size and the color reduction of a picture.
struct Sheet {
  std::int32_t width = 1, height = 1;
  QuantizeOptions quantize_options;
};

// dither=0.5 without=brown,gold
QuantizeOptions read_quantize_options(Arguments& io_arguments) {
  QuantizeOptions options;
  options.dither = io_arguments.number("dither", 0, 0, 2);
  std::string names = io_arguments.text("without", "");
  while (!names.empty()) {
    const std::size_t comma = std::min(names.find(','), names.size());
    options.without.push_back(read_ramp(io_arguments, names.substr(0, comma)));
    names.erase(0, comma + 1);
  }
  return options;
}

Sheet read_sheet(Arguments& io_arguments) {
  const auto [width, height] = io_arguments.size(kMaxSide);
  return {width, height, read_quantize_options(io_arguments)};
}

// Draws lines onto a new canvas and returns palette indices.
base::Result<std::vector<std::uint8_t>> draw_pixels(std::span<const ScriptLine> lines, const Sheet& sheet) {
  Canvas canvas(sheet.width, sheet.height, choose_fineness(sheet.width, sheet.height));
  TRY_STATUS(draw(lines, {}, canvas));
  return quantize(canvas, sheet.quantize_options);
}

// Where a picture is stored: in a .lmp file or in gfx.wad.
enum class Target { kFile, kWad };

base::Result<ArtPart> draw_picture(const std::string& name, std::span<const ScriptLine> lines,
                                   const Sheet& sheet, Target position) {
  TRY(std::vector<std::uint8_t> pixels, draw_pixels(lines, sheet));
  base::ByteVector bytes = formats::write_picture(
      {static_cast<std::uint32_t>(sheet.width), static_cast<std::uint32_t>(sheet.height), std::move(pixels)});
  if (position == Target::kWad) return ArtPart{"gfx.wad", std::move(bytes), name, formats::kWadPicture};
  return ArtPart{fmt::format("gfx/{}.lmp", name), std::move(bytes)};
}

base::Result<std::vector<ArtPart>> make_one_picture(const ScriptLine& asset, Target position) {
  Arguments arguments(asset);
  const std::string name = arguments.text();
  const Sheet sheet = read_sheet(arguments);
  TRY_STATUS(arguments.finish());
  TRY(ArtPart part, draw_picture(name, asset.below, sheet, position));
  return std::vector<ArtPart>{std::move(part)};
}

// A copy of the style's lines in which each `drawing` line became a group that contains the drawing.
std::vector<ScriptLine> apply_style(const std::vector<ScriptLine>& style, const ScriptLine& drawing) {
  std::vector<ScriptLine> lines = style;
  for (ScriptLine& line : lines) {
    if (line.keyword == "drawing") {
      line.keyword = "group";
      line.below = drawing.below;
    } else {
      line.below = apply_style(line.below, drawing);
    }
  }
  return lines;
}

base::Result<std::string> read_name(const ScriptLine& line) {
  Arguments arguments(line);
  std::string name = arguments.text();
  TRY_STATUS(arguments.finish());
  return name;
}

// Draws all combinations of styles and drawings.
base::Result<std::vector<ArtPart>> make_set(const ScriptLine& asset, Target position) {
  Arguments arguments(asset);
  const Sheet sheet = read_sheet(arguments);
  TRY_STATUS(arguments.finish());
  std::vector<const ScriptLine*> styles, drawings;
  for (const ScriptLine& line : asset.below) {
    if (line.keyword != "style" && line.keyword != "drawing")
      return script_error(line, "only 'style PREFIX' and 'drawing NAME' lines can be here");
    (line.keyword == "style" ? styles : drawings).push_back(&line);
  }
  if (styles.empty() || drawings.empty())
    return script_error(asset, "at least one style and one drawing are required");
  std::vector<ArtPart> parts;
  for (const ScriptLine* style : styles)
    for (const ScriptLine* drawing : drawings) {
      TRY(const std::string prefix, read_name(*style));
      TRY(const std::string name, read_name(*drawing));
      const std::vector<ScriptLine> lines = apply_style(style->below, *drawing);
      TRY(ArtPart part, draw_picture(prefix + name, lines, sheet, position));
      parts.push_back(std::move(part));
    }
  return parts;
}

bool is_in_mark_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

formats::SprOrientation read_facing(Arguments& io_arguments) {
  const std::string facing = io_arguments.text("facing", "view");
  if (facing == "upright") return formats::SprOrientation::kParallelUpright;
  if (facing == "angles") return formats::SprOrientation::kOriented;
  if (facing != "view") io_arguments.set_error("facing= must be view, upright or angles");
  return formats::SprOrientation::kParallel;
}

}  // namespace

base::Result<std::vector<ArtPart>> make_picture(const ScriptLine& asset) {
  return make_one_picture(asset, Target::kFile);
}

base::Result<std::vector<ArtPart>> make_wad_picture(const ScriptLine& asset) {
  return make_one_picture(asset, Target::kWad);
}

base::Result<std::vector<ArtPart>> make_pictures(const ScriptLine& asset) {
  return make_set(asset, Target::kFile);
}

base::Result<std::vector<ArtPart>> make_wad_pictures(const ScriptLine& asset) {
  return make_set(asset, Target::kWad);
}

base::Result<std::vector<ArtPart>> make_sprite(const ScriptLine& asset) {
  Arguments arguments(asset);
  const std::string path = arguments.text();
  const Sheet sheet = read_sheet(arguments);
  formats::Spr sprite;
  sprite.orientation = read_facing(arguments);
  TRY_STATUS(arguments.finish());
  sprite.max_width = static_cast<std::uint32_t>(sheet.width);
  sprite.max_height = static_cast<std::uint32_t>(sheet.height);
  // Half of the diagonal of a square of this size.
  sprite.bounding_radius = static_cast<float>(std::max(sheet.width, sheet.height)) * 0.71f;
  for (const ScriptLine& line : asset.below) {
    Arguments nothing(line);
    if (line.keyword != "frame") nothing.set_error("only 'frame' lines can be under a sprite");
    TRY_STATUS(nothing.finish());
    TRY(std::vector<std::uint8_t> texels, draw_pixels(line.below, sheet));
    sprite.frames.push_back(
        {{{-sheet.width / 2, sheet.height / 2, sprite.max_width, sprite.max_height, std::move(texels)}}, {}});
  }
  if (sprite.frames.empty()) return script_error(asset, "a sprite needs at least one frame");
  return std::vector<ArtPart>{{path, formats::write_spr(sprite)}};
}

base::Result<std::vector<ArtPart>> make_icon(const ScriptLine& asset) {
  constexpr double kDrawingSide = 64;
  Arguments arguments(asset);
  const std::string name = arguments.text();
  const auto side = static_cast<std::int32_t>(arguments.number(16, kMaxSide));
  TRY_STATUS(arguments.finish());
  Canvas canvas(side, side, choose_fineness(side, side));
  TRY_STATUS(draw(asset.below, {.at = {0, 0}, .turn_deg = 0, .scale = side / kDrawingSide}, canvas));
  const auto pixels = static_cast<std::uint32_t>(side);
  TRY(base::ByteVector bytes, formats::write_png(formats::Image{pixels, pixels, to_true_color(canvas)}));
  return std::vector<ArtPart>{{fmt::format("icon/{}.png", name), std::move(bytes)}};
}

base::Result<std::vector<ArtPart>> make_mark(const ScriptLine& asset) {
  constexpr std::int32_t kMaxMarkSide = 256;  // pixels; the game shows no larger ones
  Arguments arguments(asset);
  const std::string name = arguments.text();
  if (!std::all_of(name.begin(), name.end(), is_in_mark_name))
    arguments.set_error("a mark's name has only lower-case letters, digits, _ and -");
  const auto [width, height] = arguments.size(kMaxMarkSide);
  TRY_STATUS(arguments.finish());
  Canvas canvas(width, height, choose_fineness(width, height));
  TRY_STATUS(draw(asset.below, {}, canvas));
  TRY(base::ByteVector bytes,
      formats::write_png(formats::Image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                                        to_true_color(canvas)}));
  return std::vector<ArtPart>{{fmt::format("gfx/marks/{}.png", name), std::move(bytes)}};
}

}  // namespace temblor::artgen
