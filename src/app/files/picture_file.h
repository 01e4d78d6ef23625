// Writes frames to PNG files, whose names may be numbered.
#pragma once

#include <cstddef>
#include <string>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/images/palette.h"
#include "render/frame_buffer.h"

namespace temblor::app {

// Returns the name of picture `number` of a sequence: "turn-%05d.png" and "turn-%d.png" get the number, a
// name without
// '%' stays. kUsage for a name that does not end in ".png" or has any other '%'.
base::Result<std::string> numbered_name(const std::string& pattern, std::size_t number);
bool is_numbered(const std::string& pattern);

// Writes the frame, an indexed one with its palette. Errors name the file and say what to do.
base::Status write_picture_file(const std::string& path, const render::FrameBuffer& frame,
                                const formats::Palette& palette);

}  // namespace temblor::app
