#include "support/some_colours.h"

#include "support/random.h"

namespace temblor::test {

formats::Palette random_palette(std::uint64_t seed) {
  Random random(seed);
  formats::Palette palette;
  for (formats::Rgb& colour : palette)
    colour = {static_cast<std::uint8_t>(random.bits()), static_cast<std::uint8_t>(random.bits()),
              static_cast<std::uint8_t>(random.bits())};
  return palette;
}

const render::ColourTables& some_tables() {
  static const render::ColourTables tables = render::make_colour_tables(random_palette(1), {});
  return tables;
}

}  // namespace temblor::test
