// Any bytes: an error, or a sound level that reads back equal from what is written of it.
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
  // Its own version holds it as it is, and BSP2 holds whatever the others do.
  for (const BspVersion version : {bsp->version, BspVersion::kBsp2}) {
    const auto written = temblor::formats::write_bsp(*bsp, version);
    CHECK(written.ok(), "{}", written.error().message());
    const auto back = temblor::formats::read_bsp(*written);
    CHECK(back.ok(), "{}", back.error().message());
    auto expected = *bsp;
    expected.version = version;
    CHECK(*back == expected, "as {}", temblor::formats::name_of(version));
  }
  return 0;
}
