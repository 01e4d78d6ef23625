#include "client/menu/menu_driver.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "client/input/input_variables.h"
#include "client/view/client_variables.h"

namespace temblor::test {
namespace {

using client::MenuPage;
using platform::Key;

constexpr char kCursor = 13;

command::Variables some_variables() {
  command::Variables variables;
  register_menu_variables(variables);
  return variables;
}

char drawn_letter(const render::DrawCommand& command) {
  return static_cast<char>((command.part_y / 8 * 16 + command.part_x / 8) & 127);
}

}  // namespace

void register_menu_variables(command::Variables& io_variables) {
  command::Variables& v = io_variables;
  const client::InputVariables input(v);
  const client::ClientVariables presentation(v);
  static constexpr std::string_view kColors[] = {"rgb", "indexed"},
                                    kModes[] = {"window", "borderless", "fullscreen"},
                                    kMips[] = {"footprint", "stock"}, kPerspectives[] = {"exact", "every16"};
  for (const char* name : {"vid_vsync", "scr_showlatency", "host_parallel", "vid_render_scale_auto",
                           "scr_showfps", "r_colored_light", "r_alias_snap", "con_highcontrast", "coop"})
    v.add_bool(name, false, fmt::format("What {} does, said in one sentence that may be rather long.", name));
  for (const char* name : {"vid_render_scale", "joy_rumble"})
    v.add_float(name, 0.5, 0, 1, fmt::format("Strength of {}.", name));
  v.add_float("gamma", 1, 0.25, 4, "Gamma correction. Values below 1 are brighter.");
  v.add_float("contrast", 1, 0.25, 4, "Contrast of the picture.");
  v.add_float("brightness", 0, -1, 1, "Added to the picture.");
  v.add_float("fov", 90, 10, 170, "Field of view in degrees.");
  v.add_float("zoom_fov", 30, 5, 170, "Field of view in degrees while +zoom is held.");
  v.add_float("scr_textsize", 1, 0.5, 4, "Text size of menus, console, and messages.");
  v.add_float("host_maxfps", 0, 0, 1000, "Frame rate limit. 0: no limit.");
  v.add_float("vid_target_fps", 60, 10, 1000, "Frame rate that dynamic resolution keeps.");
  v.add_float("skill", 1, 0, 3, "Skill of the next level: 0 easy, 1 normal, 2 hard, 3 nightmare.");
  v.add_float("timelimit", 0, 0, 1000000, "Length of a deathmatch in minutes.");
  v.add_choice("vid_mode", kModes, "A window or the full screen.");
  v.add_choice("vid_color", kColors, "Colors of the picture.");
  v.add_choice("r_mip_rule", kMips, "Choice of mip levels.");
  v.add_choice("r_perspective", kPerspectives, "Perspective of textures.");
  v.add_int("vid_width", 1280, 1, 16384, "Size of the window in pixels.");
  v.add_int("vid_height", 720, 1, 16384, "Size of the window in pixels.");
  v.add_int("vid_display", 0, 0, 15, "Number of the display.");
  v.add_int("deathmatch", 0, 0, 255, "Deathmatch.");
  v.add_int("teamplay", 0, 0, 255, "Whether players of one team hurt each other.");
  v.add_int("fraglimit", 0, 0, 1000000, "Kills that end a deathmatch.");
  v.add_int("capturelimit", 0, 0, 1000000, "Captures that end the game.");
  v.add_int("bot_fill", 0, 0, 16, "Bots fill the game up to this many players.");
  v.add_int("bot_skill", 1, 0, 3, "Skill of the bots.");
  v.add_int("topcolor", 4, 0, 13, "Color of the shirt.");
  v.add_int("bottomcolor", 13, 0, 13, "Color of the trousers.");
  v.add_int("port", 26000, 0, 65535, "Of games that others may join.");
  v.add_text("name", "player", "What others call you.");
  v.add_text("hostname", "Temblor", "The server's name in lists.");
}

std::vector<MenuPage> all_pages() {
  std::vector<MenuPage> pages;
  for (int i = 0; i < static_cast<int>(MenuPage::kCount); ++i)
    if (static_cast<MenuPage>(i) != MenuPage::kQuit) pages.push_back(static_cast<MenuPage>(i));
  return pages;
}

MenuDriver::MenuDriver(client::MenuContent content, Size size)
    : variables_(some_variables()), menu_(variables_, no_pictures(), std::move(content)), size_(size) {}

client::MenuContent MenuDriver::some_content() {
  client::MenuContent content;
  content.levels = [] {
    std::vector<client::MenuLevel> levels = {{"start", "Introduction"}};
    for (int i = 1; i <= 30; ++i)
      levels.push_back({fmt::format("e1m{}", i), fmt::format("The Level of Number {}", i)});
    return levels;
  };
  content.episodes = [] {
    return std::vector<client::MenuEpisode>{{"Episode 1", "e1m1", "The Level of Number 1"},
                                            {"Episode 2", "e1m9", "The Level of Number 9"}};
  };
  content.saves = [] {
    return std::vector<client::MenuSave>{
        {.name = "s0",
         .title = "Before the bridge",
         .level_title = "The Level of Number 1",
         .date = "2026-11-26 07:02",
         .skill = 2,
         .time_s = 754,
         .kills = 12,
         .monsters = 30},
        {.name = "quick", .title = "", .level_title = "Introduction", .date = "", .time_s = 3}};
  };
  content.demos = [] {
    return std::vector<client::MenuDemo>{{"demo1", "The Level of Number 3"}, {"demo2", ""}};
  };
  content.game_folders = [] {
    return std::vector<client::MenuGameFolder>{{"id1", "The game", true}, {"mymod", "A mod", false}};
  };
  content.servers = [] {
    return std::vector<client::MenuServer>{{"10.0.0.1:26000", "Attic", "e1m1", 3, 8, 21}};
  };
  content.search_servers = [] {};
  content.displays = [] { return 2; };
  content.display_sizes = [](int display) {
    return display == 0 ? std::vector<platform::PixelSize>{{1920, 1080}, {1280, 720}}
                        : std::vector<platform::PixelSize>{{2560, 1440}, {800, 600}};
  };
  content.game_runs = [] { return true; };
  content.can_save = [] { return true; };
  content.find_keys = [](std::string_view commands) {
    return commands == "+forward" ? std::vector<Key>{Key{'w'}, Key::kUpArrow} : std::vector<Key>{};
  };
  content.help_text = [] {
    std::string text = "# Moving\nWASD, and the mouse.\n";
    for (int i = 1; i <= 60; ++i) text += fmt::format("Line {}\n", i);
    return text;
  };
  return content;
}

void MenuDriver::hold(Key key, bool down) {
  menu_.handle({time_s_, platform::KeyChange{key, down, false}});
}

void MenuDriver::press(Key key) {
  hold(key, true);
  hold(key, false);
}

void MenuDriver::push_stick(float right, float down) {
  menu_.handle({time_s_, platform::PadAxisMoved{platform::PadAxis::kLeftX, right}});
  menu_.handle({time_s_, platform::PadAxisMoved{platform::PadAxis::kLeftY, down}});
}

void MenuDriver::type(std::string_view text) {
  for (const char c : text) {
    hold(Key{static_cast<std::uint16_t>(c)}, true);
    if (menu_.wants_text()) menu_.handle({time_s_, platform::TextTyped{std::string(1, c)}});
    hold(Key{static_cast<std::uint16_t>(c)}, false);
  }
}

void MenuDriver::point(double x_px, double y_px) {
  menu_.handle({time_s_, platform::PointerMoved{static_cast<float>(x_px / size_.width),
                                                static_cast<float>(y_px / size_.height)}});
}

const render::DrawList& MenuDriver::draw() {
  list_.clear();
  menu_.draw(size_.width, size_.height, time_s_, list_);
  return list_;
}

std::vector<WrittenRow> MenuDriver::read() {
  std::map<int, std::map<int, const render::DrawCommand*>> lines;
  for (const render::DrawCommand& command : draw().commands)
    if (command.picture == &no_pictures().characters()) lines[command.area.y][command.area.x] = &command;
  std::vector<WrittenRow> rows;
  for (const auto& [y, line] : lines) {
    WrittenRow row{{}, line.begin()->first, y, 0, 0, false};
    for (const auto& [x, command] : line) {
      const char letter = drawn_letter(*command);
      if (letter == kCursor) {
        row.selected = true;
        continue;
      }
      if (!row.text.empty() && x > row.right_px) row.text += ' ';
      row.text += letter;
      row.right_px = x + command->area.width;
      row.bottom_px = y + command->area.height;
    }
    rows.push_back(row);
  }
  return rows;
}

std::string MenuDriver::all_text() {
  std::string text;
  for (const WrittenRow& row : read()) text += row.text + '\n';
  return text;
}

std::string MenuDriver::selected() {
  for (const WrittenRow& row : read())
    if (row.selected) return row.text;
  return {};
}

const std::vector<std::string>& MenuDriver::commands() {
  commands_ = menu_.take_commands();
  return commands_;
}

std::string MenuDriver::sounds() {
  std::string names;
  for (const std::string& name : menu_.take_sounds()) names += name + ' ';
  return names;
}

void MenuDriver::step_down(Device device) {
  switch (device) {
    case Device::kGamepad:
      return press(Key::kPadDown);
    case Device::kStick:
      push_stick(0.1f, 0.9f);
      return push_stick(0, 0);
    case Device::kKeyboard:
    case Device::kMouse:
      return press(Key::kDownArrow);
  }
}

bool MenuDriver::point_at_row(std::string_view text) {
  for (int turns = 0; turns < 200; ++turns) {
    const std::vector<WrittenRow> rows = read();
    for (const WrittenRow& row : rows)
      if (row.text.starts_with(text)) {
        point(row.x_px + 12, (row.y_px + row.bottom_px) / 2.0);
        return selected().starts_with(text);
      }
    press(Key::kWheelDown);
    const std::string before = all_text();
    if (before == all_text() && turns > 100) return false;
  }
  return false;
}

bool MenuDriver::go_to(std::string_view text, Device device) {
  if (device == Device::kMouse) return point_at_row(text);
  constexpr int kMaxRows = 200;
  for (int i = 0; i < kMaxRows; ++i) {
    if (selected().starts_with(text)) return true;
    step_down(device);
  }
  return false;
}

bool MenuDriver::choose(std::string_view text, Device device) {
  if (!go_to(text, device)) return false;
  press(device == Device::kKeyboard ? Key::kEnter : device == Device::kMouse ? Key::kMouse1 : Key::kPadA);
  return true;
}

void MenuDriver::go_back(Device device) {
  press(device == Device::kKeyboard ? Key::kEscape : device == Device::kMouse ? Key::kMouse2 : Key::kPadB);
}

}  // namespace temblor::test
