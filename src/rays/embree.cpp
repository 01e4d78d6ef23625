#include "rays/embree.h"

#include <dlfcn.h>

namespace temblor::rays {
namespace {

// The version of the headers that this was compiled with; other versions have other structs.
#if RTC_VERSION_MAJOR >= 4
constexpr const char* kLibrary = "libembree4.so.4";
constexpr const char* kPackage = "libembree4-4";
#else
constexpr const char* kLibrary = "libembree3.so.3";
constexpr const char* kPackage = "libembree3-3";
#endif

// Looks up functions in an open library, and remembers whether one was missing.
class Symbols {
 public:
  explicit Symbols(void* library) : library_(library) {}

  template <typename Function>
  void find(const char* name, Function& out_function) {
    void* const symbol = library_ != nullptr ? dlsym(library_, name) : nullptr;
    if (symbol == nullptr) has_all_ = false;
    out_function = reinterpret_cast<Function>(symbol);
  }
  bool has_all() const { return has_all_; }

 private:
  void* library_;
  bool has_all_ = true;
};

}  // namespace

base::Result<Embree> Embree::load() {
  // Never closed, since its threads may run until the program ends.
  Symbols symbols(dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL));
  Embree embree;
  symbols.find("rtcNewDevice", embree.new_device);
  symbols.find("rtcReleaseDevice", embree.release_device);
  symbols.find("rtcGetDeviceError", embree.get_device_error);
  symbols.find("rtcNewScene", embree.new_scene);
  symbols.find("rtcReleaseScene", embree.release_scene);
  symbols.find("rtcSetSceneFlags", embree.set_scene_flags);
  symbols.find("rtcCommitScene", embree.commit_scene);
  symbols.find("rtcNewGeometry", embree.new_geometry);
  symbols.find("rtcReleaseGeometry", embree.release_geometry);
  symbols.find("rtcSetNewGeometryBuffer", embree.set_new_geometry_buffer);
  symbols.find("rtcSetGeometryUserData", embree.set_geometry_user_data);
  symbols.find("rtcSetGeometryOccludedFilterFunction", embree.set_geometry_occluded_filter_function);
  symbols.find("rtcSetGeometryIntersectFilterFunction", embree.set_geometry_intersect_filter_function);
  symbols.find("rtcCommitGeometry", embree.commit_geometry);
  symbols.find("rtcAttachGeometry", embree.attach_geometry);
  symbols.find("rtcOccluded16", embree.occluded16_);
  symbols.find("rtcIntersect16", embree.intersect16_);
  if (!symbols.has_all())
    return base::error(base::ErrorCode::kUnsupported,
                       "Embree is missing ({}): install the Debian package {}, or unpack the temblor-light "
                       "archive over the game",
                       kLibrary, kPackage);
  return embree;
}

// Embree 4 takes the flags with each query, Embree 3 with the context.
#if RTC_VERSION_MAJOR >= 4
void Embree::init_context(EmbreeContext& out_context) {
  rtcInitRayQueryContext(&out_context);
}
void Embree::occluded16(const int* valid, RTCScene scene, EmbreeContext& context, RTCRay16& io_rays) const {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  arguments.context = &context;
  occluded16_(valid, scene, &io_rays, &arguments);
}
void Embree::intersect16(const int* valid, RTCScene scene, EmbreeContext& context,
                         RTCRayHit16& io_rays) const {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  arguments.context = &context;
  intersect16_(valid, scene, &io_rays, &arguments);
}
#else
void Embree::init_context(EmbreeContext& out_context) {
  rtcInitIntersectContext(&out_context);
  out_context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
}
void Embree::occluded16(const int* valid, RTCScene scene, EmbreeContext& context, RTCRay16& io_rays) const {
  occluded16_(valid, scene, &context, &io_rays);
}
void Embree::intersect16(const int* valid, RTCScene scene, EmbreeContext& context,
                         RTCRayHit16& io_rays) const {
  intersect16_(valid, scene, &context, &io_rays);
}
#endif

}  // namespace temblor::rays
