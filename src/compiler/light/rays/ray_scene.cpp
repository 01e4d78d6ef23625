// Method: rays go to Embree in packets of 16 neighbors, most of which run in similar directions. Surfaces
// that let some light through are in a separate scene with a filter, which records how much light is lost and
// lets the ray continue. Losses are logarithms summed as integers, so that their order does not matter.
#include "compiler/light/rays/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "rays/embree.h"

namespace temblor::compiler {
namespace {

constexpr std::size_t kLanes = 16;
constexpr float kLossSteps = 65536;  // for a factor of e
constexpr float kMinShare = 1.0f / 1024;

using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, decltype(&rtcReleaseDevice)>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, decltype(&rtcReleaseScene)>;

// The masks that a ray has passed. Embree may report one twice, and on the diagonal of a face a ray meets two
// triangles. Beyond the twelfth, more of them make no visible difference.
struct PassedSurfaces {
  std::array<std::uint32_t, 12> surfaces;  // the first `count` of them
  std::size_t count = 0;

  // Returns false if the surface is known or if there is no room.
  bool add(std::uint32_t surface) {
    const auto end = surfaces.begin() + static_cast<std::ptrdiff_t>(count);
    if (count == surfaces.size() || std::find(surfaces.begin(), end, surface) != end) return false;
    surfaces[count++] = surface;
    return true;
  }
};

// The records of the filters for each lane. Embree passes the first member to them.
struct AttenuationContext {
  rays::EmbreeContext embree;
  std::array<std::array<std::int32_t, 3>, kLanes> lost{};
  std::array<PassedSurfaces, kLanes> passed{};
  std::array<std::uint8_t, kLanes> switch_style{};  // of the switchable shadows; 0: none
  LightPath path;
};
constexpr std::uint8_t kSeveralStyles = 255;  // in AttenuationContext::switch_style
// The best hit so far of each lane, for keep_lowest_surface().
struct TieContext {
  rays::EmbreeContext embree;
  std::array<float, kLanes> distance{};  // of the best hit so far; below 0: none
  std::array<std::uint32_t, kLanes> surface{};
};

// Textures repeat in both directions.
std::uint32_t wrap_texel(float coordinate, std::uint32_t size) {
  const auto texel = static_cast<std::int64_t>(std::floor(coordinate)) % std::int64_t{size};
  return static_cast<std::uint32_t>(texel < 0 ? texel + std::int64_t{size} : texel);
}

math::Vec3 find_transmission(const AlphaMask& surface, const math::Vec3& point) {
  if (surface.transmission_by_texel.empty()) return surface.transmission;
  const std::uint32_t s = wrap_texel(glm::dot(point, surface.s_axis) + surface.s_offset, surface.width);
  const std::uint32_t t = wrap_texel(glm::dot(point, surface.t_axis) + surface.t_offset, surface.height);
  return surface.transmission_by_texel[surface.texels[std::size_t{t} * surface.width + s]];
}

// The share of light that passes at a point, in a direction.
math::Vec3 compute_share_through(const AlphaMask& surface, const math::Vec3& point,
                                 const math::Vec3& direction) {
  const math::Vec3 transmission = find_transmission(surface, point);
  // A pane has two faces but dims light only once.
  if (transmission != math::Vec3(0.0f) && glm::dot(direction, surface.normal) > 0) return math::Vec3(1.0f);
  return transmission;
}

// Whether the surface stops this light before it comes to the receiving model.
bool may_stop(const AlphaMask& surface, const LightPath& path) {
  if ((surface.channels & path.shadow_channels) == 0) return false;
  switch (surface.receivers) {
    case ShadowReceivers::kAll:
      break;
    case ShadowReceivers::kOwnModel:
      return path.receiver_model == surface.model;
    case ShadowReceivers::kWorld:
      return path.receiver_model == 0;
  }
  return true;
}

// Notes a switchable shadow on a ray.
void note_switch_style(std::uint8_t style, std::uint8_t& io_known) {
  io_known = io_known == 0 || io_known == style ? style : kSeveralStyles;
}

// The facts about the sky for reject_back_sides().
struct SkySet {
  std::vector<OccluderTriangle> triangles;
  std::vector<math::Vec3> normals;
  std::vector<std::uint32_t> names;
};

math::Vec3 read_ray_direction(const RTCFilterFunctionNArguments& arguments, unsigned lane) {
  const unsigned lanes = arguments.N;
  return {RTCRayN_dir_x(arguments.ray, lanes, lane), RTCRayN_dir_y(arguments.ray, lanes, lane),
          RTCRayN_dir_z(arguments.ray, lanes, lane)};
}

// The facts about the masks for pass_alpha_masks().
struct AlphaMaskSet {
  std::vector<OccluderTriangle> triangles;
  std::vector<AlphaMask> surfaces;
};

// Embree's filter for masks: records the loss of light and clears the hit, unless nothing passes.
void pass_alpha_masks(const RTCFilterFunctionNArguments* arguments) {
  const auto& masks = *static_cast<const AlphaMaskSet*>(arguments->geometryUserPtr);
  auto& losses = *reinterpret_cast<AttenuationContext*>(arguments->context);
  const unsigned lanes = arguments->N;
  for (unsigned i = 0; i < lanes; ++i) {
    if (arguments->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(arguments->hit, lanes, i);
    const math::Vec3 direction = read_ray_direction(*arguments, i);
    const math::Vec3 origin(RTCRayN_org_x(arguments->ray, lanes, i), RTCRayN_org_y(arguments->ray, lanes, i),
                            RTCRayN_org_z(arguments->ray, lanes, i));
    const math::Vec3 point = origin + direction * RTCRayN_tfar(arguments->ray, lanes, i);
    const std::uint32_t number = masks.triangles[triangle].surface;
    const AlphaMask& surface = masks.surfaces[number];
    const math::Vec3 share =
        may_stop(surface, losses.path) ? compute_share_through(surface, point, direction) : math::Vec3(1.0f);
    if (surface.switch_style != 0) {
      arguments->valid[i] = 0;
      if (share != math::Vec3(1.0f))
        note_switch_style(surface.switch_style, losses.switch_style[RTCRayN_id(arguments->ray, lanes, i)]);
      continue;
    }
    if (std::max({share.x, share.y, share.z}) < kMinShare)
      continue;  // it is as good as opaque: the hit stays
    arguments->valid[i] = 0;
    const unsigned lane = RTCRayN_id(arguments->ray, lanes, i);
    if (share == math::Vec3(1.0f) || !losses.passed[lane].add(number)) continue;
    for (int channel = 0; channel < 3; ++channel)
      losses.lost[lane][static_cast<std::size_t>(channel)] -=
          static_cast<std::int32_t>(std::lround(std::log(std::max(share[channel], kMinShare)) * kLossSteps));
  }
}

// Sky is not visible from behind; another face of it that is visible is often in the same plane.
void reject_back_sides(const RTCFilterFunctionNArguments* arguments) {
  const auto& skies = *static_cast<const SkySet*>(arguments->geometryUserPtr);
  const unsigned lanes = arguments->N;
  for (unsigned i = 0; i < lanes; ++i) {
    if (arguments->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(arguments->hit, lanes, i);
    const math::Vec3& normal = skies.normals[skies.triangles[triangle].surface];
    if (glm::dot(read_ray_direction(*arguments, i), normal) >= 0) arguments->valid[i] = 0;
  }
}

// Among hits at the same distance, keeps the one with the lowest surface number, in whatever order they are
// found.
void keep_lowest_surface(const RTCFilterFunctionNArguments* arguments) {
  const auto& triangles = *static_cast<const std::vector<OccluderTriangle>*>(arguments->geometryUserPtr);
  auto& ties = *reinterpret_cast<TieContext*>(arguments->context);
  const unsigned lanes = arguments->N;
  for (unsigned i = 0; i < lanes; ++i) {
    if (arguments->valid[i] == 0) continue;
    const unsigned lane = RTCRayN_id(arguments->ray, lanes, i);
    const float distance = RTCRayN_tfar(arguments->ray, lanes, i);
    const std::uint32_t surface = triangles[RTCHitN_primID(arguments->hit, lanes, i)].surface;
    if (distance == ties.distance[lane] && surface > ties.surface[lane]) {
      arguments->valid[i] = 0;
      continue;
    }
    ties.distance[lane] = distance;
    ties.surface[lane] = surface;
  }
}

// Whether light counts that has passed these switchable shadows.
bool counts(std::uint8_t switch_style, const LightPath& path) {
  switch (path.switched) {
    case LightPath::Switched::kPass:
      break;
    case LightPath::Switched::kStop:
      return switch_style == 0;
    case LightPath::Switched::kOnly:
      return switch_style == path.only_style;
  }
  return true;
}

// The share of light that is left after all losses.
math::Vec3 compute_share_after(const std::array<std::int32_t, 3>& lost) {
  if ((lost[0] | lost[1] | lost[2]) == 0) return math::Vec3(1.0f);
  math::Vec3 share;
  for (int channel = 0; channel < 3; ++channel)
    share[channel] = std::exp(static_cast<float>(-lost[static_cast<std::size_t>(channel)]) / kLossSteps);
  return share;
}

// Functions that Embree calls for each hit on a geometry, and what they get as geometryUserPtr.
struct Filter {
  void* data = nullptr;
  RTCFilterFunctionN occluded = nullptr, intersected = nullptr;
};

// Errors, such as missing memory, stay in the device until RayScene::make() asks for them.
void add_triangles(const rays::Embree& embree, RTCDevice device, RTCScene scene,
                   std::span<const math::Vec3> vertices, std::span<const OccluderTriangle> triangles,
                   const Filter& filter) {
  if (triangles.empty()) return;
  const RTCGeometry geometry = embree.new_geometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  // Embree reads 16 bytes for each vertex; buffers that it allocates have the padding for the last one.
  void* positions = embree.set_new_geometry_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                   sizeof(math::Vec3), vertices.size());
  void* indices = embree.set_new_geometry_buffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                 sizeof(std::uint32_t) * 3, triangles.size());
  if (positions != nullptr && indices != nullptr) {
    std::copy(vertices.begin(), vertices.end(), static_cast<math::Vec3*>(positions));
    auto* corner = static_cast<std::uint32_t*>(indices);
    for (const OccluderTriangle& triangle : triangles)
      corner = std::copy_n(triangle.corners.begin(), 3, corner);
  }
  embree.set_geometry_user_data(geometry, filter.data);
  if (filter.occluded != nullptr) embree.set_geometry_occluded_filter_function(geometry, filter.occluded);
  if (filter.intersected != nullptr)
    embree.set_geometry_intersect_filter_function(geometry, filter.intersected);
  embree.commit_geometry(geometry);
  embree.attach_geometry(scene, geometry);
  embree.release_geometry(geometry);
}

Scene make_scene(const rays::Embree& embree, RTCDevice device) {
  Scene scene(embree.new_scene(device), embree.release_scene);
  embree.set_scene_flags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  return scene;
}

// Fills the lanes from `count` on with valid rays: Embree looks at them though they are masked out.
void fill_lanes(RTCRay16& io_rays, std::size_t count) {
  for (std::size_t i = count; i < kLanes; ++i)
    rays::set_lane(io_rays, i, math::Vec3(0.0f), math::Vec3(0, 0, 1), 0);
}

// -1 in a lane means that it takes part.
struct alignas(64) LaneMask {
  std::array<int, kLanes> lane{};
  bool any() const {
    return std::any_of(lane.begin(), lane.end(), [](int value) { return value != 0; });
  }
};

LaneMask make_first_lanes(std::size_t count) {
  LaneMask mask;
  std::fill_n(mask.lane.begin(), count, -1);
  return mask;
}

constexpr float kSkyDistance = 1 << 26;       // longer than any level
constexpr std::uint32_t kOpaqueChannels = 1;  // of opaque triangles

std::vector<std::uint8_t> list_switch_styles(std::span<const AlphaMask> surfaces) {
  std::set<std::uint8_t> styles;
  for (const AlphaMask& surface : surfaces)
    if (surface.switch_style != 0) styles.insert(surface.switch_style);
  return {styles.begin(), styles.end()};
}

}  // namespace

// One Embree scene for each kind of surface, so that queries meet only what they ask for.
struct RayScene::Scenes {
  rays::Embree embree;
  Device device{nullptr, nullptr};
  Scene opaque{nullptr, nullptr}, masked{nullptr, nullptr}, sky{nullptr, nullptr};
  AlphaMaskSet masks;
  SkySet skies;
  std::vector<OccluderTriangle> opaque_triangles;
  std::vector<std::uint8_t> switch_styles;

