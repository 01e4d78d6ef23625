#include "artgen/pictures/picture_makers.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "artgen/pictures/canvas.h"
#include "artgen/pictures/drawing.h"
#include "artgen/pictures/words.h"
#include "formats/archives/wad.h"
#include "formats/images/image.h"
#include "formats/images/picture.h"
#include "formats/images/png.h"
#include "formats/models/spr.h"

namespace temblor::artgen {
namespace {

using namespace pictures;

constexpr std::int32_t kLargest = 1024;  // pixels

// Small pictures are drawn finer, as each of their pixels counts.
std::int32_t fineness_for(std::int32_t width, std::int32_t height) {
  constexpr std::int32_t kLarge = 128 * 128;
  return width * height > kLarge ? 3 : 6;
}

struct Sheet {
  std::int32_t width = 1, height = 1;
  Quantizing quantizing;
};

// dither=0.5 without=brown,gold
Quantizing read_quantizing(Arguments& io_arguments) {
  Quantizing how;
  how.dither = io_arguments.number("dither", 0, 0, 2);
  std::string names = io_arguments.text("without", "");
  while (!names.empty()) {
    const std::size_t comma = std::min(names.find(','), names.size());
    how.without.push_back(read_ramp(io_arguments, names.substr(0, comma)));
    names.erase(0, comma + 1);
  }
  return how;
}

Sheet read_sheet(Arguments& io_arguments) {
  const auto [width, height] = io_arguments.size(kLargest);
  return {width, height, read_quantizing(io_arguments)};
}

base::Result<std::vector<std::uint8_t>> draw_pixels(std::span<const ScriptLine> lines, const Sheet& sheet) {
  Canvas canvas(sheet.width, sheet.height, fineness_for(sheet.width, sheet.height));
  TRY_STATUS(draw(lines, {}, canvas));
  return quantize(canvas, sheet.quantizing);
}

enum class Place { kFile, kWad };

base::Result<ArtPart> draw_picture(const std::string& name, std::span<const ScriptLine> lines,
                                   const Sheet& sheet, Place place) {
  TRY(std::vector<std::uint8_t> pixels, draw_pixels(lines, sheet));
  base::ByteVector bytes = formats::write_picture(
      {static_cast<std::uint32_t>(sheet.width), static_cast<std::uint32_t>(sheet.height), std::move(pixels)});
  if (place == Place::kWad) return ArtPart{"gfx.wad", std::move(bytes), name, formats::kWadPicture};
  return ArtPart{fmt::format("gfx/{}.lmp", name), std::move(bytes)};
}

base::Result<std::vector<ArtPart>> make_one(const ScriptLine& thing, Place place) {
  Arguments arguments(thing);
  const std::string name = arguments.text();
  const Sheet sheet = read_sheet(arguments);
  TRY_STATUS(arguments.finish());
  TRY(ArtPart part, draw_picture(name, thing.below, sheet, place));
  return std::vector<ArtPart>{std::move(part)};
}

// A style's lines with its line `drawing` become the group of the drawing's.
std::vector<ScriptLine> in_style(const std::vector<ScriptLine>& style, const ScriptLine& drawing) {
  std::vector<ScriptLine> lines = style;
  for (ScriptLine& line : lines) {
    if (line.word == "drawing") {
      line.word = "group";
      line.below = drawing.below;
    } else {
      line.below = in_style(line.below, drawing);
    }
  }
  return lines;
}

base::Result<std::string> name_of(const ScriptLine& line) {
  Arguments arguments(line);
  std::string name = arguments.text();
  TRY_STATUS(arguments.finish());
  return name;
}

base::Result<std::vector<ArtPart>> make_set(const ScriptLine& thing, Place place) {
  Arguments arguments(thing);
  const Sheet sheet = read_sheet(arguments);
  TRY_STATUS(arguments.finish());
  std::vector<const ScriptLine*> styles, drawings;
  for (const ScriptLine& line : thing.below) {
    if (line.word != "style" && line.word != "drawing")
      return script_error(line, "here stand only styles (style PREFIX) and drawings (drawing NAME)");
    (line.word == "style" ? styles : drawings).push_back(&line);
  }
  if (styles.empty() || drawings.empty()) return script_error(thing, "it needs a style and a drawing");
  std::vector<ArtPart> parts;
  for (const ScriptLine* style : styles)
    for (const ScriptLine* drawing : drawings) {
      TRY(const std::string prefix, name_of(*style));
      TRY(const std::string name, name_of(*drawing));
      const std::vector<ScriptLine> lines = in_style(style->below, *drawing);
      TRY(ArtPart part, draw_picture(prefix + name, lines, sheet, place));
      parts.push_back(std::move(part));
    }
  return parts;
}

formats::SprOrientation read_facing(Arguments& io_arguments) {
  const std::string facing = io_arguments.text("facing", "view");
  if (facing == "upright") return formats::SprOrientation::kParallelUpright;
  if (facing == "angles") return formats::SprOrientation::kOriented;
  if (facing != "view") io_arguments.complain("facing= is none of view, upright, angles");
  return formats::SprOrientation::kParallel;
}

}  // namespace

base::Result<std::vector<ArtPart>> make_picture(const ScriptLine& thing) {
  return make_one(thing, Place::kFile);
}

base::Result<std::vector<ArtPart>> make_wad_picture(const ScriptLine& thing) {
  return make_one(thing, Place::kWad);
}

base::Result<std::vector<ArtPart>> make_pictures(const ScriptLine& thing) {
  return make_set(thing, Place::kFile);
}

base::Result<std::vector<ArtPart>> make_wad_pictures(const ScriptLine& thing) {
  return make_set(thing, Place::kWad);
}

base::Result<std::vector<ArtPart>> make_sprite(const ScriptLine& thing) {
  Arguments arguments(thing);
  const std::string path = arguments.text();
  const Sheet sheet = read_sheet(arguments);
  formats::Spr sprite;
  sprite.orientation = read_facing(arguments);
  TRY_STATUS(arguments.finish());
  sprite.max_width = static_cast<std::uint32_t>(sheet.width);
  sprite.max_height = static_cast<std::uint32_t>(sheet.height);
  sprite.bounding_radius = static_cast<float>(std::max(sheet.width, sheet.height)) * 0.71f;
  for (const ScriptLine& line : thing.below) {
    Arguments nothing(line);
    if (line.word != "frame") nothing.complain("in a sprite there are only frames");
    TRY_STATUS(nothing.finish());
    TRY(std::vector<std::uint8_t> texels, draw_pixels(line.below, sheet));
    sprite.frames.push_back(
        {{{-sheet.width / 2, sheet.height / 2, sprite.max_width, sprite.max_height, std::move(texels)}}, {}});
  }
  if (sprite.frames.empty()) return script_error(thing, "a sprite has a frame");
  return std::vector<ArtPart>{{path, formats::write_spr(sprite)}};
}

base::Result<std::vector<ArtPart>> make_icon(const ScriptLine& thing) {
  constexpr double kDrawnOn = 64;
  Arguments arguments(thing);
  const std::string name = arguments.text();
  const auto side = static_cast<std::int32_t>(arguments.number(16, kLargest));
  TRY_STATUS(arguments.finish());
  Canvas canvas(side, side, fineness_for(side, side));
  TRY_STATUS(draw(thing.below, {.at = {0, 0}, .turn_deg = 0, .scale = side / kDrawnOn}, canvas));
  const auto pixels = static_cast<std::uint32_t>(side);
  TRY(base::ByteVector bytes, formats::write_png(formats::Image{pixels, pixels, true_color(canvas)}));
  return std::vector<ArtPart>{{fmt::format("icon/{}.png", name), std::move(bytes)}};
}

}  // namespace temblor::artgen
