// Feeds arbitrary bytes to the readers of LMSHIFT, LMOFFSET, LMSTYLE, LMSTYLE16, DECOUPLED_LM, FACENORMALS,
// LIGHTING_E5BGR9, and LIGHTINGDIR. They must return an error, or values that read back equal after they are
// written.
//
// The first byte is the number of faces. Lumps follow: u8 number of the name, u8 size, data.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/bspx/face_normals.h"
#include "formats/bspx/hdr_light.h"
#include "formats/bspx/light_directions.h"
#include "formats/levels/decoupled_light.h"
#include "formats/levels/scaled_light.h"
#include "fuzz/targets.h"

namespace {

using namespace temblor;

formats::Bsp make_level(base::Bytes bytes) {
  constexpr std::array kNames = {"LMSHIFT",      "LMOFFSET",    "LMSTYLE",         "LMSTYLE16",
                                 "DECOUPLED_LM", "FACENORMALS", "LIGHTING_E5BGR9", "LIGHTINGDIR"};
  base::ByteReader reader(bytes);
  formats::Bsp bsp;
  bsp.faces.resize(reader.u8() % 8);
  bsp.lighting.resize(bsp.faces.size());
  for (std::size_t i = 0; i < bsp.faces.size(); ++i)
    bsp.faces[i].surfedge_count = static_cast<std::uint32_t>(i % 3);
  while (reader.remaining() > 0) {
    const char* name = kNames[reader.u8() % kNames.size()];
    const base::Bytes data = reader.take(std::min<std::size_t>(reader.u8(), reader.remaining()));
    bsp.bspx.push_back({name, base::ByteVector(data.begin(), data.end())});
  }
  return bsp;
}

}  // namespace

int temblor::fuzz::fuzz_light_lumps(const std::uint8_t* data, std::size_t size) {
  formats::Bsp bsp = make_level(std::as_bytes(std::span(data, size)));
  const auto styles = formats::read_face_styles(bsp);
  if (styles.ok()) CHECK(styles->size() == bsp.faces.size());
  // Writing LMSHIFT replaces the styles, so DECOUPLED_LM comes first.
  if (const auto maps = formats::read_decoupled_light(bsp); maps.ok() && !maps->empty()) {
    CHECK(maps->size() == bsp.faces.size());
    formats::set_decoupled_light(*maps, bsp);
    const auto back = formats::read_decoupled_light(bsp);
    CHECK(back.ok() && back->size() == maps->size());
    for (std::size_t i = 0; i < maps->size(); ++i)
      CHECK((*maps)[i].offset < 0 ? (*back)[i].offset == -1 : (*back)[i] == (*maps)[i]);
  }
  if (const auto maps = formats::read_scaled_light(bsp); maps.ok() && !maps->empty()) {
    CHECK(maps->size() == bsp.faces.size());
    formats::set_scaled_light(*maps, bsp);
    const auto back = formats::read_scaled_light(bsp);
    CHECK(back.ok() && *back == *maps);
  }
  if (const auto normals = formats::read_face_normals(bsp); normals.ok() && !normals->corners.empty()) {
    formats::set_face_normals(*normals, bsp);
    CHECK(formats::read_face_normals(bsp).ok());
  }
  if (const auto light = formats::read_hdr_light(bsp); light.ok() && !light->empty()) {
    for (const std::uint32_t sample : *light) {
      const math::Vec3 value = formats::unpack_e5bgr9(sample);
      CHECK(formats::unpack_e5bgr9(formats::pack_e5bgr9(value)) == value);
    }
    formats::set_hdr_light(*light, bsp);
    CHECK(*formats::read_hdr_light(bsp) == *light);
  }
  if (const auto directions = formats::read_light_directions(bsp); directions.ok() && !directions->empty()) {
    formats::set_light_directions(*directions, bsp);
    CHECK(*formats::read_light_directions(bsp) == *directions);
  }
  return 0;
}
