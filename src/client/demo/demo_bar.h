// The progress bar of a demo, above the status bar.
#pragma once

#include "assets/pictures.h"
#include "client/demo/demo_session.h"
#include "client/hud/panel.h"
#include "render/draw_list.h"

namespace temblor::client {

// Draws a bar for the demo's length, filled up to the time that is shown. The text above it has that time,
// the length, and at the right "paused", "end", or a speed other than 1. Appends to `io_list` for a frame of
// `width` x `height` pixels; the commands are valid while the pictures live.
void draw_demo_bar(const DemoSession& session, const assets::Pictures& pictures, int width, int height,
                   HudSize size, render::DrawList& io_list);

// Draws the keys of the free camera at the top of the frame: without them a viewer may not find the way back.
void draw_free_camera_hint(const assets::Pictures& pictures, int width, int height, HudSize size,
                           render::DrawList& io_list);

// The demo time at a pixel column of the bar, for mouse clicks; columns beside the bar give its first or last
// time.
double find_demo_time(const DemoSession& session, int x_px, int width, int height, HudSize size);

}  // namespace temblor::client
