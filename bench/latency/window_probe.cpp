#include "bench/latency/window_probe.h"

#include <xcb/xtest.h>

#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>

namespace temblor::bench {
namespace {

constexpr std::uint16_t kPatchSize = 48;
constexpr xcb_keysym_t kLeftArrow = 0xff51, kRightArrow = 0xff53;
constexpr int kMouseCounts = 40;  // far enough to move every texel of the patch
constexpr double kStill_s = 0.12, kMaxWait_s = 2;
constexpr std::chrono::microseconds kBetweenReadings(250);  // leaves the processor to the game
// Animated lights change many pixels a little. A turn changes many pixels much.
constexpr int kChannelChange = 8;
constexpr std::size_t kMinChangedPixels = std::size_t{kPatchSize} * kPatchSize / 20;

double clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct FreeReply {
  void operator()(void* reply) const { std::free(reply); }
};
template <typename T>
std::unique_ptr<T, FreeReply> own(T* reply) {
  return std::unique_ptr<T, FreeReply>(reply);
}

bool is_changed(const std::vector<std::uint8_t>& before, const std::vector<std::uint8_t>& now) {
  if (before.size() != now.size()) return false;
  std::size_t changed = 0;
  for (std::size_t pixel = 0; pixel + 3 < now.size(); pixel += 4) {
    bool differs = false;
    for (std::size_t i = pixel; i < pixel + 3; ++i) differs |= std::abs(before[i] - now[i]) > kChannelChange;
    changed += differs;
  }
  return changed >= kMinChangedPixels;
}

}  // namespace

WindowProbe::WindowProbe(xcb_connection_t* connection)
    : connection_(connection), root_(xcb_setup_roots_iterator(xcb_get_setup(connection)).data->root) {
  left_key_ = find_key(kLeftArrow);
  right_key_ = find_key(kRightArrow);
}

std::unique_ptr<WindowProbe> WindowProbe::find(const std::string& title) {
  xcb_connection_t* const connection = xcb_connect(nullptr, nullptr);
  if (xcb_connection_has_error(connection) != 0) {
    xcb_disconnect(connection);
    return nullptr;
  }
  std::unique_ptr<WindowProbe> probe(new WindowProbe(connection));
  for (const double end_s = clock_s() + 20; !probe->find_window(title);) {
    if (clock_s() > end_s) return nullptr;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  xcb_set_input_focus(connection, XCB_INPUT_FOCUS_PARENT, probe->window_, XCB_CURRENT_TIME);
  xcb_flush(connection);
  return probe;
}

// Without a window manager, a program's window is a child of the root window.
bool WindowProbe::find_window(const std::string& title) {
  xcb_connection_t* const connection = connection_.get();
  const auto tree = own(xcb_query_tree_reply(connection, xcb_query_tree(connection, root_), nullptr));
  if (!tree) return false;
  for (int i = 0; i < xcb_query_tree_children_length(tree.get()); ++i) {
    const xcb_window_t window = xcb_query_tree_children(tree.get())[i];
    const auto name = own(xcb_get_property_reply(
        connection,
        xcb_get_property(connection, 0, window, XCB_ATOM_WM_NAME, XCB_GET_PROPERTY_TYPE_ANY, 0, 64),
        nullptr));
    if (!name) continue;
    const std::string_view text(static_cast<const char*>(xcb_get_property_value(name.get())),
                                static_cast<std::size_t>(xcb_get_property_value_length(name.get())));
    const auto size = own(xcb_get_geometry_reply(connection, xcb_get_geometry(connection, window), nullptr));
    const auto state = own(
        xcb_get_window_attributes_reply(connection, xcb_get_window_attributes(connection, window), nullptr));
    if (!text.starts_with(title) || !size || !state || state->map_state != XCB_MAP_STATE_VIEWABLE) continue;
    window_ = window;
    // Above the crosshair, the weapon, and the status bar.
    patch_x_ = static_cast<std::int16_t>((size->width - kPatchSize) / 2);
    patch_y_ = static_cast<std::int16_t>(size->height / 5);
    return true;
  }
  return false;
}

xcb_keycode_t WindowProbe::find_key(xcb_keysym_t symbol) const {
  const xcb_setup_t& setup = *xcb_get_setup(connection_.get());
  const auto count = static_cast<std::uint8_t>(setup.max_keycode - setup.min_keycode + 1);
  const auto map = own(xcb_get_keyboard_mapping_reply(
      connection_.get(), xcb_get_keyboard_mapping(connection_.get(), setup.min_keycode, count), nullptr));
  if (!map) return 0;
  const xcb_keysym_t* const symbols = xcb_get_keyboard_mapping_keysyms(map.get());
  for (int i = 0; i < xcb_get_keyboard_mapping_keysyms_length(map.get()); ++i)
    if (symbols[i] == symbol)
      return static_cast<xcb_keycode_t>(setup.min_keycode + i / map->keysyms_per_keycode);
  return 0;
}

WindowProbe::Pixels WindowProbe::read() const {
  const auto image =
      own(xcb_get_image_reply(connection_.get(),
                              xcb_get_image(connection_.get(), XCB_IMAGE_FORMAT_Z_PIXMAP, window_, patch_x_,
                                            patch_y_, kPatchSize, kPatchSize, ~0u),
                              nullptr));
  if (!image) return {};
  const std::uint8_t* const bytes = xcb_get_image_data(image.get());
  return {bytes, bytes + xcb_get_image_data_length(image.get())};
}

std::optional<WindowProbe::Pixels> WindowProbe::wait_until_still() const {
  const double end_s = clock_s() + kMaxWait_s;
  Pixels first = read();
  for (double since_s = clock_s(); clock_s() < end_s;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(4));
    Pixels now = read();
    if (is_changed(first, now)) {
      first = std::move(now);
      since_s = clock_s();
    } else if (clock_s() - since_s > kStill_s) {
      return now;
    }
  }
  return std::nullopt;
}

void WindowProbe::send(std::uint8_t type, std::uint8_t detail, int right) {
  xcb_test_fake_input(connection_.get(), type, detail, XCB_CURRENT_TIME, XCB_NONE,
                      static_cast<std::int16_t>(right), 0, 0);
  sent_s_ = clock_s();
  xcb_flush(connection_.get());
}

std::optional<double> WindowProbe::measure(Action action) {
  const std::optional<Pixels> before = wait_until_still();
  if (!before) return std::nullopt;
  const bool is_left = is_next_left_;
  is_next_left_ = !is_next_left_;
  const xcb_keycode_t key = is_left ? left_key_ : right_key_;
  if (action == Action::kTurnByKey)
    send(XCB_KEY_PRESS, key, 0);
  else
    send(XCB_MOTION_NOTIFY, /*relative*/ 1, is_left ? -kMouseCounts : kMouseCounts);
  const double event_s = sent_s_;
  std::optional<double> latency_s;
  while (!latency_s && clock_s() - event_s < kMaxWait_s) {
    std::this_thread::sleep_for(kBetweenReadings);
    if (is_changed(*before, read())) latency_s = clock_s() - event_s;
  }
  if (action == Action::kTurnByKey) send(XCB_KEY_RELEASE, key, 0);
  sent_s_ = event_s;
  return latency_s;
}

}  // namespace temblor::bench
