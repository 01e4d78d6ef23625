// A connection of our own to the X server, for pictures in shared memory.
//
//   memory of this process and the server --> pixmap --Present extension--> window of SDL
//
// SDL reads the events of its own connection, so it never sees those of the Present extension.
#pragma once

#include <xcb/shm.h>
#include <xcb/xcb.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>

namespace temblor::platform::sdl2 {

struct FreeReply {
  void operator()(void* reply) const { std::free(reply); }
};
// An event, a reply, or an error of the X server.
template <typename T>
using Reply = std::unique_ptr<T, FreeReply>;

struct Disconnect {
  void operator()(xcb_connection_t* connection) const { xcb_disconnect(connection); }
};

struct X11Display {
  std::unique_ptr<xcb_connection_t, Disconnect> connection;
  xcb_window_t window = 0;
  xcb_gcontext_t graphics_context = 0;  // for pixmaps of the window's depth
  std::uint8_t depth = 0;               // bits of a pixel's color
  // The server can make pixmaps of shared memory. Other servers copy the memory into a pixmap.
  bool has_shared_pixmaps = false;
  std::uint8_t present_opcode = 0;  // of the events of the Present extension
};

// Connects to the display of SDL's X11 window. Returns nothing if the server cannot show pictures in this
// way: it is on another machine, lacks an extension (Present, or MIT-SHM 1.2), or the window's pixels are not
// 0xRRGGBB in 32 bits.
std::optional<X11Display> connect_to_x11(xcb_window_t window);

}  // namespace temblor::platform::sdl2
