#include "lab/models/stack/cache_simulator.h"

#include <algorithm>
#include <span>

#include "base/check.h"

namespace temblor::lab {

CacheSimulator::CacheSimulator(const CacheShape& shape)
    : shape_(shape), sets_(shape.bytes / (shape.ways * shape.line_bytes)), lines_(sets_ * shape.ways) {
  CHECK(sets_ * shape.ways * shape.line_bytes == shape.bytes && sets_ > 0, "{} bytes", shape.bytes);
}

void CacheSimulator::touch(std::uint64_t address, std::size_t bytes) {
  if (bytes == 0) return;
  const std::uint64_t last = (address + bytes - 1) / shape_.line_bytes;
  for (std::uint64_t line = address / shape_.line_bytes; line <= last; ++line) touch_line(line);
}

void CacheSimulator::touch_line(std::uint64_t number) {
  const std::span<Line> set = std::span(lines_).subspan(number % sets_ * shape_.ways, shape_.ways);
  ++time_;
  const auto found =
      std::ranges::find_if(set, [&](const Line& line) { return line.last_use > 0 && line.number == number; });
  if (found != set.end()) {
    found->last_use = time_;
    return;
  }
  ++misses_;
  *std::ranges::min_element(set, {}, &Line::last_use) = {number, time_};
}

}  // namespace temblor::lab
