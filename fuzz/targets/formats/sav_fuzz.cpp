// Feeds arbitrary bytes to the reader of saved games. It must return an error, or a saved game that is
// written and read back unchanged.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/game/sav.h"
#include "fuzz/targets.h"

int temblor::fuzz::fuzz_sav(const std::uint8_t* data, std::size_t size) {
  using temblor::formats::read_sav;
  const auto sav = read_sav(temblor::base::as_text(std::as_bytes(std::span(data, size))));
  if (!sav.ok()) return 0;
  const auto text = temblor::formats::write_sav(*sav);
  if (!text.ok()) return 0;  // for example, a value with a line break
  const auto again = read_sav(*text);
  CHECK(again.ok());
  CHECK(again->entities == sav->entities && again->globals == sav->globals);
  return 0;
}
