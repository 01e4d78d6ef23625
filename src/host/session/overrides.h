// Settings that hold for one run: what the command line says, above what the player has kept.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "base/result.h"
#include "command/variables.h"

namespace temblor::host {

// Of a variable that was overridden the player's own value is kept, until he changes it in the run: then what
// he has chosen is his, and later calls leave it alone.
class Overrides {
 public:
  // `set` sets variables; called again whenever the player's settings have been read anew.
  base::Status apply(const std::function<base::Status()>& set, command::Variables& io_variables);
  // Before they are read anew: what the player has changed since apply() is no longer overridden.
  void release_changed(const command::Variables& variables);
  // The value that is to be kept; as long as the variable and this are not changed.
  const std::string& own_text(const command::Variable& variable) const;

 private:
  struct Entry {
    std::string own_text;
    std::uint64_t version = 0;  // the variable's, as long as the player has not touched it
  };
  std::map<std::string, Entry> entries_;  // by name as registered
  std::set<std::string> released_;
};

}  // namespace temblor::host