  // Whether light comes from this triangle of the sky.
  bool may_shine_from(const LightPath& path, unsigned triangle) const {
    return !path.sky_name || skies.names[skies.triangles[triangle].surface] == *path.sky_name;
  }

  // Finds the shares of the rays in `mask` and leaves the others unchanged.
  void compute_shares(const LaneMask& mask, RTCRay16& io_rays, math::Vec3* out_share,
                      const LightPath& path) const {
    rays::EmbreeContext plain;
    rays::Embree::init_context(plain);
    if ((path.shadow_channels & kOpaqueChannels) != 0)
      embree.occluded16(mask.lane.data(), opaque.get(), plain, io_rays);
    // Embree sets tfar to minus infinity if a ray is blocked.
    LaneMask left = mask;
    for (std::size_t i = 0; i < kLanes; ++i) {
      if (mask.lane[i] == 0) continue;
      const bool arrives = io_rays.tfar[i] >= 0;
      out_share[i] = math::Vec3(arrives && counts(0, path) ? 1.0f : 0.0f);
      if (!arrives) left.lane[i] = 0;
    }
    if (!masks.triangles.empty() && left.any()) pass_masks(left, io_rays, out_share, path);
  }

  // The same, for rays that no opaque surface stops. The records of the filters are large.
  void pass_masks(const LaneMask& mask, RTCRay16& io_rays, math::Vec3* out_share,
                  const LightPath& path) const {
    AttenuationContext context;
    context.path = path;
    rays::Embree::init_context(context.embree);
    embree.occluded16(mask.lane.data(), masked.get(), context.embree, io_rays);
    for (std::size_t i = 0; i < kLanes; ++i) {
      if (mask.lane[i] == 0) continue;
      const bool arrives = io_rays.tfar[i] >= 0 && counts(context.switch_style[i], path);
      out_share[i] = arrives ? compute_share_after(context.lost[i]) : math::Vec3(0.0f);
    }
  }
};

RayScene::RayScene(std::unique_ptr<Scenes> scenes) : scenes_(std::move(scenes)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

base::Status RayScene::check() {
  const base::Result<RayScene> nothing = make({});
  return nothing.ok() ? base::Status(base::Ok{}) : nothing.error();
}

// The occluders' lists move into Scenes, where filters can refer to them.
base::Result<RayScene> RayScene::make(Occluders occluders) {
  auto scenes = std::make_unique<Scenes>();
  base::Result<rays::Embree> loaded = rays::Embree::load();
  if (!loaded.ok())
    return base::error(loaded.error().code, "{}; --no-light compiles without light", loaded.error().what);
  scenes->embree = loaded.value();
  const rays::Embree& embree = scenes->embree;
  // The same instruction set on all machines, since others round differently.
  scenes->device = Device(embree.new_device("isa=avx2"), embree.release_device);
  if (!scenes->device)
    return base::error(
        base::ErrorCode::kUnsupported,
        "Embree cannot start, which needs a processor with AVX2; --no-light compiles without light");
  const RTCDevice device = scenes->device.get();
  scenes->masks = {std::move(occluders.masked), std::move(occluders.alpha_masks)};
  scenes->opaque_triangles = std::move(occluders.opaque);
  scenes->skies = {std::move(occluders.skies), std::move(occluders.sky_normals),
                   std::move(occluders.sky_names)};
  scenes->switch_styles = list_switch_styles(scenes->masks.surfaces);
  scenes->opaque = make_scene(embree, device);
  add_triangles(embree, device, scenes->opaque.get(), occluders.vertices, scenes->opaque_triangles,
                {&scenes->opaque_triangles, nullptr, keep_lowest_surface});
  scenes->masked = make_scene(embree, device);
  add_triangles(embree, device, scenes->masked.get(), occluders.vertices, scenes->masks.triangles,
                {&scenes->masks, pass_alpha_masks, nullptr});
  scenes->sky = make_scene(embree, device);
  add_triangles(embree, device, scenes->sky.get(), occluders.vertices, scenes->skies.triangles,
                {&scenes->skies, nullptr, reject_back_sides});
  for (const RTCScene scene : {scenes->opaque.get(), scenes->masked.get(), scenes->sky.get()})
    embree.commit_scene(scene);
  if (embree.get_device_error(device) != RTC_ERROR_NONE)
    return base::error(base::ErrorCode::kTooLarge, "there is not enough memory to light {} triangles",
                       scenes->opaque_triangles.size());
  return RayScene(std::move(scenes));
}

std::span<const std::uint8_t> RayScene::switch_styles() const {
  return scenes_->switch_styles;
}

bool RayScene::has_sky() const {
  return !scenes_->skies.triangles.empty();
}

// Directions are not unit vectors here: each leads to the source, which is then at distance 1.
void RayScene::trace_to_point(std::span<const math::Vec3> points, const math::Vec3& source_world,
                              std::span<math::Vec3> out_share, const LightPath& path) const {
  CHECK(points.size() == out_share.size());
  RTCRay16 rays;
  for (std::size_t first = 0; first < points.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, points.size() - first);
    for (std::size_t i = 0; i < count; ++i)
      rays::set_lane(rays, i, points[first + i], source_world - points[first + i], 1);
    fill_lanes(rays, count);
    scenes_->compute_shares(make_first_lanes(count), rays, out_share.data() + first, path);
  }
}

// First finds the sky along each ray, which shortens the ray to that distance; then looks for anything that
// is in front of the sky.
void RayScene::trace_to_sky(std::span<const math::Vec3> points, const math::Vec3& direction,
                            std::span<math::Vec3> out_share, const LightPath& path) const {
  CHECK(points.size() == out_share.size());
  RTCRayHit16 rays;
  rays::EmbreeContext context;
  rays::Embree::init_context(context);
  for (std::size_t first = 0; first < points.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, points.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      rays::set_lane(rays.ray, i, points[first + i], direction, kSkyDistance);
      rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      out_share[first + i] = math::Vec3(0.0f);
    }
    fill_lanes(rays.ray, count);
    LaneMask mask = make_first_lanes(count);
    scenes_->embree.intersect16(mask.lane.data(), scenes_->sky.get(), context, rays);
    for (std::size_t i = 0; i < count; ++i)
      if (rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID || !scenes_->may_shine_from(path, rays.hit.primID[i]))
        mask.lane[i] = 0;
    if (mask.any()) scenes_->compute_shares(mask, rays.ray, out_share.data() + first, path);
  }
}

