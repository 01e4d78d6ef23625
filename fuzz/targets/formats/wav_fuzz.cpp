// Feeds arbitrary bytes to the WAV reader. It must return an error, or a sound that is written and read back
// unchanged and whose loop lies inside it.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/sounds/wav.h"
#include "fuzz/targets.h"

using namespace temblor;

int temblor::fuzz::fuzz_wav(const std::uint8_t* data, std::size_t size) {
  const auto wav = formats::read_wav(std::as_bytes(std::span(data, size)));
  if (!wav.ok()) return 0;
  if (wav->loop) CHECK(wav->loop->start < wav->loop->end && wav->loop->end <= wav->frame_count());
  const auto back = formats::read_wav(formats::write_wav(*wav));
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(*back == *wav);
  return 0;
}
