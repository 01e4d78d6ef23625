// Embree 3 and 4 under one set of names. The library is opened when light is worked out, and not linked with:
// it is a fifth of what a player would have to fetch, and only who compiles levels needs it. Included by
// ray_scene.cpp alone.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "base/result.h"

namespace temblor::compiler {

#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;
#else
using EmbreeContext = RTCIntersectContext;
#endif

// Embree's functions, by its names without the "rtc". Good for as long as the program runs.
struct Embree {
  // kUnsupported, with what to install: the library is not on this machine.
  static base::Result<Embree> load();

  // For rays that run much the same way.
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

}  // namespace temblor::compiler