void RayScene::trace_to_void(std::span<const math::Vec3> points, const math::Vec3& direction,
                             std::span<math::Vec3> out_share, const LightPath& path) const {
  CHECK(points.size() == out_share.size());
  RTCRay16 rays;
  for (std::size_t first = 0; first < points.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, points.size() - first);
    for (std::size_t i = 0; i < count; ++i)
      rays::set_lane(rays, i, points[first + i], direction, kSkyDistance);
    fill_lanes(rays, count);
    scenes_->compute_shares(make_first_lanes(count), rays, out_share.data() + first, path);
  }
}

void RayScene::find_nearest(std::span<const math::Vec3> points, std::span<const math::Vec3> directions,
                            float max_distance, std::span<RayHit> out_hits) const {
  CHECK(points.size() == directions.size() && points.size() == out_hits.size());
  RTCRayHit16 rays;
  TieContext context;
  rays::Embree::init_context(context.embree);
  for (std::size_t first = 0; first < points.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, points.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      rays::set_lane(rays.ray, i, points[first + i], directions[first + i], max_distance);
      rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    context.distance.fill(-1);
    fill_lanes(rays.ray, count);
    const LaneMask mask = make_first_lanes(count);
    scenes_->embree.intersect16(mask.lane.data(), scenes_->opaque.get(), context.embree, rays);
    for (std::size_t i = 0; i < count; ++i) {
      const bool hit = rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
      out_hits[first + i] = {rays.ray.tfar[i],
                             hit ? scenes_->opaque_triangles[rays.hit.primID[i]].surface : RayHit::kNone};
    }
  }
}

}  // namespace temblor::compiler
