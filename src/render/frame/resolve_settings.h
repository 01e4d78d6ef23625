// Corrects a frame's settings once, before the frame, so that no stage has to check them.
#pragma once

#include "render/frame_buffer.h"
#include "render/scene.h"
#include "render/settings.h"

namespace temblor::render {

// The result has at least one thread, an existing mip level, a number of rows per band (chosen from the
// frame's size where `asked` leaves it open), and a depth buffer wherever fog or the depth view reads it.
Settings resolve_settings(const Settings& asked, const Scene& scene, const FrameBuffer& frame);

}  // namespace temblor::render
