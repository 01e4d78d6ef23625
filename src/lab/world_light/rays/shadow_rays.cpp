#include "lab/world_light/rays/shadow_rays.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "rays/embree.h"

namespace temblor::lab {

namespace {

using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, decltype(&rtcReleaseDevice)>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, decltype(&rtcReleaseScene)>;
using Triangle = std::array<std::uint32_t, 3>;

bool stops_light(const world::Level& level, const world::Face& face) {
  return (face.kind == world::FaceKind::kLit || face.kind == world::FaceKind::kUnlit) &&
         !level.textures[base::to_size(face.texture)].name.starts_with('{');
}

std::vector<Triangle> make_triangles(const world::Level& level) {
  std::vector<Triangle> triangles;
  const world::Model& model = level.models.front();
  for (std::uint32_t i = model.first_face; i < model.first_face + model.face_count; ++i) {
    const world::Face& face = level.faces[i];
    if (!stops_light(level, face)) continue;
    const auto corner = [&](std::uint32_t number) {
      return static_cast<std::uint32_t>(level.surfedge_start(face.first_surfedge + number));
    };
    for (std::uint32_t number = 1; number + 1 < face.surfedge_count; ++number)
      triangles.push_back({corner(0), corner(number), corner(number + 1)});
  }
  return triangles;
}

// Errors, such as missing memory, stay in the device.
void add_triangles(const rays::Embree& embree, RTCDevice device, RTCScene scene, const world::Level& level,
                   const std::vector<Triangle>& triangles) {
  if (triangles.empty()) return;
  const RTCGeometry geometry = embree.new_geometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* const positions = embree.set_new_geometry_buffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(math::Vec3), level.vertices.size());
  void* const indices = embree.set_new_geometry_buffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                       sizeof(Triangle), triangles.size());
  if (positions != nullptr && indices != nullptr) {
    std::ranges::copy(level.vertices, static_cast<math::Vec3*>(positions));
    std::ranges::copy(triangles, static_cast<Triangle*>(indices));
  }
  embree.commit_geometry(geometry);
  embree.attach_geometry(scene, geometry);
  embree.release_geometry(geometry);
}

base::Result<Device> make_device(const rays::Embree& embree) {
  Device device(embree.new_device(nullptr), embree.release_device);
  if (!device)
    return base::error(base::ErrorCode::kUnsupported, "Embree cannot start, which needs SSE2 or better");
  return device;
}

}  // namespace

struct ShadowRays::Scene {
  rays::Embree embree;
  Device device{nullptr, nullptr};
  EmbreeScene scene{nullptr, nullptr};
};

ShadowRays::ShadowRays(std::unique_ptr<Scene> scene) : scene_(std::move(scene)) {}
ShadowRays::~ShadowRays() = default;
ShadowRays::ShadowRays(ShadowRays&&) noexcept = default;
ShadowRays& ShadowRays::operator=(ShadowRays&&) noexcept = default;

base::Status ShadowRays::check() {
  TRY(const rays::Embree embree, rays::Embree::load());
  TRY_STATUS(make_device(embree));
  return base::Ok{};
}

base::Result<ShadowRays> ShadowRays::make(const world::Level& level) {
  auto made = std::make_unique<Scene>();
  TRY(made->embree, rays::Embree::load());
  TRY(made->device, make_device(made->embree));
  made->scene = EmbreeScene(made->embree.new_scene(made->device.get()), made->embree.release_scene);
  made->embree.set_scene_flags(made->scene.get(), RTC_SCENE_FLAG_ROBUST);
  const std::vector<Triangle> triangles = make_triangles(level);
  add_triangles(made->embree, made->device.get(), made->scene.get(), level, triangles);
  made->embree.commit_scene(made->scene.get());
  if (made->embree.get_device_error(made->device.get()) != RTC_ERROR_NONE)
    return base::error(base::ErrorCode::kTooLarge, "{}: there is not enough memory for {} triangles",
                       level.name, triangles.size());
  return ShadowRays(std::move(made));
}

std::uint32_t ShadowRays::find_lit(const PointPacket& points, std::uint32_t wanted,
                                   const math::Vec3& lamp_world) const {
  alignas(64) std::array<int, kRaysPerPacket> valid;
  RTCRay16 ray;
  for (std::size_t i = 0; i < kRaysPerPacket; ++i) {
    valid[i] = (wanted >> i & 1) != 0 ? -1 : 0;
    ray.org_x[i] = points[0][i];
    ray.org_y[i] = points[1][i];
    ray.org_z[i] = points[2][i];
    ray.dir_x[i] = lamp_world.x - points[0][i];
    ray.dir_y[i] = lamp_world.y - points[1][i];
    ray.dir_z[i] = lamp_world.z - points[2][i];
    ray.tnear[i] = 0;
    ray.tfar[i] = 1;
    ray.time[i] = 0;
    ray.mask[i] = ~0u;
    ray.id[i] = static_cast<unsigned>(i);
    ray.flags[i] = 0;
  }
  rays::EmbreeContext context;
  rays::Embree::init_context(context);
  scene_->embree.occluded16(valid.data(), scene_->scene.get(), context, ray);
  // Embree sets tfar to minus infinity if a ray is blocked.
  std::uint32_t lit = 0;
  for (std::size_t i = 0; i < kRaysPerPacket; ++i) lit |= std::uint32_t{ray.tfar[i] >= 0} << i;
  return lit & wanted;
}

}  // namespace temblor::lab
