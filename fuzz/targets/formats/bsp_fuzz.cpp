// Feeds arbitrary bytes to the BSP reader. It must return an error, or a valid level that is written and
// read back unchanged.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/levels/bsp.h"
#include "fuzz/targets.h"

using temblor::formats::BspVersion;

int temblor::fuzz::fuzz_bsp(const std::uint8_t* data, std::size_t size) {
  const auto bsp = temblor::formats::read_bsp(std::as_bytes(std::span(data, size)));
  if (!bsp.ok()) return 0;
  // The level fits its own version, and BSP2 holds every level of the others.
  for (const BspVersion version : {bsp->version, BspVersion::kBsp2}) {
    const auto written = temblor::formats::write_bsp(*bsp, version);
    CHECK(written.ok(), "{}", written.error().message());
    const auto back = temblor::formats::read_bsp(*written);
    CHECK(back.ok(), "{}", back.error().message());
    auto expected = *bsp;
    expected.version = version;
    expected.repairs.clear();
    if (version != BspVersion::k30)
      for (auto& texture : expected.miptexes) texture.palette.clear();
    CHECK(*back == expected, "as {}", temblor::formats::version_name(version));
  }
  return 0;
}
