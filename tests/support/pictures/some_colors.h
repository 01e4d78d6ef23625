// Colors for tests to which any will do.
#pragma once

#include <cstdint>

#include "formats/images/palette.h"
#include "render/color/color_tables.h"

namespace temblor::test {

formats::Palette random_palette(std::uint64_t seed);

// Of a random palette, with a colormap of zeros; the same in every call.
const render::ColorTables& some_tables();

}  // namespace temblor::test
