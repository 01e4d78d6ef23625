// A pixmap of the X server whose pixels this process writes.
#pragma once

#include <cstdint>
#include <utility>

#include "base/result.h"
#include "platform/sdl2/x11_display.h"
#include "platform/window.h"

namespace temblor::platform::sdl2 {

// Must not outlive the display.
class SharedPixmap {
 public:
  // Fails if the server refuses the memory.
  static base::Result<SharedPixmap> create(const X11Display& display, PixelSize size);
  SharedPixmap(SharedPixmap&& other) noexcept { swap(other); }
  SharedPixmap& operator=(SharedPixmap&& other) noexcept {
    swap(other);
    return *this;
  }
  ~SharedPixmap();

  PixelSize size() const { return size_; }
  xcb_pixmap_t pixmap() const { return pixmap_; }
  // Rows from top to bottom, without padding. The server may read them from update() until the pixmap is
  // idle.
  std::uint32_t* pixels() { return static_cast<std::uint32_t*>(memory_); }
  // Gives the written pixels to the pixmap.
  void update();

 private:
  SharedPixmap(const X11Display& display, PixelSize size) : display_(&display), size_(size) {}
  base::Status share_memory();
  void create_pixmap();
  std::size_t bytes() const;
  void swap(SharedPixmap& io_other);

  const X11Display* display_ = nullptr;
  PixelSize size_;
  void* memory_ = nullptr;
  xcb_shm_seg_t segment_ = 0;
  xcb_pixmap_t pixmap_ = 0;
};

}  // namespace temblor::platform::sdl2
