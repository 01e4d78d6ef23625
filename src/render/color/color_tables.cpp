#include "render/color/color_tables.h"

#include "render/frame_buffer.h"

namespace temblor::render {

ColorTables make_color_tables(const formats::Palette& palette, const formats::Colormap& colormap) {
  const int first_fullbright = 256 - colormap.fullbrights;
  const PaletteMatch match(palette, first_fullbright);
  ColorTables tables{palette,
                     colormap,
                     {},
                     {},
                     first_fullbright,
                     match.find_by_trying({128, 128, 128}, false),
                     match.find_by_trying({0, 0, 0}, false),
                     match,
                     BlendTables(palette, match),
                     TintTables(palette, match)};
  for (int i = 0; i < 256; ++i) {
    const auto index = static_cast<std::size_t>(i);
    tables.rgb[index] = to_rgb(palette[index]);
    tables.surface_rgb[index] =
        i >= tables.first_fullbright ? tables.rgb[index] & 0xffffffu : tables.rgb[index];
  }
  return tables;
}

}  // namespace temblor::render
