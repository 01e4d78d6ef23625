// Line numbers of compiled QuakeC (progs.lno), which fteqcc writes beside progs.dat.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/game/progs.h"

namespace temblor::formats {

// The line in its function's file of each statement of `progs`; 0 for what no line stands for. An error where
// it was written for another program: the counts differ.
base::Result<std::vector<std::uint32_t>> read_lno(base::Bytes bytes, const Progs& progs);

}  // namespace temblor::formats
