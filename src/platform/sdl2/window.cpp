#include "platform/sdl2/window.h"

#include <SDL.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "platform/sdl2/events/event_times.h"
#include "platform/sdl2/gamepads.h"
#include "platform/sdl2/gl_context.h"
#include "platform/sdl2/keys.h"
#include "platform/sdl2/library.h"
#include "platform/sdl2/presenters.h"
#include "platform/sdl2/x11_presenter.h"

namespace temblor::platform::sdl2 {
namespace {

struct DestroyWindow {
  void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<SDL_Window, DestroyWindow>;

// Falls back to the first display: settings may come from a time when more were connected.
int find_display(int wished) {
  return wished >= 0 && wished < SDL_GetNumVideoDisplays() ? wished : 0;
}

// A renderer on hardware, then shared memory, with vsync if possible, then any renderer (Wayland without
// graphics hardware). Null: none of them works.
std::unique_ptr<PicturePresenter> choose_presenter(SDL_Window* window, Presenter wanted) {
  std::unique_ptr<PicturePresenter> pictures;
  if (wanted != Presenter::kSharedMemory)
    pictures = make_renderer_presenter(window, wanted == Presenter::kAuto);
  if (!pictures) pictures = make_x11_presenter(window);
  if (!pictures) pictures = make_surface_presenter(window);
  if (!pictures) pictures = make_renderer_presenter(window, false);
  return pictures;
}

// With OpenGL, if the display has it: a window cannot get it later. Programs that show pictures through
// shared memory do not load the driver.
WindowHandle create_window(const std::string& title, const WindowSettings& settings, Presenter presenter) {
  const int place =
      static_cast<int>(SDL_WINDOWPOS_CENTERED_DISPLAY(static_cast<unsigned>(find_display(settings.display))));
  const auto create = [&](Uint32 more_flags) {
    return WindowHandle(SDL_CreateWindow(title.c_str(), place, place, settings.size.width,
                                         settings.size.height,
                                         SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI | more_flags));
  };
  WindowHandle window;
  if (presenter != Presenter::kSharedMemory) {
    window = create(SDL_WINDOW_OPENGL);
    if (!window) {  // the display may have OpenGL ES only
      SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
      SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
      SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
      window = create(SDL_WINDOW_OPENGL);
      SDL_GL_ResetAttributes();
    }
  }
  if (!window) window = create(0);
  return window;
}

class SdlWindow : public Window {
 public:
  SdlWindow(Subsystem subsystem, WindowHandle window, Presenter wanted,
            std::unique_ptr<PicturePresenter> presenter)
      : subsystem_(std::move(subsystem)),
        window_(std::move(window)),
        wanted_presenter_(wanted),
        presenter_(std::move(presenter)),
        event_times_(window_.get()) {
    SDL_StopTextInput();
  }

  base::Status apply(const WindowSettings& settings) override;
  void poll(std::vector<InputEvent>& io_events) override;
  double now_s() const override {
    return static_cast<double>(SDL_GetPerformanceCounter()) /
           static_cast<double>(SDL_GetPerformanceFrequency());
  }
  PixelSize size() const override {
    PixelSize size;
    SDL_GetWindowSizeInPixels(window_.get(), &size.width, &size.height);
    return size;
  }
  bool is_visible() const override {
    return (SDL_GetWindowFlags(window_.get()) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) == 0;
  }
  base::Status present(const Picture& picture, base::Jobs& jobs) override;
  base::Result<std::unique_ptr<WindowGlContext>> open_gl() override;
  void capture_mouse(bool captured) override;
  void take_text(bool wanted) override { wanted ? SDL_StartTextInput() : SDL_StopTextInput(); }
  std::string clipboard() const override;
  void set_clipboard(std::string_view text) override { SDL_SetClipboardText(std::string(text).c_str()); }
  void rumble(float low, float high, double seconds) override { gamepads_.rumble(low, high, seconds); }
  double refresh_rate_hz() const override;
  std::vector<PixelSize> full_screen_sizes(int display) const override;
  int displays() const override { return std::max(1, SDL_GetNumVideoDisplays()); }
  std::string describe() const override {
    return presenter_ ? presenter_->describe() : describe_gl(gl_window_);
  }

 private:
  // Translates one SDL event and appends the result, if any.
  void take(const SDL_Event& event, double time_s, std::vector<InputEvent>& io_events);
  void take_pointer(int x, int y, double time_s, std::vector<InputEvent>& io_events) const;
  base::Status set_mode(const WindowSettings& settings);

