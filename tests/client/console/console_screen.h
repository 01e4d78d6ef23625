// A console with everything that it needs, and its drawing read back as text.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "client/console/console_ui.h"
#include "client/no_pictures.h"
#include "command/console.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {

struct ConsoleScreen {
  ConsoleScreen() {
    variables.add_int("m_speed", 3, 0, 20, "How far the mouse turns.");
    variables.add_bool("m_filter", false, "Smooths it.");
    console.add_command("map", "map NAME starts a level.", [](command::Console::Arguments) {});
  }

  // Presses and releases the key. Returns whether the press was used.
  bool press(platform::Key key) {
    const bool taken = ui.handle({0, platform::KeyChange{key, true, false}});
    EXPECT_FALSE(ui.handle({0, platform::KeyChange{key, false, false}}));
    return taken;
  }
  bool press(char key) { return press(platform::Key{static_cast<std::uint16_t>(key)}); }
  bool with(platform::Key held, platform::Key key) {
    ui.handle({0, platform::KeyChange{held, true, false}});
    const bool taken = press(key);
    ui.handle({0, platform::KeyChange{held, false, false}});
    return taken;
  }
  bool ctrl(char key) { return with(platform::Key::kCtrl, platform::Key{static_cast<std::uint16_t>(key)}); }
  // Types like a keyboard: the key, then its text.
  void type(const std::string& text) {
    for (const char c : text) {
      press(c);
      ui.handle({0, platform::TextTyped{std::string(1, c)}});
    }
  }
  void enter(const std::string& text) {
    type(text);
    press(platform::Key::kEnter);
  }

  // Draws at the view's time.
  const render::DrawList& draw(int width = 320, int height = 200) {
    list.clear();
    ui.draw(view, width, height, list);
    return list;
  }
  // The drawing as rows of text from the top, without colors, by pixel row of the frame; '@' is the cursor.
  std::map<int, std::string> rows(int width = 320, int height = 200) {
    std::map<int, std::string> rows;
    for (const render::DrawCommand& command : draw(width, height).commands) {
      if (command.picture != &no_pictures().characters()) continue;
      const auto column = static_cast<std::size_t>(command.area.x / (8 * command.scale));
      std::string& row = rows[command.area.y];
      row.resize(std::max(row.size(), column + 1), ' ');
      const int character = (command.part_y / 8 * 16 + command.part_x / 8) % 128;
      row[column] = character == 11 ? '@' : static_cast<char>(character);
    }
    return rows;
  }
  std::vector<std::string> lines(int width = 320, int height = 200) {
    std::vector<std::string> lines;
    for (const auto& [y, row] : rows(width, height)) lines.push_back(row);
    return lines;
  }
  // Opens the console and waits until it is fully open.
  void open() {
    ui.open();
    draw();
    view.time_s += 10;
    draw();
  }
  // The input line, with '|' for the cursor.
  std::string typed_line() {
    view.time_s = 0.75;  // the cursor is not visible
    const std::map<int, std::string> shown = rows(8192, 200);
    return shown.empty() ? "" : std::prev(shown.end())->second;
  }

  command::Variables variables;
  command::Console console{
      variables, [this](std::string_view line) { ui.print_utf8(std::string(line) + "\n", view.time_s); }};
  std::string clipboard;
  client::ConsoleUi ui{{.complete = [this](std::string_view line) { return console.complete_line(line); },
                        .read_clipboard = [this] { return clipboard; },
                        .write_clipboard = [this](std::string_view text) { clipboard = text; }}};
  client::ConsoleView view{.pictures = no_pictures(), .version = "", .settings = {}};
  render::DrawList list;
};

}  // namespace temblor::test
