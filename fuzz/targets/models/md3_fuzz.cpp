// Feeds arbitrary bytes to the MD3 reader. It must return an error, or a model that keeps the promises of its
// header and becomes a drawable one.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/models/md3.h"
#include "fuzz/targets.h"
#include "fuzz/targets/models/posed_checks.h"

using namespace temblor;

int temblor::fuzz::fuzz_md3(const std::uint8_t* data, std::size_t size) {
  const auto md3 = formats::read_md3(std::as_bytes(std::span(data, size)));
  if (!md3.ok()) return 0;
  CHECK(!md3->frames.empty() && !md3->surfaces.empty());
  for (const formats::Md3Frame& frame : md3->frames)
    for (int axis = 0; axis < 3; ++axis)
      CHECK(std::isfinite(frame.bounds.mins[axis]) && std::isfinite(frame.bounds.maxs[axis]));
  for (const formats::Md3Surface& surface : md3->surfaces) {
    CHECK(surface.vertices.size() == surface.texels.size() * md3->frames.size());
    for (const auto& triangle : surface.triangles)
      for (const std::uint32_t vertex : triangle) CHECK(vertex < surface.texels.size());
  }
  const auto posed = formats::pose_md3(*md3);
  if (posed.ok()) check_drawable(*posed);
  return 0;
}
