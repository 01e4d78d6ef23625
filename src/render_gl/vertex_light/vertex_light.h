// The light at a corner of a face, from its light map's samples and from dynamic lights, as the CPU sums both
// for its surface blocks (render/surfaces/light).
#pragma once

#include <array>
#include <cstdint>

#include "base/arena.h"
#include "render/surfaces/build_surface.h"

namespace temblor::render_gl {

// Light at a point of a face, interpolated between the up to four samples around it. The face, its styles,
// and its lights are those of `request`, whatever its tile. `s`, `t`: texels of mip 0 from the face's first
// one; outside of the face, the light is that of its border. The result is in the units of
// make_rgb_samples(): blue, green, red. `scratch` is reset.
std::array<std::int16_t, 3> find_light_at(const world::Level& level, const render::BlockRequest& request,
                                          double s, double t, base::Arena& scratch);

}  // namespace temblor::render_gl
