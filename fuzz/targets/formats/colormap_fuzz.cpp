// Feeds arbitrary bytes to the colormap reader. It must return an error or a colormap that is written as the
// same bytes, followed by the number of full-bright colors, which a file may lack.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/images/palette.h"
#include "fuzz/targets.h"

using namespace temblor;

int temblor::fuzz::fuzz_colormap(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto colormap = formats::read_colormap(bytes);
  if (!colormap.ok()) return 0;
  const auto written = formats::write_colormap(*colormap);
  const std::size_t compared = std::min(size, written.size());
  CHECK(std::ranges::equal(base::Bytes(written).first(compared), bytes.first(compared)));
  return 0;
}
