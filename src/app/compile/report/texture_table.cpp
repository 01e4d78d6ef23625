#include "app/compile/report/texture_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/compile/report/level_figures.h"
#include "app/html/html.h"
#include "base/text.h"
#include "formats/images/png.h"

namespace temblor::app {
namespace {

// Draws the texture at a quarter of its size, which is enough to recognize it.
base::Result<std::string> draw_texture(const world::Texture& texture, const formats::Palette& palette) {
  constexpr int kMip = 2;
  const int width = std::max(1, static_cast<int>(texture.width >> kMip)),
            height = std::max(1, static_cast<int>(texture.height >> kMip));
  TRY(const base::ByteVector png, formats::write_png(texture.mips[kMip], width, height, palette));
  return fmt::format("<img class=\"tex\" alt=\"\" src=\"{}\"/>", make_png_uri(png));
}

std::string describe_use(const TextureUse& use, const world::Texture& texture, bool is_missing) {
  if (is_missing) return "<span class=\"alarm\">not found: a checkerboard</span>";
  if (use.faces > 0) return "";
  return texture.name.starts_with('+') ? "<span class=\"soft\">animation</span>"
                                       : "<span class=\"soft\">on no visible side</span>";
}

}  // namespace

base::Result<std::string> write_texture_table(const world::Level& level, std::span<const std::string> missing,
                                              const formats::Palette& palette) {
  const std::vector<TextureUse> uses = measure_textures(level);
  double area = 0;
  for (const TextureUse& use : uses) area += use.area;
  std::string html = fmt::format(
      "<section id=\"textures\">\n<h2>Textures ({})</h2>\n<table>\n<tr><th></th><th>name</th><th "
      "class=\"n\">size</th><th class=\"n\">faces</th><th class=\"n\">share of the "
      "surface</th><th></th></tr>\n",
      uses.size());
  for (const TextureUse& use : uses) {
    const world::Texture& texture = level.texture(use.texture);
    const bool is_missing = std::ranges::any_of(
        missing, [&](const std::string& name) { return base::equal_ignoring_case(name, texture.name); });
    TRY(const std::string picture, draw_texture(texture, palette));
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"n\">{} x {}</td><td class=\"n\">{}</td><td class=\"n\">{:.1f} "
        "%</td><td>{}</td></tr>\n",
        picture, escape_html(texture.name), texture.width, texture.height, use.faces,
        area > 0 ? use.area / area * 100 : 0.0, describe_use(use, texture, is_missing));
  }
  return html + "</table>\n</section>\n";
}

}  // namespace temblor::app
