// A warning that the server of a network game has gone quiet: an icon after 0.3 s, like stock engines, and
// after 2 s also text with the time until the connection ends.
#pragma once

#include "assets/pictures.h"
#include "client/hud/panel.h"
#include "net/transport/client_endpoint.h"
#include "render/draw_list.h"

namespace temblor::client {

// Draws nothing if the silence is short. The icon is the picture "net" of gfx.wad; a game without it gets
// text only. Appends to `io_list` for a frame of `width` x `height` pixels; the
// commands are valid while the pictures live.
void draw_connection_warning(const assets::Pictures& pictures, const net::ServerSilence& silence,
                             HudSize size, int width, int height, render::DrawList& io_list);

}  // namespace temblor::client
