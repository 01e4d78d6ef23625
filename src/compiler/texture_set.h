// The textures of a level, found by name in WADs and other levels.
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

// A WAD2, WAD3 or .bsp; `name` is what messages call it.
struct TextureSource {
  std::string name;
  base::Bytes bytes;
};

struct TextureSet {
  // In the order in which the names were first asked for, then animation frames; every one has its texels.
  std::vector<formats::BspMiptex> miptexes;
  // By name in small letters, cut to the 15 characters that a level has room for.
  std::map<std::string, std::uint32_t, std::less<>> index;

  // Without regard to case. Every name that the set was made for is there.
  std::optional<std::uint32_t> find(std::string_view name) const;
};

// Where the smaller mip levels come from.
enum class MipLevels : std::uint8_t { kFromSource, kBuilt };

// The textures of `names` (which may repeat), each from the first source that has it, in the source's case;
// and with a texture +0 to +9 or +a to +j all the frames of both sequences that there are.
//
// A texture of which only the largest mip level can be had gets the others built. WAD3 textures are brought
// to the game's palette. What goes wrong is a warning: a source or a texture that cannot be read (it is
// passed over), a texture that no source has (a checker of 64 x 64 texels stands in), names that are the same
// in their first 15 characters, an animation with a frame missing, sides that are no multiple of 16 texels.
TextureSet make_texture_set(std::span<const std::string_view> names, std::span<const TextureSource> sources,
                            const formats::Palette& palette, MipLevels mip_levels, Warnings& io_warnings);

}  // namespace temblor::compiler
