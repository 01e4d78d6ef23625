// Version 30, the levels of Half-Life. Records have the widths of version 29. The differences:
//
//   lighting   red, green, blue u8 for each sample; a face's light offset counts bytes
//   textures   a palette of its own after mip 3 (textures.h); texels that are not in the level are in a WAD3
//              that worldspawn's key "wad" names
//   hulls      1: 32 x 32 x 72, 2: 64 x 64 x 64, 3: 32 x 32 x 36 units, each around its center
//   contents   also -15 (translucent) and -16 (ladder)
//
// A Bsp holds such light as other versions do: one gray sample for each color, whose colors are in a BSPX
// lump RGBLIGHTING. Source: Valve developer wiki, "BSP (GoldSrc)".
#pragma once

#include <vector>

#include "base/bytes.h"
#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// After reading: moves the colors from `lighting` to a lump RGBLIGHTING, which becomes the first one and the
// only one of that name, and computes gray samples. Light offsets become numbers of samples. A face whose
// offset is in the middle of a color loses its light.
void separate_gray_light(Bsp& io_bsp);

// For writing: the colors of the first lump RGBLIGHTING if their number is right, else the gray samples as
// colors.
base::ByteVector colored_light(const Bsp& bsp);
// The faces with light offsets in bytes. Returns kTooLarge for one that does not fit.
base::Result<std::vector<BspFace>> count_light_bytes(std::vector<BspFace> faces);
std::vector<BspxLump> lumps_without_light(std::vector<BspxLump> lumps);

}  // namespace temblor::formats::bsp_file
