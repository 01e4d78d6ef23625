#include "compiler/light/light_hash.h"

#include <algorithm>

#include "base/hash.h"
#include "formats/palette.h"

namespace temblor::compiler {
namespace {

std::uint64_t with_bytes(std::uint64_t hash, base::Bytes bytes) {
  hash = base::hash_with(hash, bytes.size());
  base::ByteReader reader(bytes);
  while (reader.remaining() >= sizeof(std::uint64_t))
    hash = base::hash_with(hash, reader.read<std::uint64_t>());
  while (reader.remaining() > 0) hash = base::hash_with(hash, reader.u8());
  return hash;
}

std::uint64_t with_vector(std::uint64_t hash, const math::Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) hash = base::hash_with(hash, base::bits_of(vector[axis]));
  return hash;
}

std::uint64_t with_keys(std::uint64_t hash, const SurfaceKeys& keys) {
  for (const float number :
       {keys.phong_angle_deg, keys.phong_angle_concave_deg, keys.min_light, keys.min_light_colour[0],
        keys.min_light_colour[1], keys.min_light_colour[2], keys.light_map_scale, keys.light_alpha})
    hash = base::hash_with(hash, base::bits_of(number));
  for (const std::int32_t number : {keys.phong_group, static_cast<std::int32_t>(keys.shadow_receivers),
                                    static_cast<std::int32_t>(keys.auto_min_light)})
    hash = base::hash_with(hash, static_cast<std::uint32_t>(number));
  for (const bool flag : {keys.casts_shadow, keys.takes_dirt, keys.takes_bounce, keys.ignores_light})
    hash = base::hash_with(hash, flag ? 1 : 0);
  return hash;
}

std::uint64_t hash_of_level(const formats::Bsp& bsp, const FaceKeys& face_keys) {
  // What does not fit the widest version is no level that could be written, whatever its light.
  const auto bytes = formats::write_bsp(bsp, formats::BspVersion::kBsp2);
  if (!bytes.ok()) return 0;
  std::uint64_t hash = with_bytes(0, *bytes);
  for (const SurfaceKeys& keys : face_keys.keys) hash = with_keys(hash, keys);
  for (const std::uint32_t key : face_keys.of_face) hash = base::hash_with(hash, key);
  return hash;
}

}  // namespace

std::uint64_t hash_of_bytes(base::Bytes bytes) {
  return with_bytes(0, bytes);
}

std::uint64_t hash_of_geometry(formats::Bsp unlit, const LitLevel& lit, const LightOptions& options) {
  unlit.entities.clear();
  std::uint64_t hash = hash_of_level(unlit, lit.keys);
  if (hash == 0) return 0;
  if (options.palette) hash = with_bytes(hash, formats::write_palette(*options.palette));
  for (const math::Vec3& offset : lit.offset_of_model) hash = with_vector(hash, offset);
  return std::max<std::uint64_t>(1, base::hash_with(hash, static_cast<std::uint32_t>(options.extra)));
}

std::uint64_t hash_of_dirt(const DirtSettings& settings) {
  std::uint64_t hash = settings.on ? 1 : 0;
  for (const float number : {settings.depth, settings.scale, settings.gain, settings.angle_deg})
    hash = base::hash_with(hash, base::bits_of(number));
  return hash;
}

std::uint64_t hash_of_sky(std::span<const SkyBeam> beams, float range) {
  std::uint64_t hash = base::bits_of(range);
  for (const SkyBeam& beam : beams) {
    hash = with_vector(with_vector(hash, beam.towards_sky), beam.colour);
    for (const float number : {beam.value, beam.angle_scale})
      hash = base::hash_with(hash, base::bits_of(number));
    hash = base::hash_with(hash, beam.style);
    hash = base::hash_with(hash, beam.takes_dirt ? 1 : 0);
  }
  return hash;
}

std::uint64_t hash_of_light_input(const formats::Bsp& unlit, const FaceKeys& face_keys,
                                  const LightOptions& options) {
  std::uint64_t hash = hash_of_level(unlit, face_keys);
  for (const int number : {options.extra, options.fast ? 1 : 0, options.bounces.value_or(-1),
                           options.dirt ? (*options.dirt ? 1 : 0) : -1, options.sky_rays})
    hash = base::hash_with(hash, static_cast<std::uint32_t>(number));
  if (options.palette) hash = with_bytes(hash, formats::write_palette(*options.palette));
  return hash;
}

}  // namespace temblor::compiler
