// Makes the console font: 256 glyphs in a 128 x 128 sheet, 16 per row, as the stock conchars lump has them.
// Glyphs are light with a dark edge to the right and below; index 0 is transparent.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "artgen/palette.h"
#include "artgen/pictures/drawing_settings.h"
#include "artgen/pictures/glyphs.h"
#include "artgen/pictures/picture_makers.h"
#include "formats/archives/wad.h"

namespace temblor::artgen {
namespace {

using namespace pictures;

constexpr std::int32_t kGlyphsARow = 16, kSheetSide = kGlyphsARow * kGlyphSide;
constexpr std::uint8_t kSecondHalf = 128;

// The ramps of the two halves and of symbols; `top` and `bottom` are the tones of a glyph's first and last
// row.
struct FontStyle {
  Ramp first, second, marks;
  double top = 1, bottom = 0.7;
};

// Codes below the blank are symbols, and so are the first four codes of the second half, the parts of a
// slider.
bool is_sign(std::uint8_t code) {
  constexpr std::uint8_t kBlank = 32, kSliderEnd = kSecondHalf + 4;
  return code < kBlank || (code >= kSecondHalf && code < kSliderEnd);
}

Ramp choose_ramp(std::uint8_t code, const FontStyle& style) {
  if (is_sign(code)) return style.marks;
  return code < kSecondHalf ? style.first : style.second;
}

// Draws a glyph into the sheet.
void stamp(const Glyph& glyph, std::uint8_t code, const FontStyle& style, base::ByteVector& io_sheet) {
  constexpr double kShadow = 0.1;
  for (std::int32_t y = 0; y < kGlyphSide; ++y)
    for (std::int32_t x = 0; x < kGlyphSide; ++x) {
      const std::int32_t column = code % kGlyphsARow * kGlyphSide + x,
                         row = code / kGlyphsARow * kGlyphSide + y;
      auto& pixel = io_sheet[static_cast<std::size_t>(row * kSheetSide + column)];
      const double down = y / (kGlyphSide - 1.0);
      std::uint8_t index = 0;
      if (glyph.ink(x, y))
        index = ramp_color(choose_ramp(code, style), style.top + (style.bottom - style.top) * down);
      else if (glyph.ink(x - 1, y - 1) || (glyph.ink(x, y - 1) && !glyph.ink(x + 1, y - 1)) ||
               (glyph.ink(x - 1, y) && !glyph.ink(x - 1, y + 1)))
        index = ramp_color(Ramp::kGray, kShadow);
      pixel = static_cast<std::byte>(index);
    }
}

}  // namespace

base::Result<std::vector<ArtPart>> make_font(const ScriptLine& asset) {
  Arguments arguments(asset);
  const std::string name = arguments.text();
  FontStyle style{};
  style.first = read_ramp(arguments, arguments.text("first", "gray"));
  style.second = read_ramp(arguments, arguments.text("second", "gold"));
  style.marks = read_ramp(arguments, arguments.text("marks", "gold"));
  style.top = arguments.number("top", 1, 0, 1);
  style.bottom = arguments.number("bottom", 0.7, 0, 1);
  TRY_STATUS(arguments.finish());
  for (const ScriptLine& line : asset.below)
    if (line.keyword != "glyph") return script_error(line, "only 'glyph' lines can be under a font");
  TRY(Glyphs glyphs, read_glyphs(asset.below));
  base::ByteVector sheet(static_cast<std::size_t>(kSheetSide * kSheetSide));
  for (int code = 0; code < 256; ++code) {
    // A glyph that the second half does not define is copied from the first half, in the second color.
    const auto own = glyphs.find(static_cast<std::uint8_t>(code));
    const auto found = own != glyphs.end() ? own : glyphs.find(static_cast<std::uint8_t>(code % kSecondHalf));
    if (found != glyphs.end()) stamp(found->second, static_cast<std::uint8_t>(code), style, sheet);
  }
  return std::vector<ArtPart>{{"gfx.wad", std::move(sheet), name, formats::kWadTexture}};
}

}  // namespace temblor::artgen
