#include "compiler/light/light_hash.h"

#include "base/hash.h"
#include "formats/palette.h"

namespace temblor::compiler {
namespace {

std::uint64_t with_bytes(std::uint64_t hash, base::Bytes bytes) {
  return base::hash_with_bytes(base::hash_with(hash, bytes.size()), bytes);
}

std::uint64_t with_keys(std::uint64_t hash, const SurfaceKeys& keys) {
  visit_fields(keys,
               [&](auto field) { hash = base::hash_with(hash, base::bits_of(static_cast<float>(field))); });
  return hash;
}

}  // namespace

formats::Bsp unlit(const formats::Bsp& bsp) {
  formats::Bsp copy = bsp;
  copy.lighting.clear();
  copy.bspx.clear();
  for (formats::BspFace& face : copy.faces) {
    face.styles = {255, 255, 255, 255};
    face.light_offset = -1;
  }
  return copy;
}

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
