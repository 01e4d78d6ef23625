// Console lines that a server sends to its players (svc_stufftext). The stock game runs any line. Here a
// server on another machine may run harmless commands only, and everything that a server has set (variables,
// aliases, keys, the tint) is as before when the player leaves it, unless the player has changed it since.
//
// The console marks the server's text (command::Source), through `wait`, `exec`, and the server's aliases;
// the keys that it has bound count, too. All settings are compared before and after each row of its commands,
// so no way to change them is missed.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "client/input/bindings.h"
#include "command/console.h"

namespace temblor::host {

struct Host;

// The values of cl_stufftext.
enum class StuffedTextRule { kNone, kSafe, kAll };

// Whether StuffedTextRule::kSafe allows all commands of the line: harmless ones, buttons, and those `aliases`
// that the server has set. Keys and aliases may only run commands that are allowed.
bool may_be_stuffed(std::string_view line, const command::Aliases& aliases = {});

class StuffedText {
 public:
  // Lets the console call this object. Call it once, before run().
  static void add_rules(Host& io_host);
  // Appends a line to the console. `is_trusted`: the server runs in this program.
  void run(Host& io_host, std::string_view line, bool is_trusted);
  // Whether the server has bound this key to its commands.
  bool has_bound(const client::Bindings& bindings, platform::Key key) const;
  // Undoes what lines have set. Call when the player has left the server.
  void restore(Host& io_host);

  // The player's own settings: the present ones without the changes of the server.
  struct OwnSettings {
    command::Variables variables;
    client::Bindings bindings;
  };
  OwnSettings own_settings(const Host& host);

 private:
  // The player's own value, and the one that the server has set.
  template <typename Value>
  struct Change {
    Value own, sent;
  };
  template <typename Key, typename Value>
  using Changes = std::map<Key, Change<Value>>;
  template <typename Key, typename Value>
  static void note_change(Changes<Key, Value>& io_changes, const Key& key, const Value& before,
                          const Value& after);
  // All settings that a command can change.
  struct Settings {
    std::vector<command::VariableValue> variables{};  // by index
    command::Aliases aliases;
    client::Bindings bindings;
  };
  static Settings copy_settings(const Host& host);

  bool may_run(Host& io_host, command::Console::Arguments words);
  void refuse(Host& io_host, const std::string& name);
  // Compares the settings with those before the running commands.
  void note_changes(const Host& host);
  void note_variables(const Host& host, const std::vector<command::VariableValue>& after);
  void undo_variables(command::Variables& io_variables) const;
  void undo_bindings(client::Bindings& io_bindings) const;

  bool is_trusted_ = false;
  std::optional<Settings> before_;  // the server's commands that run; none: none runs
  Changes<std::size_t, command::VariableValue> variables_;
  Changes<std::string, command::Alias> aliases_;  // without a text: no alias
  Changes<platform::Key, std::string> keys_;
  std::set<std::string, std::less<>> held_;     // buttons that lines hold down, without the "+"
  std::set<std::string, std::less<>> refused_;  // names of commands, to report each of them once
};

}  // namespace temblor::host
