// Makes a WAD2 texture archive from PNG files.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/images/palette.h"

namespace temblor::compiler {

// A PNG file in memory.
struct PngFile {
  std::string name;  // a path; its stem is the texture's name
  base::Bytes bytes;
};

// Returns the file's stem. A # in front becomes the * of liquids, which some file systems do not allow.
std::string texture_name_from_file(std::string_view file_name);

// Returns the bytes of a WAD2 with the textures in the order of the files, in the game's palette, with all
// mip levels. Names beginning with { have holes where pixels are less than half opaque. Colors are
// full-bright only where they are exactly one of the palette's full-bright colors.
//
// Errors name the file: it is no PNG, a side is not a multiple of 16, the name is empty or longer than 15
// characters, or an earlier file has the same name (case does not matter).
base::Result<base::ByteVector> make_wad(std::span<const PngFile> files, const formats::Palette& palette);

}  // namespace temblor::compiler
