// Pictures for people to look at, written only if the environment variable TEMBLOR_PICTURES names a folder.
#pragma once

#include <string>

#include "formats/images/palette.h"
#include "render/frame_buffer.h"

namespace temblor::test {

// Writes NAME.ppm in that folder; does nothing if it is not set. CHECKs that it can be written.
void show_picture(const std::string& name, const render::FrameBuffer& frame, const formats::Palette& palette);

}  // namespace temblor::test
