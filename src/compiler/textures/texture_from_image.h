// Converts a true-color image to a texture with the game's palette.
#pragma once

#include <string_view>

#include "base/result.h"
#include "formats/images/build_mips.h"
#include "formats/images/image.h"
#include "formats/images/wad_texture.h"

namespace temblor::compiler {

// Each pixel takes the nearest color that is not full-bright, without dithering, which would show on large
// texels. It takes a full-bright color only if it is exactly that color and no other color of the palette is.
// In a texture named {..., pixels that are less than half opaque become holes; otherwise opacity is ignored.
// Fails with kUsage if a side is not a multiple of 16, which light maps need.
base::Result<formats::WadTexture> texture_from_image(std::string_view name, const formats::Image& image,
                                                     const formats::MipColors& colors);

}  // namespace temblor::compiler
