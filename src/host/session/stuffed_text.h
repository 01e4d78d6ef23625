// Console lines that a server sends to its players (svc_stufftext). The stock game runs any line. Here a
// server on another machine may run harmless commands only, and everything that a server has set (variables,
// aliases, keys, the tint) is as before when the player leaves it, unless the player has changed it since.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::host {

struct Host;

// The values of cl_stufftext.
enum class StuffedTextRule { kNone, kSafe, kAll };

// Whether StuffedTextRule::kSafe allows the line. Keys and aliases may only run commands that are allowed.
bool may_be_stuffed(std::string_view line);

class StuffedText {
 public:
  // Runs a line, or refuses it. `is_trusted`: the server runs in this program.
  void run(Host& io_host, std::string_view line, bool is_trusted);
  // Undoes what lines have set. Call when the player has left the server.
  void restore(Host& io_host);

 private:
  enum class Kind { kVariable, kAlias, kKey };
  // The player's own text, and the one that the server has set. An alias or key without a text is empty.
  struct Change {
    Kind kind;
    std::string name, own, sent;
  };
  static std::string read(const Host& host, Kind kind, const std::string& name);
  static void write(Host& io_host, const Change& change);

  std::vector<Change> changes_;
  std::set<std::string, std::less<>> refused_;  // names of commands, to report each of them once
};

}  // namespace temblor::host
