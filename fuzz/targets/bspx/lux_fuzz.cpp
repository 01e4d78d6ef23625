// Feeds arbitrary bytes to the LUX reader. It must return an error, or directions that are written as the
// same bytes and that survive unpacking and packing.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/bspx/light_directions.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_lux(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto samples = temblor::formats::read_lux(bytes);
  if (!samples.ok()) return 0;
  CHECK(std::ranges::equal(temblor::formats::write_lux(*samples), bytes));
  for (std::size_t i = 0; i < samples->size(); i += 3) {
    const auto packed = std::span(*samples).subspan(i).first<3>();
    const auto again = temblor::formats::pack_direction(temblor::formats::unpack_direction(packed));
    // Byte 0 lies below -1, which is byte 1.
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(again[axis] == std::max<std::uint8_t>(packed[axis], 1));
  }
  return 0;
}
