// BSPX: an extension with named lumps, after the fifteen regular lumps of the file. Programs skip the lumps
// that they do not know; older engines skip all of them.
//
//   at the end of the last regular lump, rounded up to 4 bytes:
//    0  "BSPX"
//    4  lump count i32
//    8  for each lump, 32 bytes: name char[24] | offset i32, from the start of the file | size i32
#pragma once

#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// `lumps_end`: end of the last regular lump. Returns no lumps if "BSPX" is not there, or if their list
// exceeds the file. Leaves out lumps outside of the file, and those with which the total size would exceed
// the file.
std::vector<BspxLump> read_bspx(base::Bytes file, std::size_t lumps_end);

// Appends the lumps to a file whose regular lumps are complete; appends nothing for an empty list. Returns
// kTooLarge for a name over 24 characters.
base::Status write_bspx(base::ByteWriter& writer, const std::vector<BspxLump>& lumps);

}  // namespace temblor::formats::bsp_file
