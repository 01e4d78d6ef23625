// Line numbers of compiled QuakeC (progs.lno), which fteqcc writes next to progs.dat. Errors of game code
// name the line if the file is there. The layout was found from the output of fteqcc:
//
//    0  "LNOF"
//    4  version i32                 1
//    8  number of globals i32       these four must match progs.dat
//   12  number of global words i32
//   16  number of fields i32
//   20  number of statements i32
//   24  line of each statement i32
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/game/progs.h"

namespace temblor::formats {

// Returns the source line of each statement of `progs`, in the file of its function; 0: unknown. Returns
// kMalformed if the file belongs to another program (its counts differ).
base::Result<std::vector<std::uint32_t>> read_lno(base::Bytes bytes, const Progs& progs);

}  // namespace temblor::formats
