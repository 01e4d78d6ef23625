// A true-color picture as a texture of the game.
#pragma once

#include <string_view>

#include "base/result.h"
#include "formats/images/build_mips.h"
#include "formats/images/image.h"
#include "formats/images/wad_texture.h"

namespace temblor::compiler {

// Every pixel takes the nearest dull color, without dithering, which would show on large texels; a
// full-bright one only where the pixel is exactly that color and no dull one is. Pixels of which less than
// half is opaque become holes in a texture named {...; elsewhere opacity is not looked at. kUsage for sides
// that are no multiples of 16, on which the engines' light maps rest.
base::Result<formats::WadTexture> texture_from_image(std::string_view name, const formats::Image& image,
                                                     const formats::MipColors& colors);

}  // namespace temblor::compiler
