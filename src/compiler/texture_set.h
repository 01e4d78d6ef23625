// The textures of a level, collected by name from WADs and other levels. Names with a + are animation frames,
// { have holes, * are liquids, and "sky" begins a sky; only the frames matter here.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "compiler/report.h"
#include "formats/images/palette.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

// A WAD2, WAD3 or .bsp file. Messages call it `name`.
struct TextureSource {
  std::string name;
  base::Bytes bytes;
};

// Textures and an index of their names.
struct TextureSet {
  // In the order of the requested names, then further animation frames. All have pixels.
  std::vector<formats::BspMiptex> miptexes;
  // By name in lower case, cut to the 15 characters that a level stores.
  std::map<std::string, std::uint32_t, std::less<>> index;
  // The names that no source has, as they were requested; their textures are checkerboards.
  std::vector<std::string> missing;

  // Ignores case. Finds every name that the set was made for.
  std::optional<std::uint32_t> find(std::string_view name) const;
};

// Where the smaller mip levels come from: the source, if it has them, or always built from the largest.
enum class MipLevels : std::uint8_t { kFromSource, kBuilt };

// Collects the textures for `names` (which may repeat), each from the first source that has it. For a texture
// +0 to +9 or +a to +j, also collects all frames of both of its sequences.
//
// Missing mip levels are built. Textures with palettes of their own (WAD3, levels of version 30) are
// converted to the game's. A texture that no source has becomes a checkerboard of 64 x 64 texels. Warns about
// sources and textures that cannot be read (they are skipped), names that are equal in their first 15
// characters, missing animation frames, and sides that are not multiples of 16 texels.
TextureSet make_texture_set(std::span<const std::string_view> names, std::span<const TextureSource> sources,
                            const formats::Palette& palette, MipLevels mip_levels, Warnings& io_warnings);

}  // namespace temblor::compiler
