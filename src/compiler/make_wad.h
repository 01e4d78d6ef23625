// A WAD of textures made from PNG files.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/images/palette.h"

namespace temblor::compiler {

struct PngFile {
  std::string name;  // with or without folders; its stem names the texture
  base::Bytes bytes;
};

// A file's stem; a # in front stands for the * of liquids, which not every file system can hold.
std::string texture_name_of_file(std::string_view file_name);

// The bytes of a WAD2, textures in the order of the files, in the game's palette and with all mip levels
// built. Names starting with { have holes where pixels are less than half opaque; colors are full-bright
// only where they are exactly one of the palette's full-bright colors.
//
// Errors name the file: no PNG, sides that are no multiples of 16, a name that is empty or longer than the 15
// characters that a level has room for, or that an earlier file has, but for case.
base::Result<base::ByteVector> make_wad(std::span<const PngFile> files, const formats::Palette& palette);

}  // namespace temblor::compiler
