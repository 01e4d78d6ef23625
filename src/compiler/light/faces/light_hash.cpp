#include "compiler/light/faces/light_hash.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/hash.h"
#include "formats/images/palette.h"

namespace temblor::compiler {
namespace {

// The BSPX lumps that hold light, or how it lies on faces, whoever wrote them.
constexpr std::array<std::string_view, 9> kLightLumps = {"RGBLIGHTING", "LIGHTINGDIR",  "LIGHTING_E5BGR9",
                                                         "LMSHIFT",     "LMOFFSET",     "LMSTYLE",
                                                         "LMSTYLE16",   "DECOUPLED_LM", "LIGHTGRID_OCTREE"};

std::uint64_t with_bytes(std::uint64_t hash, base::Bytes bytes) {
  return base::hash_with_bytes(base::hash_with(hash, bytes.size()), bytes);
}

std::uint64_t with_vector(std::uint64_t hash, const math::Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) hash = base::hash_with(hash, base::bits_of(vector[axis]));
  return hash;
}

std::uint64_t with_keys(std::uint64_t hash, const SurfaceKeys& keys) {
  visit_fields(keys,
               [&](auto field) { hash = base::hash_with(hash, base::bits_of(static_cast<float>(field))); });
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

formats::Bsp unlit(const formats::Bsp& bsp) {
  formats::Bsp copy = bsp;
  copy.lighting.clear();
  std::erase_if(copy.bspx, [](const formats::BspxLump& lump) {
    return std::find(kLightLumps.begin(), kLightLumps.end(), lump.name) != kLightLumps.end();
  });
  for (formats::BspFace& face : copy.faces) {
    face.styles = {255, 255, 255, 255};
    face.light_offset = -1;
  }
  return copy;
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
    hash = with_vector(with_vector(hash, beam.towards_sky), beam.color);
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
