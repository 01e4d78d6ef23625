// A menu with invented content and all variables that it knows, driven as a player would: by keys, by a
// gamepad, or by pointing at what is to be read on the frame.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "assets/pictures.h"
#include "client/menu/menu.h"
#include "command/variables.h"

namespace temblor::test {

// As a host would register them.
void register_menu_variables(command::Variables& io_variables);

// Of a game that has no pictures.
const assets::Pictures& no_pictures();

// Pages by the commands that open them, but for quit.
std::vector<client::MenuPage> all_pages();

struct WrittenRow {
  std::string text;  // its words, one space between those that are apart
  int x_px = 0, y_px = 0, right_px = 0, bottom_px = 0;
  bool selected = false;
};

enum class Device { kKeyboard, kGamepad, kStick, kMouse };

class MenuByHand {
 public:
  struct Size {
    int width, height;
  };

  explicit MenuByHand(client::MenuContent content = some_content(), Size size = {640, 480});

  static client::MenuContent some_content();

  client::Menu& menu() { return menu_; }
  command::Variables& variables() { return variables_; }
  void resize(Size size) { size_ = size; }

  void press(platform::Key key);  // and lets it go
  void hold(platform::Key key, bool down);
  void push_stick(float right, float down);
  void type(std::string_view text);  // each letter's key as well
  void point(double x_px, double y_px);
  void wait(double seconds) { time_s_ += seconds; }
  double time_s() const { return time_s_; }

  // What is drawn now.
  const render::DrawList& draw();
  std::vector<WrittenRow> read();
  std::string all_text();
  std::string selected();                      // the text of the row that is selected
  const std::vector<std::string>& commands();  // that came since the last call
  std::string sounds();

  // To the row whose text begins so; false: there is none that can be selected.
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
