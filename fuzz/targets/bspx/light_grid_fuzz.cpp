// Feeds arbitrary bytes to the reader of light grids. It must return an error or a grid that can be written
// and read again, and in which every sample can be found.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/levels/light_grid.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_light_grid(const std::uint8_t* data, std::size_t size) {
  using namespace temblor::formats;
  const auto grid = read_light_grid(std::as_bytes(std::span(data, size)));
  if (!grid.ok()) return 0;
  const auto again = read_light_grid(write_light_grid(*grid));
  CHECK(again.ok());
  CHECK(std::as_bytes(std::span(again->samples)).size() == std::as_bytes(std::span(grid->samples)).size());
  CHECK(grid->samples.size() <= size && grid->lights.size() <= size);
  for (const GridLeaf& leaf : grid->leaves) {
    const std::array<std::int32_t, 3> beyond = {leaf.mins[0], leaf.mins[1],
                                                static_cast<std::int32_t>(std::int64_t{leaf.mins[2]} / 2)};
    find_grid_lights(*grid, leaf.mins);
    find_grid_lights(*grid, beyond);
  }
  return 0;
}
