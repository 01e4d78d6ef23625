// Feeds arbitrary bytes to the MDL reader. It must return an error, or a model that is written and read back
// unchanged.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/models/mdl.h"
#include "fuzz/targets.h"

using namespace temblor;

int temblor::fuzz::fuzz_mdl(const std::uint8_t* data, std::size_t size) {
  const auto mdl = formats::read_mdl(std::as_bytes(std::span(data, size)));
  if (!mdl.ok()) return 0;
  const base::ByteVector written = formats::write_mdl(*mdl);
  CHECK(written.size() <= size, "{} bytes of {}", written.size(), size);
  const auto back = formats::read_mdl(written);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(*back == *mdl);
  return 0;
}
