// Feeds arbitrary bytes to the WAD reader. It must return an error, or lumps that are written and read back
// unchanged. Every lump is also read as a texture, with and without the palette of a WAD3, and must pass the
// same test.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/archives/wad.h"
#include "formats/images/wad3_texture.h"
#include "formats/images/wad_texture.h"
#include "fuzz/targets.h"

using namespace temblor;

namespace {

void check_texture(base::Bytes lump) {
  const auto texture = formats::read_wad_texture(lump);
  if (!texture.ok()) return;
  const auto written = formats::write_wad_texture(*texture);
  CHECK(written.ok(), "{}", written.error().message());
  const auto back = formats::read_wad_texture(*written);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(*back == *texture);
}

void check_wad3_texture(base::Bytes lump) {
  const auto texture = formats::read_wad3_texture(lump);
  if (!texture.ok()) return;
  const auto written = formats::write_wad3_texture(*texture);
  CHECK(written.ok(), "{}", written.error().message());
  const auto back = formats::read_wad3_texture(*written);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(back->texture == texture->texture);
}

}  // namespace

int temblor::fuzz::fuzz_wad(const std::uint8_t* data, std::size_t size) {
  const auto lumps = formats::read_wad(std::as_bytes(std::span(data, size)));
  if (!lumps.ok()) return 0;
  const auto written = formats::write_wad(*lumps);
  CHECK(written.ok(), "{}", written.error().message());
  const auto back = formats::read_wad(*written);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(std::ranges::equal(*back, *lumps, [](const formats::WadLump& a, const formats::WadLump& b) {
    return a.name == b.name && a.type == b.type && std::ranges::equal(a.data, b.data);
  }));
  for (const formats::WadLump& lump : *lumps) {
    check_texture(lump.data);
    check_wad3_texture(lump.data);
  }
  return 0;
}
