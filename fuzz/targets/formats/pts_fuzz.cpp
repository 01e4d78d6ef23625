// Feeds arbitrary text to the reader of leak paths. It must return an error or points that are finite, and at
// most one for each line.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/levels/pts.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_pts(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = temblor::base::as_text(std::as_bytes(std::span(data, size)));
  const auto points = temblor::formats::read_pts(text);
  if (!points.ok()) return 0;
  CHECK(points->size() <= static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1);
  for (const temblor::math::Vec3& point : *points)
    CHECK(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z));
  return 0;
}
