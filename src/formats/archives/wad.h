// WAD2 and WAD3 archives: named lumps with a type (gfx.wad, texture WADs; WAD3 is Half-Life's).
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

// The types that stock tools write; a reader keeps any other as it is.
constexpr std::uint8_t kWadPalette = 64;
constexpr std::uint8_t kWadPicture = 66;  // picture.h
constexpr std::uint8_t kWadSound = 67;
constexpr std::uint8_t kWad3Texture = 67;  // in a WAD3: wad3_texture.h
constexpr std::uint8_t kWadTexture = 68;   // wad_texture.h; in gfx.wad also the header-less conchars

// `data` is not owned: it lies in the bytes that the WAD was read from, or that it is written from.
struct WadLump {
  std::string name;  // as stored, at most 16 characters
  std::uint8_t type = 0;
  base::Bytes data;
};

// In file order. Lumps lie inside `bytes`; they may overlap. kUnsupported for a compressed lump (no tool of
// the time wrote one).
base::Result<std::vector<WadLump>> read_wad(base::Bytes bytes);

// By its first four bytes.
bool is_wad3(base::Bytes bytes);

// A WAD2. kTooLarge for a name over 16 characters or for more than 2^31 - 1 bytes.
base::Result<base::ByteVector> write_wad(std::span<const WadLump> lumps);

// The first lump of that name, without regard to case; null when there is none.
const WadLump* find_lump(std::span<const WadLump> lumps, std::string_view name);

}  // namespace temblor::formats
