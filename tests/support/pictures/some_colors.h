// Colors for tests that work with any colors.
#pragma once

#include <cstdint>

#include "formats/images/palette.h"
#include "render/color/color_tables.h"

namespace temblor::test {

formats::Palette random_palette(std::uint64_t seed);

// A random palette, with a colormap of zeros; the same in every call.
const render::ColorTables& some_tables();

}  // namespace temblor::test
