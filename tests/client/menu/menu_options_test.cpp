// The pages of settings: rows and their variables, and key bindings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "client/menu/menu_driver.h"

namespace temblor::client {
namespace {

using platform::Key;
using test::MenuDriver;
using test::WrittenRow;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class MenuOptions : public testing::Test {
 protected:
  const std::string& value(const char* variable) { return hand_.variables().find(variable)->text; }
  void expect_at(MenuPage page, const char* row) {
    hand_.menu().open(page);
    ASSERT_TRUE(hand_.go_to(row)) << row << '\n' << hand_.all_text();
  }
  MenuDriver hand_;
};

TEST_F(MenuOptions, SwitchesSlidersAndChoicesSetTheirVariable) {
  expect_at(MenuPage::kVideo, "Vertical sync");
  EXPECT_THAT(hand_.selected(), HasSubstr("off"));
  hand_.press(Key::kEnter);
  EXPECT_EQ(value("vid_vsync"), "1");
  EXPECT_THAT(hand_.selected(), HasSubstr("on"));
  hand_.press(Key::kLeftArrow);
  EXPECT_EQ(value("vid_vsync"), "0");

  expect_at(MenuPage::kVideo, "Color mode");
  hand_.press(Key::kPadRight);
  EXPECT_EQ(value("vid_color"), "indexed");
  hand_.press(Key::kPadRight);
  EXPECT_EQ(value("vid_color"), "rgb") << "wraps around";
  EXPECT_THAT(hand_.selected(), HasSubstr("true color")) << "shown by a name for players";

  expect_at(MenuPage::kVideo, "Field of view");
  hand_.press(Key::kRightArrow);
  EXPECT_EQ(value("fov"), "95");
  for (int i = 0; i < 40; ++i) hand_.press(Key::kRightArrow);
  EXPECT_EQ(value("fov"), "130") << "the slider's end, not the variable's limit";
  ASSERT_TRUE(hand_.variables().set("fov", "92.5").ok());
  hand_.press(Key::kLeftArrow);
  EXPECT_EQ(value("fov"), "90") << "moves to the next step down";
  ASSERT_TRUE(hand_.variables().set("fov", "92.5").ok());
  hand_.press(Key::kRightArrow);
  EXPECT_EQ(value("fov"), "95") << "moves to the next step up";
  ASSERT_TRUE(hand_.variables().set("fov", "170").ok());
  EXPECT_THAT(hand_.selected(), HasSubstr("170")) << "values outside the slider are shown as they are";

  expect_at(MenuPage::kVideo, "Frame rate limit");
  EXPECT_THAT(hand_.selected(), HasSubstr("none"));
  ASSERT_TRUE(hand_.variables().set("bgmvolume", "0.5").ok());
  expect_at(MenuPage::kSound, "Music volume");
  EXPECT_THAT(hand_.selected(), HasSubstr("50%"));
  hand_.press(Key::kRightArrow);
  EXPECT_EQ(value("bgmvolume"), "0.55");
  expect_at(MenuPage::kSound, "Combat music");
  EXPECT_THAT(hand_.selected(), HasSubstr("on"));
  hand_.press(Key::kEnter);
  EXPECT_EQ(value("bgm_layers"), "0");
  EXPECT_THAT(hand_.selected(), HasSubstr("off"));
}

TEST_F(MenuOptions, ShowHelpAndNameOfTheirVariable) {
  expect_at(MenuPage::kVideo, "Gamma");
  EXPECT_THAT(hand_.all_text(), HasSubstr("Gamma correction. Values below 1 are\nbrighter. (gamma)"));
}

TEST_F(MenuOptions, LeaveOutUnregisteredVariables) {
  command::Variables variables;
  variables.add_float("gamma", 1, 0.5, 2, "Gamma.");
  Menu menu(variables, test::no_pictures(), {});
  for (const MenuPage page : test::all_pages()) {
    menu.open(page);
    for (int i = 0; i < 100; ++i) {
      menu.handle({0, platform::KeyChange{Key::kDownArrow, true, false}});
      menu.handle({0, platform::KeyChange{Key::kRightArrow, true, false}});
    }
    render::DrawList list;
    menu.draw(320, 200, 0, list);
    EXPECT_FALSE(list.commands.empty());
    menu.close();
  }
  EXPECT_NE(variables.find("gamma")->number, 1) << "the registered one can be changed";
}

TEST_F(MenuOptions, SlidersFollowThePointer) {
  expect_at(MenuPage::kSound, "Effects volume");
  const auto line = [&] {
    for (const WrittenRow& row : hand_.read())
      if (row.text.starts_with("Effects volume")) return row;
    return WrittenRow{};
  };
  const WrittenRow row = line();
  const double y = (row.y_px + row.bottom_px) / 2.0;
  // Finds the slider by pressing from left to right: the value rises from 0 to 1.
  double first = -1, last = -1, before = -1;
  for (int x = row.x_px + 100; x < row.right_px; x += 2) {
    ASSERT_TRUE(hand_.variables().set("volume", "0.5").ok());
    hand_.point(x, y);
    hand_.press(Key::kMouse1);
    const double now = hand_.variables().find("volume")->number;
    if (now == 0) first = x;
    if (now == 1 && last < 0) last = x;
    if (first >= 0) {
      EXPECT_GE(now, before);
    }
    before = first >= 0 ? now : -1;
  }
  ASSERT_GE(first, 0);
  ASSERT_GT(last, first + 50);
  hand_.point((first + last) / 2, y);
  hand_.hold(Key::kMouse1, true);
  EXPECT_NEAR(hand_.variables().find("volume")->number, 0.5, 0.06);
  hand_.point(last + 300, y + 100);
  EXPECT_EQ(value("volume"), "1") << "past the end and off the row";
  hand_.point(0, 0);
  EXPECT_EQ(value("volume"), "0");
  hand_.hold(Key::kMouse1, false);
  hand_.point(last, y);
  EXPECT_EQ(value("volume"), "0") << "released";
  EXPECT_THAT(hand_.selected(), StartsWith("Effects volume"));
}

TEST_F(MenuOptions, DisplaySettingsTakeEffectOnApply) {
  expect_at(MenuPage::kVideo, "Resolution");
  EXPECT_THAT(hand_.selected(), HasSubstr("1280 x 720"));
  hand_.press(Key::kLeftArrow);
  EXPECT_THAT(hand_.selected(), HasSubstr("1920 x 1080"));
  ASSERT_TRUE(hand_.go_to("Display mode"));
  EXPECT_THAT(hand_.selected(), HasSubstr("window"));
  hand_.press(Key::kLeftArrow);
  EXPECT_THAT(hand_.selected(), HasSubstr("fullscreen"));
  EXPECT_EQ(value("vid_mode"), "window");
  EXPECT_EQ(value("vid_width"), "1280");
  ASSERT_TRUE(hand_.choose("Apply"));
  EXPECT_EQ(value("vid_mode"), "fullscreen");
  EXPECT_EQ(value("vid_width"), "1920");
  EXPECT_EQ(value("vid_height"), "1080");
  EXPECT_THAT(hand_.commands(), IsEmpty());
  ASSERT_TRUE(hand_.go_to("Monitor"));
  hand_.press(Key::kRightArrow);
  ASSERT_TRUE(hand_.go_to("Resolution <")) << "not the resolution scale";
  hand_.press(Key::kRightArrow);
  EXPECT_THAT(hand_.selected(), HasSubstr("2560 x 1440")) << "a resolution of the other monitor";
  hand_.press(Key::kEscape);
  expect_at(MenuPage::kVideo, "Resolution");
  EXPECT_THAT(hand_.selected(), HasSubstr("1920 x 1080")) << "choices that were not applied are forgotten";
}

TEST_F(MenuOptions, DisplayRowsFollowAResizedWindow) {
  expect_at(MenuPage::kVideo, "Resolution");
  const auto resize = [&] {
    ASSERT_TRUE(hand_.variables().set("vid_width", "1000").ok());
    ASSERT_TRUE(hand_.variables().set("vid_height", "700").ok());
    hand_.menu().handle({0, platform::WindowChanged{}});
  };
  resize();
  EXPECT_THAT(hand_.selected(), HasSubstr("1000 x 700"));
  ASSERT_TRUE(hand_.variables().set("vid_width", "1280").ok());
  hand_.press(Key::kRightArrow);
  const std::string chosen = hand_.selected();
  resize();
  EXPECT_EQ(hand_.selected(), chosen) << "a choice that the player made stays";
}

TEST_F(MenuOptions, ResetToDefaults) {
  expect_at(MenuPage::kSound, "Reset to defaults");
  hand_.press(Key::kEnter);
  EXPECT_THAT(hand_.commands(), IsEmpty());
  ASSERT_TRUE(hand_.choose("Yes"));
  EXPECT_THAT(hand_.commands(), AllOf(Contains("reset volume"), Contains("reset bgmvolume")));
  EXPECT_TRUE(hand_.menu().is_open());
}

TEST_F(MenuOptions, ShirtAndPantsColorsWrapAround) {
  expect_at(MenuPage::kPlayer, "Shirt");
  hand_.press(Key::kRightArrow);
  EXPECT_EQ(value("topcolor"), "5");
  EXPECT_EQ(value("bottomcolor"), "13");
  ASSERT_TRUE(hand_.go_to("Pants"));
  hand_.press(Key::kRightArrow);
  EXPECT_EQ(value("bottomcolor"), "0") << "there are 14 colors";
  EXPECT_EQ(value("topcolor"), "5");
}

TEST(MenuLaboratory, ChoosesATechniqueAndClosesTheMenu) {
  MenuContent content = MenuDriver::some_content();
  content.techniques = [] {
    return std::vector<MenuTechnique>{{"bsp-edges", "Edges by BSP order", "The engine.", false},
                                      {"painter", "Painter's algorithm", "From back to front.", true}};
  };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kOptions);
  ASSERT_TRUE(hand.choose("Laboratory"));
  EXPECT_EQ(hand.selected(), "Painter's algorithm") << "the one in use";
  EXPECT_THAT(hand.all_text(), HasSubstr("From back to front."));
  hand.press(Key::kUpArrow);
  hand.press(Key::kEnter);
  EXPECT_THAT(hand.commands(), ElementsAre("r_technique bsp-edges"));
  EXPECT_FALSE(hand.menu().is_open());
}

TEST_F(MenuOptions, HasNoLaboratoryWithoutTechniques) {
  hand_.menu().open(MenuPage::kOptions);
  EXPECT_THAT(hand_.all_text(), Not(HasSubstr("Laboratory")));
}

TEST_F(MenuOptions, TextSizeMakesLettersLarger) {
  hand_.resize({1920, 1080});
  hand_.menu().open(MenuPage::kAccessibility);
  const auto height = [&] {
    const WrittenRow row = hand_.read().back();
    return row.bottom_px - row.y_px;
  };
  const int before = height();
  ASSERT_TRUE(hand_.variables().set("scr_textsize", "2").ok());
  EXPECT_GT(height(), before);
  ASSERT_TRUE(hand_.variables().set("scr_textsize", "0.5").ok());
  EXPECT_LT(height(), before);
}

TEST_F(MenuOptions, HighContrastIsOneColorOnBlack) {
  hand_.menu().open(MenuPage::kKeys);
  const auto second_colors = [&] {
    const render::DrawList& list = hand_.draw();
    return std::count_if(list.commands.begin(), list.commands.end(),
                         [](const render::DrawCommand& command) { return command.part_y >= 64; });
  };
  EXPECT_GT(second_colors(), 0);
  EXPECT_LT(hand_.draw().commands.front().opacity, 1);
  ASSERT_TRUE(hand_.variables().set("con_highcontrast", "1").ok());
  EXPECT_EQ(second_colors(), 0);
  EXPECT_EQ(hand_.draw().commands.front().opacity, 1);
}

TEST(MenuKeys, TheTremorHasARowOnlyInGamesThatHaveIt) {
  for (const bool has_tremor : {false, true}) {
    client::MenuContent content = MenuDriver::some_content();
    content.has_tremor = [has_tremor] { return has_tremor; };
    MenuDriver hand(content);
    hand.menu().open(MenuPage::kKeys);
    EXPECT_EQ(hand.go_to("Tremor"), has_tremor);
  }
}

TEST_F(MenuOptions, BindAndUnbindKeys) {
  expect_at(MenuPage::kKeys, "Move forward");
  EXPECT_THAT(hand_.selected(), HasSubstr("w or UPARROW"));
  hand_.press(Key::kEnter);
  EXPECT_FALSE(hand_.menu().wants_text());
  EXPECT_THAT(hand_.all_text(), HasSubstr("press a key"));
  hand_.hold(Key{'m'}, true);
  hand_.menu().handle({0, platform::TextTyped{"m"}});
  hand_.hold(Key{'m'}, false);
  EXPECT_THAT(hand_.commands(), ElementsAre("bind m +forward"));
  EXPECT_THAT(hand_.all_text(), Not(HasSubstr("Filter:"))) << "the bound key's letter does not filter";
  hand_.press(Key::kBackspace);
  EXPECT_THAT(hand_.commands(), ElementsAre("unbind w", "unbind UPARROW"));
  ASSERT_TRUE(hand_.go_to("Next weapon"));
  const Key keys[] = {Key::kWheelDown, Key::kMouse1, Key::kMouse2, Key::kPadA, Key::kPadB,
                      Key::kUpArrow,   Key::kEnter,  Key{';'},     Key{'"'},   Key::kBackspace};
  const char* const names[] = {"MWHEELDOWN", "MOUSE1", "MOUSE2",    "ABUTTON", "BBUTTON",
                               "UPARROW",    "ENTER",  "SEMICOLON", "QUOTE",   "BACKSPACE"};
  for (std::size_t i = 0; i < std::size(keys); ++i) {
    hand_.press(Key::kPadA);
    hand_.push_stick(0, 1);  // a stick is not a button
    hand_.push_stick(0, 0);
    hand_.press(keys[i]);
    EXPECT_THAT(hand_.commands(), ElementsAre(std::string("bind ") + names[i] + " \"impulse 10\""));
    EXPECT_THAT(hand_.selected(), StartsWith("Next weapon"));
  }
  hand_.press(Key::kEnter);
  hand_.press(Key::kEscape);
  EXPECT_THAT(hand_.commands(), IsEmpty());
  EXPECT_TRUE(hand_.menu().is_open());
}

TEST_F(MenuOptions, EveryStockActionCanBeBound) {
  // The actions on the original's page, and others that players bind.
  for (const char* action :
       {"+attack",   "impulse 10", "impulse 12",    "+jump",       "+forward",    "+back",
        "+left",     "+right",     "+speed",        "+moveleft",   "+moveright",  "+strafe",
        "+lookup",   "+lookdown",  "centerview",    "+mlook",      "+klook",      "+moveup",
        "+movedown", "impulse 1",  "impulse 8",     "+showscores", "messagemode", "messagemode2",
        "pause",     "screenshot", "toggleconsole", "save quick",  "load quick",  "+zoom"}) {
    std::string asked_for;
    MenuContent content;
    content.find_keys = [&](std::string_view commands) {
      return commands == action ? std::vector<Key>{Key::kF12} : std::vector<Key>{};
    };
    MenuDriver hand(content);
    hand.menu().open(MenuPage::kKeys);
    bool found = false;
    for (int i = 0; i < 60 && !found; ++i) {
      found = hand.selected().ends_with("F12");
      hand.press(Key::kDownArrow);
    }
    EXPECT_TRUE(found) << action;
  }
}

}  // namespace
}  // namespace temblor::client
