// The console's characters: each glyph in light letters with a dark edge to the right and below.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "artgen/palette.h"
#include "artgen/pictures/glyphs.h"
#include "artgen/pictures/picture_makers.h"
#include "artgen/pictures/words.h"
#include "formats/archives/wad.h"

namespace temblor::artgen {
namespace {

using namespace pictures;

constexpr std::int32_t kGlyphsARow = 16, kSheetSide = kGlyphsARow * kGlyphSide;
constexpr std::uint8_t kSecondHalf = 128;

struct FontLook {
  Ramp first, second, marks;  // of letters in either half; of what is no letter
  double top = 1, bottom = 0.7;
};

// What stands below the blank is marks and signs, and so are the slider's first four of the second half.
bool is_mark(std::uint8_t code) {
  constexpr std::uint8_t kBlank = 32, kSliderEnd = kSecondHalf + 4;
  return code < kBlank || (code >= kSecondHalf && code < kSliderEnd);
}

Ramp ramp_of(std::uint8_t code, const FontLook& look) {
  if (is_mark(code)) return look.marks;
  return code < kSecondHalf ? look.first : look.second;
}

void stamp(const Glyph& glyph, std::uint8_t code, const FontLook& look, base::ByteVector& io_sheet) {
  constexpr double kShadow = 0.1;
  for (std::int32_t y = 0; y < kGlyphSide; ++y)
    for (std::int32_t x = 0; x < kGlyphSide; ++x) {
      const std::int32_t column = code % kGlyphsARow * kGlyphSide + x,
                         row = code / kGlyphsARow * kGlyphSide + y;
      auto& pixel = io_sheet[static_cast<std::size_t>(row * kSheetSide + column)];
      const double down = y / (kGlyphSide - 1.0);
      std::uint8_t index = 0;
      if (glyph.ink(x, y))
        index = ramp_color(ramp_of(code, look), look.top + (look.bottom - look.top) * down);
      else if (glyph.ink(x - 1, y - 1) || (glyph.ink(x, y - 1) && !glyph.ink(x + 1, y - 1)) ||
               (glyph.ink(x - 1, y) && !glyph.ink(x - 1, y + 1)))
        index = ramp_color(Ramp::kGray, kShadow);
      pixel = static_cast<std::byte>(index);
    }
}

}  // namespace

base::Result<std::vector<ArtPart>> make_font(const ScriptLine& thing) {
  Arguments arguments(thing);
  const std::string name = arguments.text();
  FontLook look{};
  look.first = read_ramp(arguments, arguments.text("first", "gray"));
  look.second = read_ramp(arguments, arguments.text("second", "gold"));
  look.marks = read_ramp(arguments, arguments.text("marks", "gold"));
  look.top = arguments.number("top", 1, 0, 1);
  look.bottom = arguments.number("bottom", 0.7, 0, 1);
  TRY_STATUS(arguments.finish());
  for (const ScriptLine& line : thing.below)
    if (line.word != "glyph") return script_error(line, "in a font there are only glyphs");
  TRY(Glyphs glyphs, read_glyphs(thing.below));
  base::ByteVector sheet(static_cast<std::size_t>(kSheetSide * kSheetSide));
  for (int code = 0; code < 256; ++code) {
    const auto own = glyphs.find(static_cast<std::uint8_t>(code));
    const auto found = own != glyphs.end() ? own : glyphs.find(static_cast<std::uint8_t>(code % kSecondHalf));
    if (found != glyphs.end()) stamp(found->second, static_cast<std::uint8_t>(code), look, sheet);
  }
  return std::vector<ArtPart>{{"gfx.wad", std::move(sheet), name, formats::kWadTexture}};
}

}  // namespace temblor::artgen
