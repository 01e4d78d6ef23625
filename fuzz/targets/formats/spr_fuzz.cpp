// Feeds arbitrary bytes to the SPR reader. It must return an error, or a sprite that is written and read
// back unchanged and that has a picture for each frame at any time.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/models/group_time.h"
#include "formats/models/spr.h"
#include "fuzz/targets.h"

using namespace temblor;

int temblor::fuzz::fuzz_spr(const std::uint8_t* data, std::size_t size) {
  const auto spr = formats::read_spr(std::as_bytes(std::span(data, size)));
  if (!spr.ok()) return 0;
  const auto back = formats::read_spr(formats::write_spr(*spr));
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(*back == *spr);
  for (const formats::SprFrame& frame : spr->frames)
    for (const double time_s : {-1e-300, 0.0, 0.1, 12345.678, -1e18})
      CHECK(formats::find_group_member(frame.end_times_s, time_s) < frame.pictures.size());
  return 0;
}
