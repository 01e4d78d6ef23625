// The texture lump: a table of offsets, then for each texture a header and four mip levels.
#pragma once

#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// `lump_offset` is where `lump` lies in the file, for messages. Fails when sizes are
// not 1..kBspMaxTextureSize, when a mip level reaches outside the lump, and when the textures share so many
// bytes that unpacked they would be larger than the lump.
base::Result<std::vector<BspMiptex>> read_textures(base::Bytes lump, std::size_t lump_offset);

// Fails when a name is longer than 15 characters.
base::Status write_textures(base::ByteWriter& writer, const std::vector<BspMiptex>& textures);

}  // namespace temblor::formats::bsp_file
