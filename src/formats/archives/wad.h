// WAD2 and WAD3 archives: named, typed lumps. gfx.wad has the pictures of the status bar; map editors and
// compilers take textures from other WADs. WAD3 is Half-Life's variant, whose textures have their own
// palettes.
//
//   header, 12 bytes      0  "WAD2" or "WAD3"
//                         4  lump count i32
//                         8  table offset i32    from the start of the file, usually after the lumps
//   table entry, 32 bytes 0  data offset i32
//                         4  stored size i32     bytes in the file
//                         8  size i32            bytes after decompression
//                        12  type u8             kWadPicture and so on
//                        13  compression u8      0: none
//                        14  unused u16
//                        16  name char[16]       zero-padded
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

constexpr std::size_t kWadNameChars = 16;

// Lump types of stock tools. read_wad() accepts all types.
constexpr std::uint8_t kWadPalette = 64;
constexpr std::uint8_t kWadPicture = 66;  // picture.h
constexpr std::uint8_t kWadSound = 67;
constexpr std::uint8_t kWad3Texture = 67;  // in a WAD3 only: wad3_texture.h
constexpr std::uint8_t kWadTexture = 68;   // wad_texture.h; in gfx.wad also the header-less conchars

// `data` is borrowed from the bytes of the WAD.
struct WadLump {
  std::string name;  // as stored, at most 16 characters
  std::uint8_t type = 0;
  base::Bytes data;
};

// Returns the lumps in file order. Lumps are inside of `bytes` and may overlap. A lump whose sizes differ has
// the larger one that is inside; one that begins outside has no data: a game may never use it, and its reader
// reports the error when it does. The compression is ignored, because no known tool compresses lumps.
base::Result<std::vector<WadLump>> read_wad(base::Bytes bytes);

// Checks the first four bytes only.
bool is_wad3(base::Bytes bytes);

// Writes a WAD2. Returns kTooLarge for a name over 16 characters or for more than 2^31 - 1 bytes.
base::Result<base::ByteVector> write_wad(std::span<const WadLump> lumps);

// Returns the first lump with this name, ignoring case, or null.
const WadLump* find_lump(std::span<const WadLump> lumps, std::string_view name);

}  // namespace temblor::formats
