// What keys do: each runs a line of console text. A command that begins with '+' lasts as long as its key is
// held: letting go runs it with '-' in its place.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "command/console.h"
#include "platform/key.h"

namespace temblor::client {

class Bindings {
 public:
  // WASD, the mouse, the stock keys and a gamepad; other keys stay as they are.
  void add_defaults();
  // Empty: the key does nothing.
  void bind(platform::Key key, std::string_view commands);
  void unbind_all();

  const std::string& commands(platform::Key key) const;
  // Keys that run exactly this, in order of key.
  std::vector<platform::Key> keys_of(std::string_view commands) const;
  // Console text that makes these bindings, and no others.
  std::string to_text() const;

 private:
  std::array<std::string, platform::kKeys> commands_;
};

// bind, unbind, unbindall, bindlist. `io_bindings` must outlive the console.
void add_binding_commands(command::Console& io_console, Bindings& io_bindings,
                          command::Console::Output print);

// Keys that are held, with what they did when they went down: letting go ends that, whatever the key is bound
// to by then.
class HeldKeys {
 public:
  // The console text to run. A key that is held already runs nothing.
  std::string press(platform::Key key, std::string_view commands);
  std::string release(platform::Key key);
  // When nothing more will be heard of them: the window has lost the focus, a menu has opened.
  std::string release_all();
  bool is_held(platform::Key key) const { return held_[static_cast<std::size_t>(key)]; }

 private:
  std::array<bool, platform::kKeys> held_{};
  std::array<std::string, platform::kKeys> ending_;  // what letting go runs
};

}  // namespace temblor::client
