// Feeds arbitrary text to the reader of locations. Names must be printable and short, boxes must not be
// inside out, and each location must be found in its own middle, or another one there.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/levels/locations.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_locations(const std::uint8_t* data, std::size_t size) {
  using namespace temblor::formats;
  const std::vector<Location> locations = read_locations(base::as_text(std::as_bytes(std::span(data, size))));
  CHECK(locations.size() <= std::min<std::size_t>(size / 6, 4096));
  for (const Location& location : locations) {
    CHECK(!location.name.empty() && location.name.size() <= 64);
    CHECK(std::ranges::all_of(location.name, [](char c) { return c >= ' ' && c <= '~'; }));
    for (int axis = 0; axis < 3; ++axis) CHECK(location.box.mins[axis] <= location.box.maxs[axis]);
  }
  if (!locations.empty()) {
    const Location* found = find_location(locations, locations[0].box.mins);
    CHECK(found != nullptr && found->box.mins.x <= locations[0].box.mins.x);
  }
  return 0;
}
