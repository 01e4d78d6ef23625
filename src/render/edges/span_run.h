// A span: pixels (x, y) to (x + count - 1, y). By itself, because kernels, compiled for several processors,
// include plain types only.
#pragma once

#include <cstdint>

namespace temblor::render {

struct SpanRun {
  std::uint16_t x, y, count;
};

}  // namespace temblor::render
