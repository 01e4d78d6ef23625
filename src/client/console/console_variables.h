// Console variables for the console's look: con_notifytime, con_notifylines, con_highcontrast, scr_conspeed,
// scr_conscale, scr_conalpha and scr_textsize.
#pragma once

#include "client/console/console_ui.h"
#include "command/variables.h"

namespace temblor::client {

class ConsoleVariables {
 public:
  // Registers the variables. Their defaults are those of ConsoleSettings.
  explicit ConsoleVariables(command::Variables& variables);
  // The current settings. `variables` is the table that the constructor received.
  ConsoleSettings read(const command::Variables& variables) const;

 private:
  command::VariableIndex notify_time_, notify_rows_, slide_speed_, scale_, opacity_, high_contrast_,
      text_size_;
};

}  // namespace temblor::client
