// BSPX: named lumps after the fifteen, behind all of them in the file.
#pragma once

#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// `lumps_end` is where the last of the fifteen lumps ends. Without the BSPX mark there: no lumps.
base::Result<std::vector<BspxLump>> read_bspx(base::Bytes file, std::size_t lumps_end);

// Appends to a file whose fifteen lumps are complete; nothing when there are no lumps. Fails when a name is
// longer than 24 characters.
base::Status write_bspx(base::ByteWriter& writer, const std::vector<BspxLump>& lumps);

}  // namespace temblor::formats::bsp_file
