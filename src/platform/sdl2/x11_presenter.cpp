#include "platform/sdl2/x11_presenter.h"

#include <poll.h>
#include <xcb/present.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include "platform/sdl2/library.h"
#include "platform/sdl2/picture_surface.h"
#include "platform/sdl2/shared_pixmap.h"
#include "platform/sdl2/x11_display.h"
#include "platform/sdl2/x11_window.h"

namespace temblor::platform::sdl2 {
namespace {

// The server shows nothing while the display sleeps or another program covers the window. The game goes on.
constexpr std::chrono::milliseconds kMaxWait(100);

struct Buffer {
  std::optional<SharedPixmap> pixmap;
  bool is_idle = true;  // the server does not read it
};

PixelSize find_size(SDL_Window* window) {
  PixelSize size;
  SDL_GetWindowSizeInPixels(window, &size.width, &size.height);
  return size;
}

class X11Presenter : public PicturePresenter {
 public:
  X11Presenter(SDL_Window* window, X11Display display) : window_(window), display_(std::move(display)) {
    xcb_connection_t* const connection = display_.connection.get();
    xcb_present_select_input(connection, xcb_generate_id(connection), display_.window,
                             XCB_PRESENT_EVENT_MASK_COMPLETE_NOTIFY | XCB_PRESENT_EVENT_MASK_IDLE_NOTIFY);
  }

  // Makes the buffers. Fails if the server cannot share memory.
  base::Status prepare() {
    for (Buffer& buffer : buffers_) TRY_STATUS(fit(find_size(window_), buffer));
    return base::Ok{};
  }

  base::Status present(const Picture& picture, base::Jobs& jobs) override;
  void set_vsync(bool vsync) override { vsync_ = vsync; }
  std::string describe() const override {
    return fmt::format("x11, shared memory, {}", vsync_ ? "vsync by the Present extension" : "vsync off");
  }

 private:
  // Gives the buffer a pixmap of this size.
  base::Status fit(PixelSize size, Buffer& io_buffer) const;
  Buffer* wait_for_idle_buffer();
  // Handles events until the condition holds. False: it did not within kMaxWait, or the connection is lost.
  template <typename Condition>
  bool wait_until(const Condition& holds);
  void take_events();
  void take(const xcb_generic_event_t& event);

  SDL_Window* window_;
  X11Display display_;
  std::array<Buffer, 2> buffers_;  // destroyed before the display
  std::uint32_t sent_ = 0;         // number of the last picture
  std::uint32_t completed_ = 0;    // of the last one in the window
  std::uint8_t error_code_ = 0;    // of a request for this picture
  bool vsync_ = false;
};

base::Status X11Presenter::present(const Picture& picture, base::Jobs& jobs) {
  error_code_ = 0;
  Buffer* const buffer = wait_for_idle_buffer();
  if (xcb_connection_has_error(display_.connection.get()) != 0)
    return base::error(base::ErrorCode::kIo, "the connection to the display is lost");
  if (buffer == nullptr) return base::Ok{};  // the display sleeps; it does not need this picture
  TRY_STATUS(fit(find_size(window_), *buffer));
  SharedPixmap& pixmap = *buffer->pixmap;
  const Surface surface = wrap_pixels(pixmap.pixels(), pixmap.size());
  if (!surface) return sdl_error("the window's shared memory");
  TRY_STATUS(draw_picture(picture, jobs, *surface));
  pixmap.update();
  buffer->is_idle = false;
  ++sent_;
  // A target of 0 is the next refresh, or now if the presentation is asynchronous.
  xcb_present_pixmap(display_.connection.get(), display_.window, pixmap.pixmap(), sent_, XCB_NONE, XCB_NONE,
                     0, 0, XCB_NONE, XCB_NONE, XCB_NONE,
                     vsync_ ? XCB_PRESENT_OPTION_NONE : XCB_PRESENT_OPTION_ASYNC, 0, 0, 0, 0, nullptr);
  xcb_flush(display_.connection.get());
  if (vsync_) wait_until([this] { return completed_ == sent_ || error_code_ != 0; });
  take_events();
  if (error_code_ == 0) return base::Ok{};
  for (Buffer& refused : buffers_) refused.is_idle = true;
  return base::error(base::ErrorCode::kIo, "the display refuses pictures: X error {}", error_code_);
}

base::Status X11Presenter::fit(PixelSize size, Buffer& io_buffer) const {
  if (io_buffer.pixmap && io_buffer.pixmap->size() == size) return base::Ok{};
  TRY(SharedPixmap pixmap, SharedPixmap::create(display_, size));
  io_buffer.pixmap.emplace(std::move(pixmap));
  return base::Ok{};
}

Buffer* X11Presenter::wait_for_idle_buffer() {
  const auto find_idle = [this] {
    return std::find_if(buffers_.begin(), buffers_.end(), [](const Buffer& each) { return each.is_idle; });
  };
  return wait_until([&] { return find_idle() != buffers_.end(); }) ? &*find_idle() : nullptr;
}

template <typename Condition>
bool X11Presenter::wait_until(const Condition& holds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + kMaxWait;
  for (;;) {
    take_events();
    if (holds()) return true;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0 || xcb_connection_has_error(display_.connection.get()) != 0) return false;
    pollfd server{xcb_get_file_descriptor(display_.connection.get()), POLLIN, 0};
    poll(&server, 1, static_cast<int>(left.count()));
  }
}

void X11Presenter::take_events() {
  while (const Reply<xcb_generic_event_t> event{xcb_poll_for_event(display_.connection.get())}) take(*event);
}

void X11Presenter::take(const xcb_generic_event_t& event) {
  if (event.response_type == 0) {
    error_code_ = reinterpret_cast<const xcb_generic_error_t&>(event).error_code;
    return;
  }
  const auto& generic = reinterpret_cast<const xcb_ge_generic_event_t&>(event);
  if ((event.response_type & 0x7f) != XCB_GE_GENERIC || generic.extension != display_.present_opcode) return;
  if (generic.event_type == XCB_PRESENT_EVENT_COMPLETE_NOTIFY)
    completed_ = reinterpret_cast<const xcb_present_complete_notify_event_t&>(event).serial;
  if (generic.event_type != XCB_PRESENT_EVENT_IDLE_NOTIFY) return;
  const xcb_pixmap_t idle = reinterpret_cast<const xcb_present_idle_notify_event_t&>(event).pixmap;
  for (Buffer& buffer : buffers_)
    if (buffer.pixmap && buffer.pixmap->pixmap() == idle) buffer.is_idle = true;
}

}  // namespace

std::unique_ptr<PicturePresenter> make_x11_presenter(SDL_Window* window) {
  const std::optional<std::uint32_t> number = find_x11_window(window);
  if (!number) return nullptr;
  std::optional<X11Display> display = connect_to_x11(*number);
  if (!display) return nullptr;
  auto presenter = std::make_unique<X11Presenter>(window, std::move(*display));
  return presenter->prepare().ok() ? std::move(presenter) : nullptr;
}

}  // namespace temblor::platform::sdl2
