#include "render_gl/models/player_palettes.h"

#include "render/alias/light_alias.h"

namespace temblor::render_gl {

namespace {

constexpr int kRowColors = 256;
// Rows of the palette that a player may choose for each of two parts.
constexpr int kChoices = 16;
constexpr int kPlainRow = kChoices * kChoices;

// Light changes no index: so an instance's colors are the indices that show instead of those of the skin.
render::ColorTables make_unlit_tables(const render::ColorTables& colors) {
  formats::Colormap colormap = colors.colormap;
  for (std::size_t i = 0; i < colormap.rows.size(); ++i)
    colormap.rows[i] = static_cast<std::uint8_t>(i % kRowColors);
  return render::make_color_tables(colors.palette, colormap);
}

}  // namespace

int PlayerPalettes::row(const std::optional<render::PlayerColors>& colors) {
  return colors ? (colors->shirt % kChoices) * kChoices + colors->pants % kChoices : kPlainRow;
}

base::Result<PlayerPalettes> PlayerPalettes::make(const Functions& gl, const render::ColorTables& colors,
                                                  render::PixelFormat format) {
  const bool is_indexed = format == render::PixelFormat::kIndexed;
  std::optional<render::ColorTables> unlit;
  if (is_indexed) unlit = make_unlit_tables(colors);
  TRY(Texture texture, make_texture(gl, is_indexed ? GL_R8 : GL_RGBA8, {kRowColors, kPlainRow + 1}));
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  base::Arena arena;
  const auto upload = [&](const std::optional<render::PlayerColors>& player) {
    const render::AliasInstance instance{.colors = player};
    const void* const table =
        render::instance_colors(is_indexed ? *unlit : colors, instance, {}, format, arena);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, row(player), kRowColors, 1, is_indexed ? GL_RED : GL_RGBA,
                     GL_UNSIGNED_BYTE, table);
    arena.reset();
  };
  upload(std::nullopt);
  for (int shirt = 0; shirt < kChoices; ++shirt)
    for (int pants = 0; pants < kChoices; ++pants)
      upload(render::PlayerColors{static_cast<std::uint8_t>(shirt), static_cast<std::uint8_t>(pants)});
  return PlayerPalettes(std::move(texture));
}

}  // namespace temblor::render_gl
