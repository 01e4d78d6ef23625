#include "platform/sdl2/x11_display.h"

#include <xcb/present.h>

namespace temblor::platform::sdl2 {
namespace {

const xcb_visualtype_t* find_visual(const xcb_setup_t& setup, xcb_visualid_t id) {
  for (auto screen = xcb_setup_roots_iterator(&setup); screen.rem > 0; xcb_screen_next(&screen))
    for (auto depth = xcb_screen_allowed_depths_iterator(screen.data); depth.rem > 0; xcb_depth_next(&depth))
      for (auto visual = xcb_depth_visuals_iterator(depth.data); visual.rem > 0; xcb_visualtype_next(&visual))
        if (visual.data->visual_id == id) return visual.data;
  return nullptr;
}

// Pixels of Picture: 32 bits, with red in the upper byte.
bool has_picture_pixels(const xcb_setup_t& setup, xcb_visualid_t visual_id, std::uint8_t depth) {
  const xcb_visualtype_t* const visual = find_visual(setup, visual_id);
  if (visual == nullptr || visual->red_mask != 0xff0000 || visual->green_mask != 0xff00 ||
      visual->blue_mask != 0xff || setup.image_byte_order != XCB_IMAGE_ORDER_LSB_FIRST)
    return false;
  for (auto format = xcb_setup_pixmap_formats_iterator(&setup); format.rem > 0; xcb_format_next(&format))
    if (format.data->depth == depth) return format.data->bits_per_pixel == 32;
  return false;
}

// Finds the extensions. False if one is missing.
bool find_extensions(X11Display& io_display) {
  xcb_connection_t* const connection = io_display.connection.get();
  xcb_prefetch_extension_data(connection, &xcb_present_id);
  xcb_prefetch_extension_data(connection, &xcb_shm_id);
  const xcb_query_extension_reply_t* const present = xcb_get_extension_data(connection, &xcb_present_id);
  const xcb_query_extension_reply_t* const memory = xcb_get_extension_data(connection, &xcb_shm_id);
  if (present == nullptr || !present->present || memory == nullptr || !memory->present) return false;
  io_display.present_opcode = present->major_opcode;
  const auto present_asked = xcb_present_query_version(connection, 1, 0);
  const auto memory_asked = xcb_shm_query_version(connection);
  const Reply<xcb_present_query_version_reply_t> present_version(
      xcb_present_query_version_reply(connection, present_asked, nullptr));
  const Reply<xcb_shm_query_version_reply_t> memory_version(
      xcb_shm_query_version_reply(connection, memory_asked, nullptr));
  if (!present_version || !memory_version) return false;
  io_display.has_shared_pixmaps =
      memory_version->shared_pixmaps != 0 && memory_version->pixmap_format == XCB_IMAGE_FORMAT_Z_PIXMAP;
  // Since 1.2, the server takes memory by a file descriptor.
  return memory_version->major_version > 1 || memory_version->minor_version >= 2;
}

}  // namespace

std::optional<X11Display> connect_to_x11(xcb_window_t window) {
  X11Display display;
  display.connection.reset(xcb_connect(nullptr, nullptr));
  display.window = window;
  xcb_connection_t* const connection = display.connection.get();
  if (xcb_connection_has_error(connection) != 0 || !find_extensions(display)) return std::nullopt;
  const auto attributes_asked = xcb_get_window_attributes(connection, window);
  const auto geometry_asked = xcb_get_geometry(connection, window);
  const Reply<xcb_get_window_attributes_reply_t> attributes(
      xcb_get_window_attributes_reply(connection, attributes_asked, nullptr));
  const Reply<xcb_get_geometry_reply_t> geometry(xcb_get_geometry_reply(connection, geometry_asked, nullptr));
  if (!attributes || !geometry) return std::nullopt;
  display.depth = geometry->depth;
  if (!has_picture_pixels(*xcb_get_setup(connection), attributes->visual, display.depth)) return std::nullopt;
  display.graphics_context = xcb_generate_id(connection);
  xcb_create_gc(connection, display.graphics_context, window, 0, nullptr);
  return display;
}

}  // namespace temblor::platform::sdl2
