#include "platform/sdl2/shared_pixmap.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace temblor::platform::sdl2 {

base::Result<SharedPixmap> SharedPixmap::create(const X11Display& display, PixelSize size) {
  SharedPixmap pixmap(display, size);
  TRY_STATUS(pixmap.share_memory());
  pixmap.create_pixmap();
  return pixmap;
}

SharedPixmap::~SharedPixmap() {
  if (pixmap_ != 0) xcb_free_pixmap(display_->connection.get(), pixmap_);
  if (segment_ != 0) xcb_shm_detach(display_->connection.get(), segment_);
  if (memory_ != nullptr) munmap(memory_, bytes());
}

std::size_t SharedPixmap::bytes() const {
  return static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height) *
         sizeof(std::uint32_t);
}

// Memory without a name disappears with its last user, even after a crash.
base::Status SharedPixmap::share_memory() {
  const auto fail = [] {
    return base::error(base::ErrorCode::kIo, "shared memory for the window: {}", std::strerror(errno));
  };
  const int file = memfd_create("picture", MFD_CLOEXEC);
  if (file < 0) return fail();
  if (ftruncate(file, static_cast<off_t>(bytes())) != 0) {
    const base::Error error = fail();
    close(file);
    return error;
  }
  void* const memory = mmap(nullptr, bytes(), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (memory == MAP_FAILED) {
    const base::Error error = fail();
    close(file);
    return error;
  }
  memory_ = memory;
  xcb_connection_t* const connection = display_->connection.get();
  const xcb_shm_seg_t segment = xcb_generate_id(connection);
  // Sends the file descriptor and closes it.
  const auto asked = xcb_shm_attach_fd_checked(connection, segment, file, /*read_only=*/0);
  if (const Reply<xcb_generic_error_t> refused(xcb_request_check(connection, asked)); refused)
    return base::error(base::ErrorCode::kIo, "the display refuses shared memory: X error {}",
                       refused->error_code);
  if (xcb_connection_has_error(connection) != 0)
    return base::error(base::ErrorCode::kIo, "the display cannot share memory");
  segment_ = segment;
  return base::Ok{};
}

void SharedPixmap::create_pixmap() {
  xcb_connection_t* const connection = display_->connection.get();
  const auto width = static_cast<std::uint16_t>(size_.width);
  const auto height = static_cast<std::uint16_t>(size_.height);
  pixmap_ = xcb_generate_id(connection);
  if (display_->has_shared_pixmaps)
    xcb_shm_create_pixmap(connection, pixmap_, display_->window, width, height, display_->depth, segment_, 0);
  else
    xcb_create_pixmap(connection, display_->depth, pixmap_, display_->window, width, height);
}

void SharedPixmap::update() {
  if (display_->has_shared_pixmaps) return;
  const auto width = static_cast<std::uint16_t>(size_.width);
  const auto height = static_cast<std::uint16_t>(size_.height);
  xcb_shm_put_image(display_->connection.get(), pixmap_, display_->graphics_context, width, height, 0, 0,
                    width, height, 0, 0, display_->depth, XCB_IMAGE_FORMAT_Z_PIXMAP, /*send_event=*/0,
                    segment_, 0);
}

void SharedPixmap::swap(SharedPixmap& io_other) {
  std::swap(display_, io_other.display_);
  std::swap(size_, io_other.size_);
  std::swap(memory_, io_other.memory_);
  std::swap(segment_, io_other.segment_);
  std::swap(pixmap_, io_other.pixmap_);
}

}  // namespace temblor::platform::sdl2
