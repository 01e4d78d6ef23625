// A true-colour picture as a texture of the game.
#pragma once

#include <string_view>

#include "base/result.h"
#include "formats/build_mips.h"
#include "formats/image.h"
#include "formats/wad_texture.h"

namespace temblor::compiler {

// Every pixel takes the nearest dull colour, without dithering, which would show on large texels; a
// full-bright one only where the pixel is exactly that colour and no dull one is. Pixels of which less than
// half is opaque become holes in a texture named {...; elsewhere opacity is not looked at. kUsage for sides
// that are no multiples of 16, on which the engines' light maps rest.
base::Result<formats::WadTexture> texture_from_image(std::string_view name, const formats::Image& image,
                                                     const formats::MipColours& colours);

}  // namespace temblor::compiler