  // Members are destroyed in reverse order: the presenter before its window, the window before SDL.
  Subsystem subsystem_;
  WindowHandle window_;
  Presenter wanted_presenter_;
  // Null while a context of OpenGL draws into the window, and until the next picture.
  std::unique_ptr<PicturePresenter> presenter_;
  GlWindow gl_window_{window_.get()};
  Gamepads gamepads_;
  EventTimes event_times_;
  bool captured_ = false;
};

base::Status SdlWindow::apply(const WindowSettings& settings) {
  TRY_STATUS(set_mode(settings));
  gl_window_.vsync = settings.vsync;
  if (presenter_) presenter_->set_vsync(settings.vsync);
  return base::Ok{};
}

base::Status SdlWindow::present(const Picture& picture, base::Jobs& jobs) {
  if (!presenter_) {
    presenter_ = choose_presenter(window_.get(), wanted_presenter_);
    if (!presenter_) return sdl_error("showing pictures in the window");
    presenter_->set_vsync(gl_window_.vsync);
  }
  return presenter_->present(picture, jobs);
}

// The presenter may have a context for the same window.
base::Result<std::unique_ptr<WindowGlContext>> SdlWindow::open_gl() {
  presenter_.reset();
  return make_gl_context(gl_window_);
}

base::Status SdlWindow::set_mode(const WindowSettings& settings) {
  SDL_Window* const window = window_.get();
  const int display = find_display(settings.display);
  // A full-screen window cannot change its size or display, so leave full screen first.
  if (settings.mode != WindowMode::kFullScreen || SDL_GetWindowDisplayIndex(window) != display) {
    if (SDL_SetWindowFullscreen(window, 0) != 0) return sdl_error("leaving full screen");
    if (SDL_GetWindowDisplayIndex(window) != display) {
      const int place = static_cast<int>(SDL_WINDOWPOS_CENTERED_DISPLAY(static_cast<unsigned>(display)));
      SDL_SetWindowPosition(window, place, place);
    }
  }
  if (settings.mode == WindowMode::kWindowed) {
    SDL_SetWindowSize(window, settings.size.width, settings.size.height);
    return base::Ok{};
  }
  if (settings.mode == WindowMode::kBorderless)
    return SDL_SetWindowFullscreen(window, SDL_WINDOW_FULLSCREEN_DESKTOP) == 0
               ? base::Status(base::Ok{})
               : sdl_error("borderless full screen");
  const SDL_DisplayMode wished{SDL_PIXELFORMAT_UNKNOWN, settings.size.width, settings.size.height, 0,
                               nullptr};
  SDL_DisplayMode mode;
  if (SDL_GetClosestDisplayMode(display, &wished, &mode) == nullptr)
    // The display has no mode that large, because the settings were made for another one. Use its own mode.
    return SDL_SetWindowFullscreen(window, SDL_WINDOW_FULLSCREEN_DESKTOP) == 0 ? base::Status(base::Ok{})
                                                                               : sdl_error("full screen");
  if (SDL_SetWindowDisplayMode(window, &mode) != 0 ||
      SDL_SetWindowFullscreen(window, SDL_WINDOW_FULLSCREEN) != 0)
    return sdl_error("full screen");
  return base::Ok{};
}

void SdlWindow::poll(std::vector<InputEvent>& io_events) {
  SDL_Event event;
  while (SDL_PollEvent(&event) != 0) take(event, event_times_.take(event, now_s()), io_events);
  event_times_.end_poll();
}

void SdlWindow::take(const SDL_Event& event, double time_s, std::vector<InputEvent>& io_events) {
  const auto add = [&](auto what) { io_events.push_back({time_s, std::move(what)}); };
  switch (event.type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      if (const Key key = find_key(event.key.keysym.scancode); key != Key::kNone)
        add(KeyChange{key, event.type == SDL_KEYDOWN, event.key.repeat != 0});
      return;
    case SDL_TEXTINPUT:
      return add(TextTyped{event.text.text});
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      if (!captured_) take_pointer(event.button.x, event.button.y, time_s, io_events);
      if (const Key key = find_mouse_key(event.button.button); key != Key::kNone)
        add(KeyChange{key, event.type == SDL_MOUSEBUTTONDOWN});
      return;
    case SDL_MOUSEWHEEL: {
      // Each step of the wheel is a key that is pressed and released, so that commands can be bound to it. A
      // device may report any number of steps; the limit bounds the events of one poll.
      const int up = event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -event.wheel.y : event.wheel.y;
      for (int i = 0; i < std::min(std::abs(up), 16); ++i) {
        add(KeyChange{up > 0 ? Key::kWheelUp : Key::kWheelDown, true});
        add(KeyChange{up > 0 ? Key::kWheelUp : Key::kWheelDown, false});
      }
      return;
    }
    case SDL_MOUSEMOTION:
      if (captured_)
        add(MouseMoved{static_cast<float>(event.motion.xrel), static_cast<float>(event.motion.yrel)});
      else
        take_pointer(event.motion.x, event.motion.y, time_s, io_events);
      return;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_GAINED) add(FocusChanged{true});
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) add(FocusChanged{false});
      if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED ||
          event.window.event == SDL_WINDOWEVENT_DISPLAY_CHANGED) {
        WindowChanged changed;
        SDL_GetWindowSize(window_.get(), &changed.width, &changed.height);
        add(changed);
      }
      return;
    case SDL_QUIT:
      return add(CloseRequested{});
    default:
      gamepads_.take(event, time_s, io_events);
  }
}

