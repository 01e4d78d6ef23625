// What light meets on its way: the level's triangles, asked through Embree by many rays at a time.
//
// Answers are the same for any order and number of threads: whether something is hit does not depend on the
// order in which it is found, and triangles that share vertices leave no gap (Embree's robust mode). Of hits
// at the same distance that of the lowest surface counts.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::compiler {

struct OccluderTriangle {
  std::array<std::uint32_t, 3> corners{};  // into Occluders::vertices
  std::uint32_t surface = 0;               // what a hit is reported as
};

// On the faces of which models a shadow falls.
enum class ShadowReceivers : std::uint8_t { kAll, kOwnModel, kWorld };

// Lets some of the light through, or stops it for some receivers only.
struct AlphaMask {
  math::Vec3 normal{0.0f};
  math::Vec3 s_axis{0.0f}, t_axis{0.0f};
  float s_offset = 0, t_offset = 0;
  std::uint32_t width = 1, height = 1;
  std::span<const std::uint8_t> texels;     // width x height; outlives the scene
  math::Vec3 passes{0.0f};                  // the share; counted where light comes in from the front
  std::vector<math::Vec3> passes_by_texel;  // instead, by palette index; empty: the same everywhere
  std::uint32_t model = 0;
  ShadowReceivers receivers = ShadowReceivers::kAll;
};

struct Occluders {
  std::vector<math::Vec3> vertices;
  std::vector<OccluderTriangle> opaque;
  std::vector<OccluderTriangle> sieves;  // surface: into sieve_surfaces
  std::vector<OccluderTriangle> skies;   // surface: into sky_normals
  std::vector<AlphaMask> sieve_surfaces;
  std::vector<math::Vec3> sky_normals;
};

struct RayHit {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  float distance = 0;             // max_distance when nothing was hit
  std::uint32_t surface = kNone;  // of an opaque triangle
};

// Immutable; all questions may be asked by many threads at once. Points are world positions in open space.
class RayScene {
 public:
  static base::Result<RayScene> make(Occluders occluders);
  // kUnsupported where no scene can be made on this machine.
  static base::Status check();
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  // The share of light, 0 to 1 a channel, that comes from `source_world` to each point. Same sizes.
  // `receiver_model`: that of the face that the points lie on.
  void towards_point(std::span<const math::Vec3> points, const math::Vec3& source_world,
                     std::span<math::Vec3> out_share, std::uint32_t receiver_model = 0) const;
  // The same along `direction` (a unit vector away from the points), which has to end on sky.
  void towards_sky(std::span<const math::Vec3> points, const math::Vec3& direction,
                   std::span<math::Vec3> out_share, std::uint32_t receiver_model = 0) const;
  // The same from points inside a brush of sky, which has no faces towards the void outside the level: what
  // meets nothing at all arrives.
  void towards_void(std::span<const math::Vec3> points, const math::Vec3& direction,
                    std::span<math::Vec3> out_share, std::uint32_t receiver_model = 0) const;
  // What opaque surface lies first along each of `directions` (unit vectors), up to max_distance.
  void nearest(std::span<const math::Vec3> points, std::span<const math::Vec3> directions, float max_distance,
               std::span<RayHit> out_hits) const;

  bool has_sky() const;

 private:
  struct Scenes;
  explicit RayScene(std::unique_ptr<Scenes> scenes);
  std::unique_ptr<Scenes> scenes_;
};

}  // namespace temblor::compiler
