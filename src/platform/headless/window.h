// A window without a display, for tests, benchmarks and machines without a screen. It keeps the last picture
// in memory. Callers add the events.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "platform/window.h"

namespace temblor::platform::headless {

class HeadlessWindow : public Window {
 public:
  explicit HeadlessWindow(const WindowSettings& settings) : settings_(settings) {}

  using What = decltype(InputEvent::what);
  // Adds an event for the next poll().
  void put(const What& what) { put_at(what, now_s()); }
  // Adds an event for the first poll() at `time_s` or later.
  void put_at(const What& what, double time_s);
  // Stops the clock at this time. Before the first call, the clock is the system's steady clock.
  void set_now(double now_s) { set_now_s_ = now_s; }
  // False makes present() fail, like a lost display.
  void set_can_present(bool can_present) { can_present_ = can_present; }
  // Makes the contexts of open_gl(). Without it, open_gl() fails.
  using OpenGl = std::function<base::Result<std::unique_ptr<WindowGlContext>>()>;
  void set_open_gl(OpenGl open_gl) { open_gl_ = std::move(open_gl); }
  // The pixels of the last picture, and the number of pictures so far.
  const std::vector<std::uint32_t>& shown() const { return shown_; }
  PixelSize shown_size() const { return shown_size_; }
  std::uint64_t pictures() const { return pictures_; }
  bool is_mouse_captured() const { return captured_; }
  bool takes_text() const { return takes_text_; }
  const WindowSettings& settings() const { return settings_; }

  base::Status apply(const WindowSettings& settings) override {
    if (settings.size != settings_.size) put(WindowChanged{settings.size.width, settings.size.height});
    settings_ = settings;
    return base::Ok{};
  }
  void poll(std::vector<InputEvent>& io_events) override;
  double now_s() const override {
    if (set_now_s_) return *set_now_s_;
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  PixelSize size() const override { return settings_.size; }
  bool is_visible() const override { return true; }
  base::Status present(const Picture& picture, base::Jobs& jobs) override;
  base::Result<std::unique_ptr<WindowGlContext>> open_gl() override {
    if (open_gl_) return open_gl_();
    return base::error(base::ErrorCode::kUnsupported, "there is no display");
  }
  void capture_mouse(bool captured) override { captured_ = captured; }
  void take_text(bool wanted) override { takes_text_ = wanted; }
  std::string clipboard() const override { return clipboard_; }
  void set_clipboard(std::string_view text) override { clipboard_ = text; }
  void rumble(float, float, double) override {}
  double refresh_rate_hz() const override { return 0; }
  std::vector<PixelSize> full_screen_sizes(int /*display*/) const override { return {settings_.size}; }
  int displays() const override { return 1; }
  std::string describe() const override { return "no display"; }

 private:
  WindowSettings settings_;
  OpenGl open_gl_;
  std::vector<InputEvent> events_;
  std::optional<double> set_now_s_;
  std::vector<std::uint32_t> shown_;
  PixelSize shown_size_;
  std::uint64_t pictures_ = 0;
  bool captured_ = false, takes_text_ = false, can_present_ = true;
  std::string clipboard_;
};

}  // namespace temblor::platform::headless
