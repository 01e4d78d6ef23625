#include "client/input/bindings.h"

#include <fmt/format.h>

#include <utility>

#include "base/text.h"
#include "client/input/key_names.h"
#include "command/text.h"

namespace temblor::client {
namespace {

using platform::Key;

// Stock bindings plus WASD, mouse and gamepad. Character keys are named by their character.
constexpr std::pair<std::string_view, std::string_view> kDefaults[] = {
    {"w", "+forward"},
    {"s", "+back"},
    {"a", "+moveleft"},
    {"d", "+moveright"},
    {"UPARROW", "+forward"},
    {"DOWNARROW", "+back"},
    {"LEFTARROW", "+left"},
    {"RIGHTARROW", "+right"},
    {"SPACE", "+jump"},
    {"CTRL", "+attack"},
    {"SHIFT", "+speed"},
    {"ALT", "+strafe"},
    {"e", "+moveup"},
    {"c", "+movedown"},
    {"PGUP", "+lookup"},
    {"PGDN", "+lookdown"},
    {"END", "centerview"},
    {"z", "+zoom"},
    {"MOUSE1", "+attack"},
    {"MOUSE2", "+jump"},
    {"MOUSE3", "+zoom"},
    {"MWHEELUP", "impulse 10"},
    {"MWHEELDOWN", "impulse 12"},
    {"1", "impulse 1"},
    {"2", "impulse 2"},
    {"3", "impulse 3"},
    {"4", "impulse 4"},
    {"5", "impulse 5"},
    {"6", "impulse 6"},
    {"7", "impulse 7"},
    {"8", "impulse 8"},
    {"0", "impulse 0"},
    {"/", "impulse 10"},
    {"q", "impulse 10"},
    {"TAB", "+showscores"},
    {"t", "messagemode"},
    {"y", "messagemode2"},
    {"PAUSE", "pause"},
    {"`", "toggleconsole"},
    {"~", "toggleconsole"},
    {"F1", "help_menu"},
    {"F2", "menu_save"},
    {"F3", "menu_load"},
    {"F4", "menu_options"},
    {"F5", "menu_multiplayer"},
    {"F6", "save quick"},
    {"F9", "load quick"},
    {"F10", "menu_quit"},
    {"F12", "screenshot"},
    {"-", "sizedown"},
    {"=", "sizeup"},
    {"RTRIGGER", "+attack"},
    {"LTRIGGER", "+jump"},
    {"ABUTTON", "+jump"},
    {"BBUTTON", "+movedown"},
    {"XBUTTON", "+moveup"},
    {"LSHOULDER", "impulse 12"},
    {"RSHOULDER", "impulse 10"},
    {"LTHUMB", "+speed"},
    {"RTHUMB", "centerview"},
    {"BACK", "+showscores"},
    {"YBUTTON", "+zoom"},
};

std::size_t to_index(Key key) {
  return static_cast<std::size_t>(key);
}

// Returns the commands of a key's release: "+a; echo b; +c" becomes "-a;-c", each with the key's number, as
// the '+' commands had.
std::string make_release_commands(std::string_view commands, Key key) {
  std::string ending;
  for (const std::string_view command : command::split_commands(commands)) {
    const std::vector<std::string> words = command::split_words(command);
    if (!words.empty() && words[0].starts_with('+'))
      ending += fmt::format("-{} {}\n", words[0].substr(1), to_index(key));
  }
  return ending;
}

// Returns the commands of a press. Actions get the key's number as argument, as in stock Quake, so that an
// action held by two keys lasts until both are released.
std::string make_press_commands(std::string_view commands, Key key) {
  std::string beginning;
  for (const std::string_view command : command::split_commands(commands)) {
    const std::vector<std::string> words = command::split_words(command);
    if (!words.empty() && words[0].starts_with('+'))
      beginning += fmt::format("{} {}\n", words[0], to_index(key));
    else
      beginning += fmt::format("{}\n", command);
  }
  return beginning;
}

}  // namespace

void Bindings::add_defaults() {
  for (const auto& [name, commands] : kDefaults) {
    const std::optional<Key> key = find_key(name);
    CHECK(key.has_value(), "{}", name);
    bind(*key, commands);
  }
}

void Bindings::bind(Key key, std::string_view commands) {
  commands_[to_index(key)] = commands;
}

void Bindings::unbind_all() {
  for (std::string& commands : commands_) commands.clear();
}

const std::string& Bindings::commands(Key key) const {
  return commands_[to_index(key)];
}

std::vector<Key> Bindings::find_keys(std::string_view commands) const {
  std::vector<Key> keys;
  for (std::size_t i = 0; i < commands_.size(); ++i)
    if (!commands_[i].empty() && base::equal_ignoring_case(commands_[i], commands))
      keys.push_back(Key{static_cast<std::uint16_t>(i)});
  return keys;
}

std::string Bindings::to_text() const {
  return "unbindall\n" + bind_lines();
}

std::string Bindings::bind_lines() const {
  std::string text;
  for (std::size_t i = 0; i < commands_.size(); ++i)
    if (!commands_[i].empty())
      text +=
          command::join_words({"bind", key_name(Key{static_cast<std::uint16_t>(i)}), commands_[i]}) + "\n";
  return text;
}

void add_binding_commands(command::Console& io_console, Bindings& io_bindings,
                          command::Console::Output print) {
  using Arguments = command::Console::Arguments;
  // Prints an error for an unknown key name.
  const auto parse_key = [&io_console](const std::string& name) {
    const std::optional<Key> key = find_key(name);
    if (!key)
      io_console.print_error(fmt::format("Unknown key \"{}\". Keys have names such as w, SPACE or MOUSE1",
                                         base::quotable(name)));
    return key;
  };
  io_console.add_command(
      "bind", "bind KEY \"COMMANDS\": makes a key run commands. bind KEY: shows them.",
      [&io_console, &io_bindings, print, parse_key](Arguments arguments) {
        if (arguments.size() < 2)
          return io_console.print_error("Usage: bind KEY \"COMMANDS\", with KEY such as w, SPACE or MOUSE1");
        const std::optional<Key> key = parse_key(arguments[1]);
        if (!key) return;
        if (arguments.size() == 2) {
          const std::string& commands = io_bindings.commands(*key);
          return print(commands.empty() ? fmt::format("\"{}\" is not bound", arguments[1])
                                        : fmt::format("\"{}\" = \"{}\"", arguments[1], commands));
        }
        // Words after the second belong to the commands, for people who forget the quotes.
        std::string commands = arguments[2];
        for (const std::string& word : arguments.subspan(3)) commands += fmt::format(" {}", word);
        io_bindings.bind(*key, commands);
      });
  io_console.add_command("unbind", "unbind KEY: removes a key's binding.",
                         [&io_console, &io_bindings, parse_key](Arguments arguments) {
                           if (arguments.size() < 2) return io_console.print_error("Usage: unbind KEY");
                           if (const std::optional<Key> key = parse_key(arguments[1]))
                             io_bindings.bind(*key, "");
                         });
  io_console.add_command("unbindall", "Removes all key bindings.",
                         [&io_bindings](Arguments) { io_bindings.unbind_all(); });
  io_console.add_command("bindlist", "Lists all key bindings.", [&io_bindings, print](Arguments) {
    for (std::size_t i = 0; i < platform::kKeys; ++i) {
      const Key key{static_cast<std::uint16_t>(i)};
      if (!io_bindings.commands(key).empty())
        print(fmt::format("{} \"{}\"", key_name(key), io_bindings.commands(key)));
    }
  });
}

// A key that repeats while held runs its commands only once.
std::string HeldKeys::press(Key key, std::string_view commands) {
  const std::size_t index = to_index(key);
  if (std::exchange(held_[index], true)) return {};
  release_commands_[index] = make_release_commands(commands, key);
  return make_press_commands(commands, key);
}

std::string HeldKeys::release(Key key) {
  held_[to_index(key)] = false;
  return std::exchange(release_commands_[to_index(key)], {});
}

std::string HeldKeys::release_all() {
  std::string ending;
  for (std::size_t i = 0; i < held_.size(); ++i) ending += release(Key{static_cast<std::uint16_t>(i)});
  return ending;
}

}  // namespace temblor::client
