// What is in the WADs and levels that textures are taken from.
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
#include "formats/levels/bsp.h"

namespace temblor::compiler {

constexpr std::size_t kLevelNameChars = 15;  // of a texture's name, in a level

// Textures are the same when these are.
std::string texture_key(std::string_view name);

class TextureSources {
 public:
  // Keeps views of the sources' bytes. A source that cannot be read is a warning.
  TextureSources(std::span<const TextureSource> sources, const formats::Palette& palette,
                 Warnings& io_warnings);

  bool has(const std::string& key) const { return places_.contains(key); }
  // From the first source that has it. Only texels of mip 0 are sure to be there. A texture that cannot be
  // read is a warning, and nothing.
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

  std::vector<Source> sources_;
  std::unordered_map<std::string, Place> places_;
  formats::Palette palette_;
  std::optional<formats::NearestColor> dull_colors_;  // made when the first WAD3 texture is read
};

}  // namespace temblor::compiler
