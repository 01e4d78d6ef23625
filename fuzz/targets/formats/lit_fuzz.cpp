// Feeds arbitrary bytes to the LIT reader. It must return an error or light samples that are written as the
// same bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/levels/lit.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_lit(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto lit = temblor::formats::read_lit(bytes);
  if (lit.ok()) CHECK(std::ranges::equal(temblor::formats::write_lit(*lit), bytes));
  return 0;
}