void SdlWindow::take_pointer(int x, int y, double time_s, std::vector<InputEvent>& io_events) const {
  int width = 0, height = 0;
  SDL_GetWindowSize(window_.get(), &width, &height);  // the pointer's units, not pixels
  io_events.push_back(
      {time_s, PointerMoved{static_cast<float>(x) / static_cast<float>(std::max(1, width)),
                            static_cast<float>(y) / static_cast<float>(std::max(1, height))}});
}

void SdlWindow::capture_mouse(bool captured) {
  if (captured == captured_) return;
  captured_ = captured;
  SDL_SetRelativeMouseMode(captured ? SDL_TRUE : SDL_FALSE);
  // Drop movement from before the change: it would turn the view.
  SDL_GetRelativeMouseState(nullptr, nullptr);
  SDL_FlushEvent(SDL_MOUSEMOTION);
}

std::string SdlWindow::clipboard() const {
  struct Free {
    void operator()(char* text) const { SDL_free(text); }
  };
  const std::unique_ptr<char, Free> text(SDL_GetClipboardText());
  return text ? text.get() : "";
}

double SdlWindow::refresh_rate_hz() const {
  SDL_DisplayMode mode;
  const int display = SDL_GetWindowDisplayIndex(window_.get());
  return display >= 0 && SDL_GetCurrentDisplayMode(display, &mode) == 0 ? mode.refresh_rate : 0;
}

std::vector<PixelSize> SdlWindow::full_screen_sizes(int wanted_display) const {
  std::vector<PixelSize> sizes;
  const int display = find_display(wanted_display);
  for (int i = 0; i < SDL_GetNumDisplayModes(display); ++i) {
    SDL_DisplayMode mode;
    if (SDL_GetDisplayMode(display, i, &mode) != 0) continue;
    const PixelSize size{mode.w, mode.h};
    if (std::find(sizes.begin(), sizes.end(), size) == sizes.end()) sizes.push_back(size);
  }
  return sizes;
}

}  // namespace

base::Result<std::unique_ptr<Window>> open_window(const std::string& title, const WindowSettings& settings,
                                                  Presenter presenter) {
  // In order: keep the desktop's compositor; use raw mouse counts; the click that gives the window the focus
  // also counts; keep full screen when another window gets the focus.
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  SDL_SetHint(SDL_HINT_MOUSE_RELATIVE_SYSTEM_SCALE, "0");
  SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
  SDL_SetHint(SDL_HINT_VIDEO_MINIMIZE_ON_FOCUS_LOSS, "0");
  TRY(Subsystem subsystem, Subsystem::start(SDL_INIT_VIDEO | SDL_INIT_GAMECONTROLLER));
  // SDL falls back to these drivers if there is no display. They show nothing, so fail unless the user chose
  // one.
  const std::string_view driver = SDL_GetCurrentVideoDriver();
  const bool is_wanted = std::getenv("SDL_VIDEODRIVER") != nullptr;
  if (!is_wanted && (driver == "offscreen" || driver == "dummy" || driver == "evdev"))
    return base::error(base::ErrorCode::kNotFound, "no X11 or Wayland display");
  WindowHandle window = create_window(title, settings, presenter);
  if (!window) return sdl_error("opening a window");
  std::unique_ptr<PicturePresenter> pictures = choose_presenter(window.get(), presenter);
  if (!pictures) return sdl_error("showing pictures in the window");
  auto opened =
      std::make_unique<SdlWindow>(std::move(subsystem), std::move(window), presenter, std::move(pictures));
  TRY_STATUS(opened->apply(settings));
  return std::unique_ptr<Window>(std::move(opened));
}

}  // namespace temblor::platform::sdl2
