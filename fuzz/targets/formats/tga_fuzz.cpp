// Feeds arbitrary bytes to the TGA reader. It must return an error, or an image that is written and read
// back unchanged.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/images/image.h"
#include "fuzz/targets.h"

using namespace temblor;

int temblor::fuzz::fuzz_tga(const std::uint8_t* data, std::size_t size) {
  const auto image = formats::read_tga(std::as_bytes(std::span(data, size)));
  if (!image.ok()) return 0;
  const auto back = formats::read_tga(formats::write_tga(*image));
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(*back == *image);
  return 0;
}
