// The small level of artgen, made once in each process for each set of options: its light takes longer than
// most tests.
#pragma once

#include "artgen/small_level.h"
#include "formats/levels/bsp.h"

namespace temblor::test {

// Equal to artgen::make_small_level(options), and valid until the process ends. Only for one thread at a
// time.
const formats::Bsp& small_bsp(const artgen::SmallLevelOptions& options = {});

}  // namespace temblor::test
