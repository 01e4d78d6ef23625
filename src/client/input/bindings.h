// Key bindings: each key runs a line of console text. A command that begins with '+' lasts while the key is
// held; releasing the key runs it with '-' instead:
//
//   bind w "+forward"      press: "+forward 119"      release: "-forward 119"      (119: the key's number)
//   bind F6 "save quick"   press: "save quick"        release: nothing
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "command/console.h"
#include "platform/key.h"

namespace temblor::client {

// One line of commands for each key; empty if the key is not bound.
class Bindings {
 public:
  // Binds WASD, the mouse, the stock keys and a gamepad; leaves other keys as they are.
  void add_defaults();
  // Binds a key to commands, in place of what it was bound to. Empty commands unbind it.
  void bind(platform::Key key, std::string_view commands);
  void unbind_all();

  const std::string& commands(platform::Key key) const;
  // The keys that run exactly these commands, ignoring case, in order of key.
  std::vector<platform::Key> find_keys(std::string_view commands) const;
  // Console text that recreates these bindings and removes all others.
  std::string to_text() const;
  // Returns only the bind commands, one on each line.
  std::string bind_lines() const;

 private:
  std::array<std::string, platform::kKeys> commands_;
};

// Registers the commands bind, unbind, unbindall and bindlist. `io_bindings` must outlive the console.
// `print` receives lines without their ends.
void add_binding_commands(command::Console& io_console, Bindings& io_bindings,
                          command::Console::Output print);

// Tracks which keys are held, and stores at the press what the release must run. So an action ends properly
// even if its key is bound to something else in between.
class HeldKeys {
 public:
  // Return the console text to run. It is empty if there is nothing to run, or if press() is called for a key
  // that is already held.
  std::string press(platform::Key key, std::string_view commands);
  std::string release(platform::Key key);
  // Releases all keys and returns the console text to run. For events after which releases do not arrive: the
  // window has lost focus, or a menu has opened.
  std::string release_all();
  bool is_held(platform::Key key) const { return held_[static_cast<std::size_t>(key)]; }

 private:
  std::array<bool, platform::kKeys> held_{};
  std::array<std::string, platform::kKeys> release_commands_;
};

}  // namespace temblor::client
