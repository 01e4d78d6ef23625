#include "app/level/builtin_palette.h"

#include <string_view>
#include <vector>

#include "app/compile/texture_files.h"
#include "artgen/palette.h"
#include "compiler/texture_set.h"

namespace temblor::app {

namespace {

// Removes the textures that the source has with the same texels.
void remove_textures(const compiler::TextureSource& source, const formats::Palette& palette,
                     std::vector<const world::Texture*>& io_textures) {
  std::vector<std::string_view> names;
  for (const world::Texture* texture : io_textures) names.emplace_back(texture->name);
  compiler::Warnings warnings;
  const compiler::TextureSet set =
      compiler::make_texture_set(names, {&source, 1}, palette, compiler::MipLevels::kFromSource, warnings);
  std::erase_if(io_textures, [&](const world::Texture* texture) {
    return set.miptexes[*set.find(texture->name)].mips[0] == texture->mips[0];
  });
}

}  // namespace

base::Result<bool> fits_builtin_palette(const world::Level& level, const GameFolders& folders) {
  std::vector<const world::Texture*> others;
  for (const world::Texture& texture : level.textures)
    if (!texture.missing && !texture.colors) others.push_back(&texture);
  const formats::Palette palette = artgen::make_palette();
  TexturePlaces places;
  places.game_wads = list_game_wads(folders);
  std::vector<FileStamp> stamps;
  compiler::Warnings warnings;
  TRY(const TextureFiles files, find_textures(places, {}, formats::Map{}, palette, stamps, warnings));
  std::vector<std::string_view> names;
  for (const world::Texture* texture : others) names.emplace_back(texture->name);
  TRY(const base::ByteVector builtin, make_builtin_wad(names));
  remove_textures({"Temblor's own", builtin}, palette, others);
  // Sources may have different textures of the same name.
  for (const compiler::TextureSource& source : files.sources) remove_textures(source, palette, others);
  return others.empty();
}

}  // namespace temblor::app
