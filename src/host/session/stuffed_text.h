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

// Whether StuffedTextRule::kSafe allows all commands of the line: harmless ones, buttons, and `own_aliases`,
// which the server has set. Keys and aliases may only run commands that are allowed.
using AliasNames = std::set<std::string, std::less<>>;
bool may_be_stuffed(std::string_view line, const AliasNames& own_aliases = {});

class StuffedText {
 public:
  // Runs a line, or those of its commands that are not refused. `is_trusted`: the server runs in this
  // program.
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
  static std::vector<Change> find_changes(const Host& host, const std::vector<std::string>& words,
                                          bool is_trusted);
  // The aliases that are still as the server has set them.
  AliasNames find_own_aliases(const Host& host) const;
  void refuse(Host& io_host, const std::string& name);
  void run_command(Host& io_host, std::string_view command, bool is_trusted);

  std::vector<Change> changes_;
  std::set<std::string, std::less<>> held_;     // buttons that lines hold down, without the "+"
  std::set<std::string, std::less<>> refused_;  // names of commands, to report each of them once
};

}  // namespace temblor::host
