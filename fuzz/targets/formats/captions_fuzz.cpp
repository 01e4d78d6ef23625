// Feeds arbitrary text to the reader of captions. Captions must be short and printable, and the lines that a
// writer makes of them must be read as the same captions.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/game/captions.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_captions(const std::uint8_t* data, std::size_t size) {
  using namespace temblor::formats;
  const Captions captions = read_captions(base::as_text(std::as_bytes(std::span(data, size))));
  CHECK(captions.texts.size() <= std::min(kMaxCaptions, size / 3 + 1));
  CHECK(captions.bad_lines.size() <= 20);
  std::string lines;
  for (const auto& [sound, caption] : captions.texts) {
    CHECK(!sound.empty() && caption.size() <= kMaxCaptionChars);
    CHECK(std::ranges::all_of(caption, [](char c) { return c >= ' ' && c <= '~'; }));
    lines += format_caption_line(sound, caption);
  }
  const Captions again = read_captions(lines);
  CHECK(again.texts == captions.texts && again.bad_lines.empty());
  return 0;
}
