// OpenGL that draws into a window which only tests see: a context without a window, whose framebuffer 0 is a
// picture on the card.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "platform/headless/window.h"

namespace temblor::test {

// The pictures of such windows; outlives their contexts.
struct ShownByGl {
  std::vector<std::uint32_t> pixels;  // 0xffRRGGBB, from the top row on
  platform::PixelSize size;
  int pictures = 0;
  int contexts = 0;          // that exist now
  int opened = 0;            // contexts so far
  bool is_software = false;  // what the contexts say
  // How often a context still asks for errors until it lacks memory; negative: it never does.
  int calls_until_failure = -1;
};

// For HeadlessWindow::set_open_gl. Windows may have up to 1024 x 1024 pixels. Only one context exists per
// thread at a time. Both references must outlive the contexts.
platform::headless::HeadlessWindow::OpenGl make_window_gl(const platform::Window& window,
                                                          ShownByGl& io_shown);

}  // namespace temblor::test
