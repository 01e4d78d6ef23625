#include "lab/world_light/rays/shadow_rays.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "rays/embree.h"

namespace temblor::lab {

namespace {

using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, decltype(&rtcReleaseDevice)>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, decltype(&rtcReleaseScene)>;
using Triangle = std::array<std::uint32_t, 3>;

bool is_sky(const world::Level& /*level*/, const world::Face& face) {
  return face.kind == world::FaceKind::kSky;
}
bool stops_light(const world::Level& level, const world::Face& face) {
  return (face.kind == world::FaceKind::kLit || face.kind == world::FaceKind::kUnlit) &&
         !level.textures[base::to_size(face.texture)].name.starts_with('{');
}

using IsWanted = bool (*)(const world::Level& level, const world::Face& face);

std::vector<Triangle> make_triangles(const world::Level& level, IsWanted is_wanted) {
  std::vector<Triangle> triangles;
  const world::Model& model = level.models.front();
  for (std::uint32_t i = model.first_face; i < model.first_face + model.face_count; ++i) {
    const world::Face& face = level.faces[i];
    if (!is_wanted(level, face)) continue;
    const auto corner = [&](std::uint32_t number) {
      return static_cast<std::uint32_t>(level.surfedge_start(face.first_surfedge + number));
    };
    for (std::uint32_t number = 1; number + 1 < face.surfedge_count; ++number)
      triangles.push_back({corner(0), corner(number), corner(number + 1)});
  }
  return triangles;
}

// Returns the number by which rays name the triangles. Errors, such as missing memory, stay in the device.
unsigned add_triangles(const rays::Embree& embree, RTCDevice device, RTCScene scene,
                       const world::Level& level, const std::vector<Triangle>& triangles) {
  if (triangles.empty()) return RTC_INVALID_GEOMETRY_ID;
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
  const unsigned number = embree.attach_geometry(scene, geometry);
  embree.release_geometry(geometry);
  return number;
}

// Rays between triangles that share an edge find no gap.
EmbreeScene make_scene(const rays::Embree& embree, RTCDevice device) {
  EmbreeScene scene(embree.new_scene(device), embree.release_scene);
  embree.set_scene_flags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  return scene;
}

base::Result<Device> make_device(const rays::Embree& embree) {
  Device device(embree.new_device(nullptr), embree.release_device);
  if (!device)
    return base::error(base::ErrorCode::kUnsupported, "Embree cannot start, which needs SSE2 or better");
  return device;
}

using ValidLanes = std::array<int, kRaysPerPacket>;

}  // namespace

struct ShadowRays::Scene {
  rays::Embree embree;
  Device device{nullptr, nullptr};
  EmbreeScene walls{nullptr, nullptr};
  EmbreeScene walls_and_sky{nullptr, nullptr};
  unsigned sky = RTC_INVALID_GEOMETRY_ID;  // in the latter; invalid: the level has no sky
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
  const RTCDevice device = made->device.get();
  const std::vector<Triangle> walls = make_triangles(level, stops_light), sky = make_triangles(level, is_sky);
  made->walls = make_scene(made->embree, device);
  add_triangles(made->embree, device, made->walls.get(), level, walls);
  made->embree.commit_scene(made->walls.get());
  if (!sky.empty()) {
    made->walls_and_sky = make_scene(made->embree, device);
    add_triangles(made->embree, device, made->walls_and_sky.get(), level, walls);
    made->sky = add_triangles(made->embree, device, made->walls_and_sky.get(), level, sky);
    made->embree.commit_scene(made->walls_and_sky.get());
  }
  if (made->embree.get_device_error(made->device.get()) != RTC_ERROR_NONE)
    return base::error(base::ErrorCode::kTooLarge, "{}: there is not enough memory for {} triangles",
                       level.name, walls.size() + sky.size());
  return ShadowRays(std::move(made));
}

std::uint32_t ShadowRays::find_lit(const PointPacket& points, std::uint32_t wanted,
                                   const math::Vec3& lamp_world) const {
  alignas(64) ValidLanes valid;
  RTCRay16 ray;
  for (std::size_t i = 0; i < kRaysPerPacket; ++i) {
    valid[i] = (wanted >> i & 1) != 0 ? -1 : 0;
    const math::Vec3 from(points[0][i], points[1][i], points[2][i]);
    rays::set_lane(ray, i, from, lamp_world - from, 1);
  }
  rays::EmbreeContext context;
  rays::Embree::init_context(context);
  scene_->embree.occluded16(valid.data(), scene_->walls.get(), context, ray);
  // Embree sets tfar to minus infinity if a ray is blocked.
  std::uint32_t lit = 0;
  for (std::size_t i = 0; i < kRaysPerPacket; ++i) lit |= std::uint32_t{ray.tfar[i] >= 0} << i;
  return lit & wanted;
}

std::uint32_t ShadowRays::find_under_sky(const PointPacket& points, std::uint32_t wanted,
                                         const math::Vec3& toward_sky) const {
  if (scene_->sky == RTC_INVALID_GEOMETRY_ID) return 0;
  alignas(64) ValidLanes valid;
  RTCRayHit16 packet;
  for (std::size_t i = 0; i < kRaysPerPacket; ++i) {
    valid[i] = (wanted >> i & 1) != 0 ? -1 : 0;
    rays::set_lane(packet.ray, i, {points[0][i], points[1][i], points[2][i]}, toward_sky,
                   std::numeric_limits<float>::infinity());
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  rays::EmbreeContext context;
  rays::Embree::init_context(context);
  scene_->embree.intersect16(valid.data(), scene_->walls_and_sky.get(), context, packet);
  std::uint32_t lit = 0;
  for (std::size_t i = 0; i < kRaysPerPacket; ++i)
    lit |= std::uint32_t{packet.hit.geomID[i] == scene_->sky} << i;
  return lit & wanted;
}

}  // namespace temblor::lab
