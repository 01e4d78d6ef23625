#include "lab/hidden_surfaces/surface_depths.h"

#include <algorithm>
#include <limits>

namespace temblor::lab {

std::span<const render::ScreenPlane> find_surface_depths(const render::FrameContext& context,
                                                         const render::ViewFrame& view,
                                                         const render::EdgeTable& table) {
  constexpr std::size_t kSurfacesPerJob = 64;
  const std::size_t count = table.first_deferred();
  const std::span<render::ScreenPlane> depths = context.arena().allocate<render::ScreenPlane>(count);
  depths[0] = {std::numeric_limits<double>::lowest(), 0, 0};
  context.jobs.parallel_for((count + kSurfacesPerJob - 1) / kSurfacesPerJob, [&](std::size_t job) {
    const std::size_t end = std::min((job + 1) * kSurfacesPerJob, count);
    for (std::size_t i = std::max<std::size_t>(job * kSurfacesPerJob, 1); i < end; ++i) {
      const render::ScreenSurface& surface = table.surfaces[i];
      if (surface.instance != 0) {
        depths[i] = table.fragments[surface.fragment].depth;
        continue;
      }
      const render::FacePlane plane = render::place_plane(context.level(), context.level().face(surface.face),
                                                          table.model_views[surface.instance]);
      depths[i] = render::depth_plane(view, plane.normal, plane.distance);
    }
  });
  return depths;
}

}  // namespace temblor::lab
