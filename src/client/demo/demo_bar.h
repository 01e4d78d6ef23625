// What somebody who watches a recording wants to know of it, above the status bar.
#pragma once

#include "assets/pictures.h"
#include "client/demo/demo_session.h"
#include "render/draw_list.h"

namespace temblor::client {

// A bar for the recording's length, filled up to the moment that is shown, and above it that moment, the
// length, and how it is played. Appended to `io_list`, for a frame of that size; valid while the pictures
// live. `scale`: see choose_scale().
void draw_demo_bar(const DemoSession& session, const assets::Pictures& pictures, int width, int height,
                   int scale, render::DrawList& io_list);

// Where of the recording the bar is that many pixels from the frame's left, for who clicks there.
double demo_time_at(const DemoSession& session, int x_px, int width, int height, int scale);

}  // namespace temblor::client
