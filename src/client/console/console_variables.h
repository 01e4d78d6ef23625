// The console's look as console variables, with the size of all text.
#pragma once

#include "client/console/console_ui.h"
#include "command/variables.h"

namespace temblor::client {

class ConsoleVariables {
 public:
  // Registers the variables, each with its help; the defaults are those of ConsoleSettings.
  explicit ConsoleVariables(command::Variables& variables);
  // `variables` is the table they were registered in.
  ConsoleSettings read(const command::Variables& variables) const;

 private:
  command::VariableIndex notify_time_, notify_rows_, slide_speed_, scale_, opacity_, high_contrast_,
      text_size_;
};

}  // namespace temblor::client
