// Feeds arbitrary bytes to the reader of brush lists. It must return an error or a list that is written as
// the same bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/bspx/brush_list.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_brush_list(const std::uint8_t* data, std::size_t size) {
  using namespace temblor::formats;
  const base::Bytes bytes = std::as_bytes(std::span(data, size));
  const auto models = read_brush_list(bytes);
  if (models.ok()) CHECK(std::ranges::equal(write_brush_list(*models), bytes));
  return 0;
}
