// Settings for a single run: values of the command line take the place of the player's, but are not saved.
//
// For each overridden variable the player's own value is remembered and saved instead, until the player
// changes the variable during the run. From then on the new value counts, and the command line no longer
// touches it:
//
//   temblor.cfg   command line   during the run      in effect   saved
//   fov 90        fov 110        -                   110         90
//   fov 90        fov 110        player sets 100     100         100, also after a switch to another mod
//
// Changes are detected by Variable::version. Setting a variable to the value that it already has is not a
// change.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "base/result.h"
#include "command/variables.h"

namespace temblor::host {

class Overrides {
 public:
  // Calls `set`, which sets variables, and remembers their previous values. Call it each time after the
  // player's settings have been read. Fails if `set` does.
  base::Status apply(const std::function<base::Status()>& set, command::Variables& io_variables);
  // Call it before the settings are read again: variables that the player has changed since apply() are no
  // longer overridden.
  void release_changed(const command::Variables& variables);
  // The value to save: the player's own. The reference is valid until the variable or this object changes.
  const std::string& own_text(const command::Variable& variable) const;

 private:
  struct Entry {
    std::string own_text;
    std::uint64_t version = 0;  // of the variable when it was overridden
  };
  std::map<std::string, Entry> entries_;  // by registered name
  // Variables that the player has changed in this run. They are never overridden again.
  std::set<std::string> released_;
};

}  // namespace temblor::host
