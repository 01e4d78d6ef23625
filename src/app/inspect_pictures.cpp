// Pictures, palettes and colormaps.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "app/inspection.h"
#include "formats/palette.h"
#include "formats/picture.h"

namespace temblor::app {
namespace {

constexpr std::uint8_t kTransparentPixel = 255;
constexpr int kNormalRow = 31;  // of a colormap: light that leaves colours as they are

std::string hex(const formats::Rgb& colour) {
  return fmt::format("{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

}  // namespace

base::Result<Inspection> inspect_picture(base::Bytes bytes) {
  TRY(const formats::Picture picture, formats::read_picture(bytes));
  return Inspection{
      {"width", picture.width},
      {"height", picture.height},
      {"transparent pixels", std::count(picture.pixels.begin(), picture.pixels.end(), kTransparentPixel)},
      {"problems", Inspection::array()}};
}

base::Result<Inspection> inspect_palette(base::Bytes bytes) {
  TRY(const formats::Palette palette, formats::read_palette(bytes));
  Inspection colours = Inspection::array();
  for (const formats::Rgb& colour : palette) colours.push_back(hex(colour));
  return Inspection{{"colours", colours}, {"problems", Inspection::array()}};
}

base::Result<Inspection> inspect_colormap(base::Bytes bytes) {
  TRY(const formats::Colormap colormap, formats::read_colormap(bytes));
  Inspection problems = Inspection::array();
  const int first_fullbright = 256 - colormap.fullbrights;
  int changed = 0, dimmed = 0;
  for (int row = 0; row < formats::Colormap::kRows; ++row) {
    for (int index = 0; index < 256; ++index) {
      const bool same = colormap.rows[static_cast<std::size_t>(row * 256 + index)] == index;
      changed += row == kNormalRow && index < first_fullbright && !same ? 1 : 0;
      dimmed += index >= first_fullbright && !same ? 1 : 0;
    }
  }
  if (changed > 0)
    problems.push_back(
        fmt::format("row {} is normal light, yet maps {} indices to others", kNormalRow, changed));
  if (dimmed > 0) problems.push_back(fmt::format("{} entries of full-bright colours change", dimmed));
  return Inspection{{"rows", formats::Colormap::kRows},
                    {"full-bright colours", colormap.fullbrights},
                    {"problems", problems}};
}

}  // namespace temblor::app
