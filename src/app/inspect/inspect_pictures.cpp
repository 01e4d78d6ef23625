// Pictures, palettes and colormaps, which share the extension .lmp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "app/inspect/inspection.h"
#include "formats/images/palette.h"
#include "formats/images/picture.h"

namespace temblor::app {
namespace {

constexpr std::uint8_t kTransparentPixel = 255;
// The row of a colormap for normal light, which should not change colors.
constexpr int kNormalRow = 31;

std::string hex(const formats::Rgb& color) {
  return fmt::format("{:02x}{:02x}{:02x}", color.r, color.g, color.b);
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

// A square of pixels without a header.
base::Result<Inspection> inspect_raw_picture(base::Bytes bytes) {
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(bytes.size())));
  if (side == 0 || side * side != bytes.size())
    return base::malformed("{} bytes are not the pixels of a square", bytes.size());
  return Inspection{{"width", side}, {"height", side}, {"problems", Inspection::array()}};
}

base::Result<Inspection> inspect_palette(base::Bytes bytes) {
  TRY(const formats::Palette palette, formats::read_palette(bytes));
  Inspection colors = Inspection::array();
  for (const formats::Rgb& color : palette) colors.push_back(hex(color));
  return Inspection{{"colors", colors}, {"problems", Inspection::array()}};
}

// Counts colors that normal light changes, and entries of full-bright colors that any light changes.
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
    problems.push_back(fmt::format("row {} is normal light but changes {} colors", kNormalRow, changed));
  if (dimmed > 0) problems.push_back(fmt::format("{} entries of full-bright colors depend on light", dimmed));
  return Inspection{{"rows", formats::Colormap::kRows},
                    {"full-bright colors", colormap.fullbrights},
                    {"problems", problems}};
}

}  // namespace temblor::app
