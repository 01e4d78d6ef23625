#include "client/console/console_variables.h"

namespace temblor::client {

ConsoleVariables::ConsoleVariables(command::Variables& variables) {
  const ConsoleSettings defaults;
  notify_time_ = variables.add_float("con_notifytime", defaults.notify_time_s, 0, 3600,
                                     "Seconds that messages stay on screen during the game.");
  notify_rows_ = variables.add_int("con_notifylines", defaults.notify_rows, 0, 64,
                                   "Maximum number of message rows during the game.");
  slide_speed_ = variables.add_float("scr_conspeed", defaults.slide_speed, 1, 1e6,
                                     "How fast the console slides. 200: one screen per second.");
  scale_ = variables.add_int("scr_conscale", defaults.scale, 0, 64,
                             "Console character size. 0 picks a size that fits the window.");
  opacity_ = variables.add_float("scr_conalpha", static_cast<double>(defaults.opacity), 0, 1,
                                 "Opacity of the console during a game.");
  high_contrast_ = variables.add_bool("con_highcontrast", defaults.high_contrast,
                                      "Shows the console, messages and menus in white on black.");
  text_size_ =
      variables.add_float("scr_textsize", static_cast<double>(defaults.text_size), 0.5, 4,
                          "Size of all text: menus, HUD, messages and console. 1 (100%) picks a size "
                          "that fits the window.");
}

ConsoleSettings ConsoleVariables::read(const command::Variables& variables) const {
  ConsoleSettings settings;
  settings.notify_time_s = variables.float_value(notify_time_);
  settings.notify_rows = static_cast<int>(variables.int_value(notify_rows_));
  settings.slide_speed = variables.float_value(slide_speed_);
  settings.scale = static_cast<int>(variables.int_value(scale_));
  settings.opacity = static_cast<float>(variables.float_value(opacity_));
  settings.high_contrast = variables.bool_value(high_contrast_);
  settings.text_size = static_cast<float>(variables.float_value(text_size_));
  return settings;
}

}  // namespace temblor::client
