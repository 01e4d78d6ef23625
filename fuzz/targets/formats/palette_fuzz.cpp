// Feeds arbitrary bytes to the palette reader. It must return an error or a palette that is written as the
// same bytes, without those after the last color.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/images/palette.h"
#include "fuzz/targets.h"

using namespace temblor;

int temblor::fuzz::fuzz_palette(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto palette = formats::read_palette(bytes);
  constexpr std::size_t kBytes = 768;
  if (palette.ok()) CHECK(std::ranges::equal(formats::write_palette(*palette), bytes.first(kBytes)));
  return 0;
}
