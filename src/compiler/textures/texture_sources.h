// An index of all textures in the WADs and levels that a map takes textures from.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/result.h"
#include "compiler/report.h"
#include "compiler/texture_set.h"
#include "formats/archives/wad.h"
#include "formats/images/nearest_color.h"
#include "formats/images/wad3_texture.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

constexpr std::size_t kLevelNameChars = 15;  // the longest texture name in a level

// Names with equal keys are the same texture: case does not matter, nor do characters beyond the longest
// name.
std::string texture_key(std::string_view name);

// Reads textures on demand, so that large WADs cost only what the map uses.
class TextureSources {
 public:
  // Keeps views of the sources' bytes. Warns about each source that cannot be read.
  TextureSources(std::span<const TextureSource> sources, const formats::Palette& palette,
                 Warnings& io_warnings);

  bool has(const std::string& key) const { return places_.contains(key); }
  // Reads a texture from the first source that has it. Only its mip level 0 is guaranteed to have texels.
  // Returns nothing, with a warning, if it cannot be read.
  std::optional<formats::BspMiptex> take(const std::string& key, Warnings& io_warnings);

 private:
  struct Source {
    std::string name;
    bool is_wad3 = false;
    std::vector<formats::WadLump> lumps;       // of a WAD
    std::vector<formats::BspMiptex> miptexes;  // of a level
  };
  struct Place {
    std::size_t source, item;
  };
  base::Result<Source> open(const TextureSource& source) const;
  base::Result<formats::BspMiptex> read(const Source& source, const formats::WadLump& lump);
  formats::BspMiptex read(const formats::BspMiptex& miptex);
  // To the game's palette.
  formats::WadTexture convert(const formats::Wad3Texture& texture);

  std::vector<Source> sources_;
  std::unordered_map<std::string, Place> places_;
  formats::Palette palette_;
  std::optional<formats::NearestColor> dull_colors_;  // made on first use; only palettes of textures need it
};

}  // namespace temblor::compiler
