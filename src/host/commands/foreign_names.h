// Names of commands and variables of other engines. Players bring them in config files and type them from
// habit.
//
//   the same setting under another name    sets ours, converted to its unit: cl_bob 0.02 -> v_bob 1
//   a setting that has no counterpart      is ignored; the console says so once, if `developer` is set
//   a name that nobody knows               an error; in a config file one line counts them
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include "command/console.h"

namespace temblor::host {

class ForeignNames {
 public:
  using Arguments = command::Console::Arguments;

  // Both must outlive this object.
  ForeignNames(command::Console& console, command::Variables& io_variables)
      : console_(console), variables_(io_variables) {}

  // Handles a command whose name is neither a command, nor an alias, nor a variable of ours. false: it is an
  // error that the console should report.
  bool handle(Arguments arguments);
  // Handles NAME VALUE if the name is known from other engines; false: it is not.
  bool set_known(Arguments arguments);

  // Returns a line about the unknown names in config files since the last call; empty: there were none.
  std::string take_report();

 private:
  bool is_developer() const;
  // Handles names whose values need more than a factor.
  bool set_converted(std::string_view name, Arguments arguments);
  // Sets our variables that correspond to the name, or names them. false: there are none.
  bool set_counterpart(std::string_view name, Arguments arguments);

  command::Console& console_;
  command::Variables& variables_;
  std::set<std::string, std::less<>> reported_;  // names without a counterpart
  std::string first_unknown_;
  std::size_t unknown_ = 0;
};

}  // namespace temblor::host
