// The triangles that light meets, and queries about them for many rays at a time, answered by Embree.
//
// Answers do not depend on the order of the rays or on threads: whether a ray hits something does not depend
// on which hit is found first, and triangles that share vertices leave no gaps (Embree's robust mode). Of
// hits at the same distance, the one with the lowest surface number counts.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::compiler {

// A triangle that stops light, or some of it.
struct OccluderTriangle {
  std::array<std::uint32_t, 3> corners{};  // into Occluders::vertices
  std::uint32_t surface = 0;               // the number reported for a hit
};

// The models on whose faces a shadow falls.
enum class ShadowReceivers : std::uint8_t { kAll, kOwnModel, kWorld };

// A surface that lets some light through, because of transparent texels or of _light_alpha, or that stops it
// for some receivers or lights only.
struct AlphaMask {
  math::Vec3 normal{0.0f};
  math::Vec3 s_axis{0.0f}, t_axis{0.0f};
  float s_offset = 0, t_offset = 0;
  std::uint32_t width = 1, height = 1;
  std::span<const std::uint8_t> texels;  // width x height; outlives the scene
  math::Vec3 transmission{0.0f};         // the share of light that passes, from the front; 1 from the back
  // By palette index; replaces `transmission`. Empty: the same everywhere.
  std::vector<math::Vec3> transmission_by_texel;
  std::uint32_t model = 0;  // that the surface belongs to
  ShadowReceivers receivers = ShadowReceivers::kAll;
  std::uint32_t channels = 1;  // bits: stops lights with one of these shadow channels
  // Not 0: the style that brings the light back while the game switches the shadow off.
  std::uint8_t switch_style = 0;
};

// The light that a query is about, and the face that it comes to.
struct LightPath {
  std::uint32_t receiver_model = 0;  // of the face that the points are on
  std::uint32_t shadow_channels = 1;
  // Switchable shadows: none stop the light; all do; or only light that one style brings back counts.
  enum class Switched : std::uint8_t { kPass, kStop, kOnly } switched = Switched::kPass;
  std::uint8_t only_style = 0;            // for kOnly
  std::optional<std::uint32_t> sky_name;  // light comes only from skies with this entry in sky_names
};

// Everything that stops light.
struct Occluders {
  std::vector<math::Vec3> vertices;
  std::vector<OccluderTriangle> opaque;
  std::vector<OccluderTriangle> masked;  // surface: index into alpha_masks
  std::vector<OccluderTriangle> skies;   // surface: index into sky_normals
  std::vector<AlphaMask> alpha_masks;
  std::vector<math::Vec3> sky_normals;
  std::vector<std::uint32_t> sky_names;  // as many: the number of its texture
};

// Where a ray ends.
struct RayHit {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  float distance = 0;             // max_distance if nothing was hit
  std::uint32_t surface = kNone;  // of the opaque triangle
};

// Never changes; any number of threads may query it. Points are world positions in open space.
class RayScene {
 public:
  // Fails with kUnsupported if Embree is missing or does not run, and with kTooLarge if it runs out of
  // memory.
  static base::Result<RayScene> make(Occluders occluders);
  // Fails with kUnsupported if no scene can be made on this machine.
  static base::Status check();
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  // Finds the share of light, 0 to 1 for each channel, that comes from `source_world` to each point. `points`
  // and `out_share` have the same size.
  void trace_to_point(std::span<const math::Vec3> points, const math::Vec3& source_world,
                      std::span<math::Vec3> out_share, const LightPath& path = {}) const;
  // The same along `direction` (a unit vector away from the points), which must end on sky.
  void trace_to_sky(std::span<const math::Vec3> points, const math::Vec3& direction,
                    std::span<math::Vec3> out_share, const LightPath& path = {}) const;
  // The same from points inside a brush of sky, whose faces toward the void do not exist: rays that meet
  // nothing count as reaching the sky.
  void trace_to_void(std::span<const math::Vec3> points, const math::Vec3& direction,
                     std::span<math::Vec3> out_share, const LightPath& path = {}) const;
  // Finds the first opaque surface along each of `directions` (unit vectors), up to max_distance.
  void find_nearest(std::span<const math::Vec3> points, std::span<const math::Vec3> directions,
                    float max_distance, std::span<RayHit> out_hits) const;

  bool has_sky() const;
  // The styles of switchable shadows, in ascending order.
  std::span<const std::uint8_t> switch_styles() const;

 private:
  struct Scenes;
  explicit RayScene(std::unique_ptr<Scenes> scenes);
  std::unique_ptr<Scenes> scenes_;
};

}  // namespace temblor::compiler
