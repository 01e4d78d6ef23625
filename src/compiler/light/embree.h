// Embree 3 and 4 under one set of names. Included by ray_scene.cpp alone.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace temblor::compiler {

#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;

inline void init_context(EmbreeContext& out_context) {
  rtcInitRayQueryContext(&out_context);
}
inline void occluded16(const int* valid, RTCScene scene, EmbreeContext& context, RTCRay16& io_rays) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  arguments.context = &context;
  rtcOccluded16(valid, scene, &io_rays, &arguments);
}
inline void intersect16(const int* valid, RTCScene scene, EmbreeContext& context, RTCRayHit16& io_rays) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  arguments.context = &context;
  rtcIntersect16(valid, scene, &io_rays, &arguments);
}
#else
using EmbreeContext = RTCIntersectContext;

inline void init_context(EmbreeContext& out_context) {
  rtcInitIntersectContext(&out_context);
  out_context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
}
inline void occluded16(const int* valid, RTCScene scene, EmbreeContext& context, RTCRay16& io_rays) {
  rtcOccluded16(valid, scene, &context, &io_rays);
}
inline void intersect16(const int* valid, RTCScene scene, EmbreeContext& context, RTCRayHit16& io_rays) {
  rtcIntersect16(valid, scene, &context, &io_rays);
}
#endif

}  // namespace temblor::compiler
