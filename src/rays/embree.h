// Embree 3 and 4 (Wald et al., "Embree: a kernel framework for efficient CPU ray tracing", 2014) under one
// set of names. The library is opened at run time instead of linked, since it would be a fifth of the game's
// download and only light and the laboratory need it.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstddef>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::rays {

#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;
#else
using EmbreeContext = RTCIntersectContext;
#endif

// Embree's functions, named without the "rtc". Valid until the program ends.
struct Embree {
  // Fails with kUnsupported, and says what to install, if the library is missing.
  static base::Result<Embree> load();

  // Prepares for rays that run in similar directions.
  static void init_context(EmbreeContext& out_context);
  void occluded16(const int* valid, RTCScene scene, EmbreeContext& context, RTCRay16& io_rays) const;
  void intersect16(const int* valid, RTCScene scene, EmbreeContext& context, RTCRayHit16& io_rays) const;

  decltype(&rtcNewDevice) new_device = nullptr;
  decltype(&rtcReleaseDevice) release_device = nullptr;
  decltype(&rtcGetDeviceError) get_device_error = nullptr;
  decltype(&rtcNewScene) new_scene = nullptr;
  decltype(&rtcReleaseScene) release_scene = nullptr;
  decltype(&rtcSetSceneFlags) set_scene_flags = nullptr;
  decltype(&rtcCommitScene) commit_scene = nullptr;
  decltype(&rtcNewGeometry) new_geometry = nullptr;
  decltype(&rtcReleaseGeometry) release_geometry = nullptr;
  decltype(&rtcSetNewGeometryBuffer) set_new_geometry_buffer = nullptr;
  decltype(&rtcSetGeometryUserData) set_geometry_user_data = nullptr;
  decltype(&rtcSetGeometryOccludedFilterFunction) set_geometry_occluded_filter_function = nullptr;
  decltype(&rtcSetGeometryIntersectFilterFunction) set_geometry_intersect_filter_function = nullptr;
  decltype(&rtcCommitGeometry) commit_geometry = nullptr;
  decltype(&rtcAttachGeometry) attach_geometry = nullptr;

 private:
  decltype(&rtcOccluded16) occluded16_ = nullptr;
  decltype(&rtcIntersect16) intersect16_ = nullptr;
};

// Sets one ray of a packet. `reach`: in lengths of `direction`.
inline void set_lane(RTCRay16& io_rays, std::size_t lane, const math::Vec3& origin,
                     const math::Vec3& direction, float reach) {
  io_rays.org_x[lane] = origin.x;
  io_rays.org_y[lane] = origin.y;
  io_rays.org_z[lane] = origin.z;
  io_rays.dir_x[lane] = direction.x;
  io_rays.dir_y[lane] = direction.y;
  io_rays.dir_z[lane] = direction.z;
  io_rays.tnear[lane] = 0;
  io_rays.tfar[lane] = reach;
  io_rays.time[lane] = 0;
  io_rays.mask[lane] = ~0u;
  io_rays.id[lane] = static_cast<unsigned>(lane);
  io_rays.flags[lane] = 0;
}

}  // namespace temblor::rays
