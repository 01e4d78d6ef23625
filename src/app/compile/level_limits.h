// The counts of a level beside the limits of the original engine and its compilers.
#pragma once

#include <cstddef>
#include <vector>

#include "formats/levels/bsp.h"

namespace temblor::app {

struct LevelLimit {
  const char* name;  // "faces"
  std::size_t count, stock_limit;

  bool is_exceeded() const { return count > stock_limit; }
};

std::vector<LevelLimit> list_level_limits(const formats::Bsp& bsp);

}  // namespace temblor::app
