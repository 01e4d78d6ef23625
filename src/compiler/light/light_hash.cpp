#include "compiler/light/light_hash.h"

#include "base/hash.h"
#include "formats/palette.h"

namespace temblor::compiler {
namespace {

std::uint64_t with_bytes(std::uint64_t hash, base::Bytes bytes) {
  hash = base::hash_with(hash, bytes.size());
  for (const std::byte byte : bytes) hash = base::hash_with(hash, std::to_integer<std::uint64_t>(byte));
  return hash;
}

std::uint64_t with_keys(std::uint64_t hash, const SurfaceKeys& keys) {
  for (const float number :
       {keys.phong_angle_deg, keys.phong_angle_concave_deg, keys.min_light, keys.min_light_colour[0],
        keys.min_light_colour[1], keys.min_light_colour[2], keys.light_map_scale, keys.light_alpha})
    hash = base::hash_with(hash, base::bits_of(number));
  hash = base::hash_with(hash, static_cast<std::uint32_t>(keys.phong_group));
  for (const bool flag : {keys.casts_shadow, keys.takes_dirt, keys.takes_bounce, keys.ignores_light})
    hash = base::hash_with(hash, flag ? 1 : 0);
  return hash;
}

}  // namespace

std::uint64_t hash_of_light_input(const formats::Bsp& unlit, const FaceKeys& face_keys,
                                  const LightOptions& options) {
  std::uint64_t hash = 0;
  // What does not fit the widest version is no level that could be written, whatever its light.
  if (const auto bytes = formats::write_bsp(unlit, formats::BspVersion::kBsp2); bytes.ok())
    hash = with_bytes(hash, *bytes);
  for (const SurfaceKeys& keys : face_keys.keys) hash = with_keys(hash, keys);
  for (const std::uint32_t key : face_keys.of_face) hash = base::hash_with(hash, key);
  for (const int number : {options.extra, options.fast ? 1 : 0, options.bounces.value_or(-1),
                           options.dirt ? (*options.dirt ? 1 : 0) : -1, options.sky_rays})
    hash = base::hash_with(hash, static_cast<std::uint32_t>(number));
  if (options.palette) hash = with_bytes(hash, formats::write_palette(*options.palette));
  return hash;
}

}  // namespace temblor::compiler
