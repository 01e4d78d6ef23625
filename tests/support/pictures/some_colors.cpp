#include "support/pictures/some_colors.h"

#include "support/random.h"

namespace temblor::test {

formats::Palette random_palette(std::uint64_t seed) {
  Random random(seed);
  formats::Palette palette;
  for (formats::Rgb& color : palette)
    color = {static_cast<std::uint8_t>(random.bits()), static_cast<std::uint8_t>(random.bits()),
             static_cast<std::uint8_t>(random.bits())};
  return palette;
}

const render::ColorTables& some_tables() {
  static const render::ColorTables tables = render::make_color_tables(random_palette(1), {});
  return tables;
}

}  // namespace temblor::test
