// A span: the pixels (x, y) to (x + count - 1, y). It has a header of its own because kernels, which are
// compiled for several processors, may include plain types only.
#pragma once

#include <cstdint>

namespace temblor::render {

struct Span {
  std::uint16_t x, y, count;
};

}  // namespace temblor::render
