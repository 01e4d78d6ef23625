#include "support/pictures/small_pictures.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/palette.h"
#include "assets/stock/stock_pictures.h"
#include "formats/archives/wad.h"
#include "formats/images/picture.h"

namespace temblor::test {
namespace {

using artgen::Ramp;

constexpr std::uint8_t kClear = artgen::kTransparent;

// 3 x 5 pixels: one octal digit for each row from the top, with the highest bit on the left.
struct Glyph {
  char character;
  std::uint16_t rows;
};
constexpr Glyph kGlyphs[] = {
    {'0', 075557}, {'1', 026227}, {'2', 071747}, {'3', 071717}, {'4', 055711}, {'5', 074717}, {'6', 074757},
    {'7', 071122}, {'8', 075757}, {'9', 075717}, {'A', 025755}, {'B', 065656}, {'C', 034443}, {'D', 065556},
    {'E', 074647}, {'F', 074644}, {'G', 034553}, {'H', 055755}, {'I', 072227}, {'J', 011152}, {'K', 055655},
    {'L', 044447}, {'M', 057755}, {'N', 065555}, {'O', 025552}, {'P', 065644}, {'Q', 025563}, {'R', 065655},
    {'S', 034216}, {'T', 072222}, {'U', 055557}, {'V', 055552}, {'W', 055775}, {'X', 055255}, {'Y', 055222},
    {'Z', 071247}, {':', 002020}, {'/', 011244}, {'!', 022202}, {'.', 000002}, {'-', 000700}, {'\'', 022000},
};
constexpr int kGlyphWidth = 3, kGlyphHeight = 5;

bool has_ink(char character, int x, int y) {
  const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
  const auto* glyph = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                   [&](const Glyph& candidate) { return candidate.character == upper; });
  if (glyph == std::end(kGlyphs)) return false;
  return (glyph->rows >> (3 * (kGlyphHeight - 1 - y) + kGlyphWidth - 1 - x) & 1) != 0;
}

struct Box {
  int x, y, width, height;
};

// Stretches the glyph over the box.
void draw_glyph(char character, const Box& box, Ramp ramp, formats::Picture& io_picture) {
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x) {
      if (!has_ink(character, x * kGlyphWidth / box.width, y * kGlyphHeight / box.height)) continue;
      const std::size_t at =
          static_cast<std::size_t>(box.y + y) * io_picture.width + static_cast<std::size_t>(box.x + x);
      io_picture.pixels[at] = artgen::ramp_color(ramp, 1 - 0.5 * y / box.height);
    }
}

formats::Picture clear_picture(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{width} * height, kClear)};
}

formats::Picture plate(std::uint32_t width, std::uint32_t height, Ramp ramp) {
  formats::Picture picture = clear_picture(width, height);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const bool light = x == 0 || y == 0, dark = x == width - 1 || y == height - 1;
      picture.pixels[std::size_t{y} * width + x] = artgen::ramp_color(ramp, light ? 0.7 : dark ? 0.15 : 0.35);
    }
  return picture;
}

// The text after the last underscore or slash, truncated to the available space.
void label(std::string_view name, formats::Picture& io_picture) {
  constexpr int kAdvance = kGlyphWidth + 1, kMargin = 2;
  if (name.ends_with(".lmp")) name.remove_suffix(4);
  name.remove_prefix(name.find_last_of("_/") + 1);
  const int room = (static_cast<int>(io_picture.width) - 2 * kMargin + 1) / kAdvance;
  const int y = (static_cast<int>(io_picture.height) - kGlyphHeight) / 2;
  for (int i = 0; i < std::min(room, static_cast<int>(name.size())); ++i)
    draw_glyph(name[static_cast<std::size_t>(i)], {kMargin + i * kAdvance, y, kGlyphWidth, kGlyphHeight},
               Ramp::kGray, io_picture);
}

// Returns the character for "num_7" or "anum_minus".
char numeral(std::string_view name) {
  const std::string_view what = name.substr(name.find('_') + 1);
  return what == "minus" ? '-' : what == "colon" ? ':' : what == "slash" ? '/' : what.front();
}

// Returns one of the ramps that are neither gray nor fullbright.
Ramp ramp_for(std::string_view name) {
  return static_cast<Ramp>(1 + std::accumulate(name.begin(), name.end(), 0) % 13);
}

formats::Picture paint(const assets::StockPicture& stock) {
  const std::string_view name = stock.name;
  if (name.starts_with("num_") || name.starts_with("anum_")) {
    formats::Picture picture = clear_picture(stock.width, stock.height);
    draw_glyph(numeral(name), {3, 2, 18, 20}, name.front() == 'a' ? Ramp::kRed : Ramp::kGold, picture);
    return picture;
  }
  const bool is_bar = name.ends_with("bar") || name == "backtile" || name == "gfx/conback.lmp";
  if (is_bar) return plate(stock.width, stock.height, Ramp::kBrown);
  // The list of the intermission screen; the client draws the numbers.
  formats::Picture picture = name == "gfx/inter.lmp" ? clear_picture(stock.width, stock.height)
                                                     : plate(stock.width, stock.height, ramp_for(name));
  label(name, picture);
  return picture;
}

// Returns the glyph for a character code: codes from 128 repeat those below in another color; 18 to 27 are
// the small digits of the status bar.
char to_character(int code) {
  const int low = code % 128;
  return static_cast<char>(low >= 18 && low <= 27 ? '0' + low - 18 : low);
}

// 16 rows of 16 characters; index 0 is transparent.
base::ByteVector characters() {
  constexpr int kSide = 128, kCharacterSide = 8;
  formats::Picture picture = clear_picture(kSide, kSide);
  for (int code = 0; code < 256; ++code)
    draw_glyph(to_character(code), {code % 16 * kCharacterSide + 1, code / 16 * kCharacterSide, 6, 7},
               code >= 32 && code < 128 ? Ramp::kGray : Ramp::kGold, picture);
  base::ByteVector bytes;
  for (const std::uint8_t pixel : picture.pixels)
    bytes.push_back(std::byte{pixel == kClear ? std::uint8_t{0} : pixel});
  return bytes;
}

}  // namespace

void write_small_pictures(const TemporaryFolder& folder) {
  std::vector<base::ByteVector> bytes;
  for (const assets::StockPicture& stock : assets::stock_wad_pictures())
    bytes.push_back(formats::write_picture(paint(stock)));
  bytes.push_back(characters());
  std::vector<formats::WadLump> lumps;
  for (const assets::StockPicture& stock : assets::stock_wad_pictures())
    lumps.push_back({stock.name, formats::kWadPicture, bytes[lumps.size()]});
  lumps.push_back({"conchars", formats::kWadTexture, bytes.back()});
  folder.write("id1/gfx.wad", formats::write_wad(lumps).value());
  for (const assets::StockPicture& stock : assets::stock_picture_files())
    folder.write(std::string("id1/") + stock.name, formats::write_picture(paint(stock)));
}

}  // namespace temblor::test
