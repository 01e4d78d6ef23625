#include "render_gl/models/player_palettes.h"

#include "render/alias/light_alias.h"

namespace temblor::render_gl {

namespace {

constexpr int kPaletteColors = 256;
// Rows of the palette that a player may choose for each of two parts.
constexpr int kChoices = 16;
constexpr int kPlainRow = kChoices * kChoices;

}  // namespace

int PlayerPalettes::row(const std::optional<render::PlayerColors>& colors) {
  return colors ? (colors->shirt % kChoices) * kChoices + colors->pants % kChoices : kPlainRow;
}

base::Result<PlayerPalettes> PlayerPalettes::make(const Functions& gl, const render::ColorTables& colors) {
  TRY(Texture texture, make_texture(gl, GL_RGBA8, {kPaletteColors, kPlainRow + 1}));
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  base::Arena arena;
  const auto upload = [&](const std::optional<render::PlayerColors>& player) {
    const render::AliasInstance instance{.colors = player};
    const void* const table = render::instance_colors(colors, instance, {}, render::PixelFormat::kRgb, arena);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, row(player), kPaletteColors, 1, GL_RGBA, GL_UNSIGNED_BYTE, table);
  };
  upload(std::nullopt);
  for (int shirt = 0; shirt < kChoices; ++shirt)
    for (int pants = 0; pants < kChoices; ++pants)
      upload(render::PlayerColors{static_cast<std::uint8_t>(shirt), static_cast<std::uint8_t>(pants)});
  return PlayerPalettes(std::move(texture));
}

}  // namespace temblor::render_gl
