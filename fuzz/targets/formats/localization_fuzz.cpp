// Feeds arbitrary bytes to the reader of localized texts. It must return an error, or texts that stay within
// their limits, do not refer to each other, and can be filled with arguments.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/game/localization.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_localization(const std::uint8_t* data, std::size_t size) {
  using namespace temblor::formats;
  const auto read = read_localization(temblor::base::as_text(std::as_bytes(std::span(data, size))));
  if (!read.ok()) return 0;
  CHECK(read->problems.size() <= read->problem_count);
  const std::vector<std::string> arguments = {"{1}", "", std::string(100, 'x')};
  for (const auto& [key, text] : read->localization.texts()) {
    CHECK(text.size() <= kMaxLocalizedBytes);
    for (const char c : text) CHECK(static_cast<unsigned char>(c) < 128);
    CHECK(read->localization.localize("$" + key) == text);
    CHECK(fill_places(text, arguments).size() <= kMaxLocalizedBytes);
    const std::string joined = read->localization.localize_joined("$" + key + "$" + key + " x\n");
    CHECK(joined.size() <= 2 * kMaxLocalizedBytes + key.size() + 4);
  }
  return 0;
}
