// The picture of `temblor lab run`: a technique's frame, the engine's, and their difference, side by side.
#pragma once

#include <string>

#include "base/result.h"
#include "formats/images/palette.h"
#include "render/frame_buffer.h"

namespace temblor::app {

// Writes a PNG file three frames wide. The difference is black where the frames are equal; elsewhere it is
// the difference of each channel, made four times as bright and at least dark gray. Both frames must have the
// same size and format.
base::Status write_lab_picture(const std::string& path, const render::FrameBuffer& technique,
                               const render::FrameBuffer& engine, const formats::Palette& palette);

}  // namespace temblor::app
