#include "app/lab/lab_picture.h"

#include <algorithm>
#include <cstdlib>

#include "app/files/picture_file.h"
#include "render/present.h"

namespace temblor::app {
namespace {

std::uint32_t pixel_color(const render::FrameBuffer& frame, const formats::Palette& palette,
                          std::size_t pixel) {
  return frame.format() == render::PixelFormat::kRgb ? frame.rgb()[pixel]
                                                     : render::to_rgb(palette[frame.indexed()[pixel]]);
}

std::uint32_t compute_difference(std::uint32_t a, std::uint32_t b) {
  if (a == b) return 0xff000000u;
  std::uint32_t difference = 0xff000000u;
  for (int shift = 0; shift <= 16; shift += 8) {
    const int channel = std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255));
    difference |= static_cast<std::uint32_t>(std::clamp(4 * channel, 64, 255)) << shift;
  }
  return difference;
}

}  // namespace

base::Status write_lab_picture(const std::string& path, const render::FrameBuffer& technique,
                               const render::FrameBuffer& engine, const formats::Palette& palette) {
  const auto width = static_cast<std::size_t>(technique.width());
  const formats::Palette shown = render::shown_palette(technique, palette);
  render::FrameBuffer sheet(3 * technique.width(), technique.height(), render::PixelFormat::kRgb);
  for (std::size_t i = 0; i < technique.pixel_count(); ++i) {
    std::uint32_t* const row = sheet.rgb().data() + i / width * 3 * width;
    const std::uint32_t drawn = pixel_color(technique, shown, i), right = pixel_color(engine, shown, i);
    row[i % width] = drawn;
    row[width + i % width] = right;
    row[2 * width + i % width] = compute_difference(drawn, right);
  }
  return write_picture_file(path, sheet, palette);
}

}  // namespace temblor::app
