// A menu with invented content and all variables that menus show, driven like a player does: by keys, by
// gamepad, or by pointing at text on the frame.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client/menu/menu.h"
#include "client/no_pictures.h"
#include "command/variables.h"

namespace temblor::test {

// Registers the variables that a host registers.
void register_menu_variables(command::Variables& io_variables);

// All pages except quit.
std::vector<client::MenuPage> all_pages();

struct WrittenRow {
  std::string text;  // its words, separated by one space
  int x_px = 0, y_px = 0, right_px = 0, bottom_px = 0;
  bool selected = false;
};

enum class Device { kKeyboard, kGamepad, kStick, kMouse };

class MenuDriver {
 public:
  struct Size {
    int width, height;
  };

  explicit MenuDriver(client::MenuContent content = some_content(), Size size = {640, 480});

  static client::MenuContent some_content();

  client::Menu& menu() { return menu_; }
  command::Variables& variables() { return variables_; }
  void resize(Size size) { size_ = size; }

  void press(platform::Key key);  // presses and releases
  void hold(platform::Key key, bool down);
  void push_stick(float right, float down);
  void type(std::string_view text);  // sends key presses as well as text
  void point(double x_px, double y_px);
  void wait(double seconds) { time_s_ += seconds; }
  double time_s() const { return time_s_; }

  // Draws the menu and reads its text back from the draw list.
  const render::DrawList& draw();
  std::vector<WrittenRow> read();
  std::string all_text();
  std::string selected();                      // the text of the selected row
  const std::vector<std::string>& commands();  // since the last call
  std::string sounds();

  // Moves to the row whose text begins with `text`; returns false if no such row can be selected.
  bool go_to(std::string_view text, Device device = Device::kKeyboard);
  bool choose(std::string_view text, Device device = Device::kKeyboard);
  void go_back(Device device = Device::kKeyboard);

 private:
  void step_down(Device device);
  bool point_at_row(std::string_view text);

  command::Variables variables_;
  client::Menu menu_;
  Size size_;
  double time_s_ = 100;
  render::DrawList list_;
  std::vector<std::string> commands_;
};

}  // namespace temblor::test
