#include "compiler/light/faces/light_hash.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/hash.h"
#include "formats/images/palette.h"

namespace temblor::compiler {
namespace {

// The BSPX lumps with light or about light, whichever compiler writes them.
constexpr std::array<std::string_view, 10> kLightLumps = {
    "RGBLIGHTING", "LIGHTINGDIR", "LIGHTING_E5BGR9", "LMSHIFT",          "LMOFFSET",
    "LMSTYLE",     "LMSTYLE16",   "DECOUPLED_LM",    "LIGHTGRID_OCTREE", "FACENORMALS"};

std::uint64_t with_bytes(std::uint64_t hash, base::Bytes bytes) {
  return base::hash_with_bytes(base::hash_with(hash, bytes.size()), bytes);
}

std::uint64_t with_vector(std::uint64_t hash, const math::Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) hash = base::hash_with(hash, base::float_bits(vector[axis]));
  return hash;
}

std::uint64_t with_keys(std::uint64_t hash, const SurfaceKeys& keys) {
  visit_fields(
      keys, [&](auto field) { hash = base::hash_with(hash, base::float_bits(static_cast<float>(field))); });
  return hash;
}

// Hashes the level as a file would have it. FaceKeys are not in the file, so they are added.
std::uint64_t hash_level(const formats::Bsp& bsp, const FaceKeys& face_keys) {
  // A level that does not fit even BSP2 cannot be written, whatever its light.
  const auto bytes = formats::write_bsp(bsp, formats::BspVersion::kBsp2);
  if (!bytes.ok()) return 0;
  std::uint64_t hash = with_bytes(0, *bytes);
  for (const SurfaceKeys& keys : face_keys.keys) hash = with_keys(hash, keys);
  for (const std::uint32_t key : face_keys.of_face) hash = base::hash_with(hash, key);
  return hash;
}

}  // namespace

formats::Bsp strip_light(const formats::Bsp& bsp) {
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

std::uint64_t hash_geometry(formats::Bsp unlit_bsp, const LitLevel& lit, const LightOptions& options) {
  unlit_bsp.entities.clear();
  std::uint64_t hash = hash_level(unlit_bsp, lit.keys);
  if (hash == 0) return 0;
  if (options.palette) hash = with_bytes(hash, formats::write_palette(*options.palette));
  for (const math::Vec3& offset : lit.offset_of_model) hash = with_vector(hash, offset);
  for (const std::uint8_t style : lit.switch_style_of_model) hash = base::hash_with(hash, style);
  for (const std::uint8_t style : lit.styles_of_keys.shadows) hash = base::hash_with(hash, style);
  return std::max<std::uint64_t>(1, base::hash_with(hash, static_cast<std::uint32_t>(options.extra)));
}

std::uint64_t hash_dirt(const DirtSettings& settings) {
  std::uint64_t hash = (settings.on ? 1 : 0) + (settings.is_random ? 2 : 0);
  for (const float number : {settings.depth, settings.scale, settings.gain, settings.angle_deg})
    hash = base::hash_with(hash, base::float_bits(number));
  return hash;
}

std::uint64_t hash_sky(std::span<const SkyBeam> beams, const LightSettings& settings) {
  std::uint64_t hash = base::hash_with(base::float_bits(settings.range), settings.has_directions ? 1 : 0);
  for (const SkyBeam& beam : beams) {
    hash = with_vector(with_vector(hash, beam.toward_sky), beam.color);
    for (const float number : {beam.value, beam.angle_scale})
      hash = base::hash_with(hash, base::float_bits(number));
    hash = base::hash_with(hash, beam.style);
    hash = base::hash_with(hash, beam.takes_dirt ? 1 : 0);
    hash = base::hash_with(hash, beam.sky_name ? std::uint64_t{*beam.sky_name} + 1 : 0);
  }
  return hash;
}

std::uint64_t hash_light_input(const formats::Bsp& unlit_bsp, const FaceKeys& face_keys,
                               const LightOptions& options) {
  std::uint64_t hash = hash_level(unlit_bsp, face_keys);
  for (const int number : {options.extra, options.fast ? 1 : 0, options.bounces.value_or(-1),
                           options.dirt ? (*options.dirt ? 1 : 0) : -1, options.sky_rays})
    hash = base::hash_with(hash, static_cast<std::uint32_t>(number));
  hash = base::hash_with(hash, static_cast<std::uint32_t>(options.luxel_texels.value_or(-1)));
  hash = base::hash_with(hash, base::float_bits(options.units_per_luxel.value_or(-1)));
  hash = base::hash_with(hash, static_cast<std::uint32_t>(options.soft));
  if (options.palette) hash = with_bytes(hash, formats::write_palette(*options.palette));
  if (options.grid_step) hash = with_vector(hash, *options.grid_step);
  if (options.hdr || options.face_normals || options.directions)
    hash = base::hash_with(
        hash, (options.hdr ? 1u : 0u) + (options.face_normals ? 2u : 0u) + (options.directions ? 4u : 0u));
  return hash;
}

}  // namespace temblor::compiler
