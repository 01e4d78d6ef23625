// Feeds arbitrary bytes to the reader of LMP pictures. It must return an error, or a picture that is written
// and read back unchanged.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/images/picture.h"
#include "fuzz/targets.h"

using namespace temblor;

int temblor::fuzz::fuzz_picture(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  if (const auto conchars = formats::read_conchars(bytes); conchars.ok())
    CHECK(conchars->pixels.size() == 128 * 128 && size >= conchars->pixels.size());
  const auto picture = formats::read_picture(bytes);
  if (!picture.ok()) return 0;
  const auto back = formats::read_picture(formats::write_picture(*picture));
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(*back == *picture);
  return 0;
}
