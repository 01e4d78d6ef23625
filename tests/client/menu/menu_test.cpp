// Walks through the menus: what the pages show, what the player chooses, and which commands result.
#include "client/menu/menu.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "client/menu/menu_driver.h"

namespace temblor::client {
namespace {

using platform::Key;
using test::Device;
using test::MenuDriver;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::StartsWith;

constexpr Device kDevices[] = {Device::kKeyboard, Device::kGamepad, Device::kStick, Device::kMouse};
constexpr MenuDriver::Size kSmallest{320, 200};

struct Path {
  std::vector<const char*> rows;  // chosen one after the other from the main page
  const char* target;             // a text on the page that they lead to
};
const std::vector<Path>& all_paths() {
  static const std::vector<Path> paths = {
      {{"Single player"}, "New game"},
      {{"Single player", "New game"}, "Episode 1"},
      {{"Single player", "New game", "Episode 1"}, "Nightmare"},
      {{"Single player", "Load game"}, "quick"},
      {{"Single player", "Save game"}, "New save"},
      {{"Single player", "Levels"}, "e1m1"},
      {{"Multiplayer"}, "Join"},
      {{"Multiplayer", "Join"}, "Attic"},
      {{"Multiplayer", "Host"}, "Start game"},
      {{"Multiplayer", "Host", "Level"}, "e1m2"},
      {{"Multiplayer", "Player"}, "Shirt"},
      {{"Options"}, "Accessibility"},
      {{"Options", "Video"}, "Gamma"},
      {{"Options", "Screen"}, "Crosshair"},
      {{"Options", "Sound"}, "Music volume"},
      {{"Options", "Controls"}, "Invert mouse"},
      {{"Options", "Keys"}, "Move forward"},
      {{"Options", "Accessibility"}, "Text size"},
      {{"Levels"}, "start"},
      {{"Mods"}, "mymod"},
      {{"Demos"}, "demo2"},
      {{"Help"}, "WASD"},
  };
  return paths;
}

TEST(Menu, EveryDeviceReachesEveryPageAndReturns) {
  for (const Device device : kDevices)
    for (const MenuDriver::Size size : {kSmallest, MenuDriver::Size{1920, 1080}}) {
      MenuDriver hand(MenuDriver::some_content(), size);
      hand.menu().open();
      for (const Path& path : all_paths()) {
        SCOPED_TRACE(testing::Message()
                     << path.target << ", device " << static_cast<int>(device) << ", " << size.width);
        for (const char* row : path.rows) ASSERT_TRUE(hand.choose(row, device)) << row << hand.all_text();
        EXPECT_THAT(hand.all_text(), HasSubstr(path.target));
        for (std::size_t i = 0; i < path.rows.size(); ++i) hand.go_back(device);
        EXPECT_THAT(hand.all_text(), HasSubstr("Single player"));
        EXPECT_THAT(hand.commands(), IsEmpty());
      }
      hand.go_back(device);
      EXPECT_FALSE(hand.menu().is_open());
    }
}

// The rows that the cursor reaches, by the start of their label.
std::set<std::string> collect_rows(MenuDriver& hand, const std::function<void()>& step) {
  std::set<std::string> rows;
  for (int i = 0; i < 120; ++i) {
    rows.insert(hand.selected().substr(0, 12));
    step();
  }
  rows.erase("");
  return rows;
}

TEST(Menu, EveryDeviceReachesEveryRow) {
  for (const MenuPage page : test::all_pages()) {
    SCOPED_TRACE(static_cast<int>(page));
    MenuDriver hand(MenuDriver::some_content(), kSmallest);
    hand.menu().open(page);
    const std::set<std::string> down = collect_rows(hand, [&] { hand.press(Key::kDownArrow); });
    const std::set<std::string> up = collect_rows(hand, [&] { hand.press(Key::kPadUp); });
    EXPECT_EQ(down, up);
    // The mouse points everywhere on the frame, and the wheel scrolls to the end.
    std::set<std::string> pointed;
    hand.press(Key::kHome);
    for (int turns_without_new_rows = 0; turns_without_new_rows < 3;) {
      const std::size_t known = pointed.size();
      for (int y = 0; y < kSmallest.height; y += 4) {
        hand.point(kSmallest.width * 3 / 8, y);
        pointed.insert(hand.selected().substr(0, 12));
      }
      turns_without_new_rows = pointed.size() == known ? turns_without_new_rows + 1 : 0;
      hand.press(Key::kWheelDown);
      hand.draw();
    }
    pointed.erase("");
    EXPECT_EQ(down, pointed);
  }
}

TEST(Menu, StartsAGameWithEpisodeAndSkill) {
  MenuDriver hand;
  hand.menu().open();
  ASSERT_TRUE(hand.choose("Single player") && hand.choose("New game"));
  EXPECT_THAT(hand.all_text(), AllOf(HasSubstr("Episode 1"), HasSubstr("The Level of Number 9")));
  ASSERT_TRUE(hand.choose("Episode 2"));
  EXPECT_THAT(hand.selected(), HasSubstr("Normal")) << "the skill of the last game";
  EXPECT_THAT(hand.all_text(), AllOf(HasSubstr("Easy"), HasSubstr("Hard"), HasSubstr("Nightmare")));
  EXPECT_THAT(hand.commands(), IsEmpty());
  ASSERT_TRUE(hand.choose("Hard"));
  EXPECT_THAT(hand.commands(), ElementsAre("skill 2", "maxplayers 1", "deathmatch 0", "coop 0", "map e1m9"));
  EXPECT_FALSE(hand.menu().is_open());
}

TEST(Menu, SelectsTheChosenSkill) {
  MenuDriver hand;
  for (const auto& [skill, label] :
       {std::pair{"0", "Easy"}, {"1.4", "Normal"}, {"2", "Hard"}, {"3", "Nightmare"}}) {
    ASSERT_TRUE(hand.variables().set("skill", skill).ok());
    hand.menu().open(MenuPage::kSkill);
    EXPECT_THAT(hand.selected(), HasSubstr(label));
  }
}

TEST(Menu, StartsInTheLevelStartWithoutEpisodes) {
  MenuContent content = MenuDriver::some_content();
  content.episodes = {};
  MenuDriver hand(content);
  hand.menu().open();
  ASSERT_TRUE(hand.choose("Single player") && hand.choose("New game") && hand.choose("Easy"));
  EXPECT_THAT(hand.commands(), IsSupersetOf({"skill 0", "map start"}));
  EXPECT_FALSE(hand.menu().is_open());
  content.levels = [] { return std::vector<MenuLevel>{{"dm1", ""}}; };
  for (const MenuPage page : {MenuPage::kNewGame, MenuPage::kSkill}) {
    MenuDriver without(content);
    without.menu().open(page);
    EXPECT_THAT(without.all_text(), AllOf(HasSubstr("dm1"), HasSubstr("Skill")))
        << "a mod without a level \"start\" shows its levels";
  }
}

// The skill of the running game does not change if the player stays in it.
TEST(Menu, AsksBeforeANewGameEndsAnother) {
  MenuContent content = MenuDriver::some_content();
  content.unsaved = [] { return std::string("You have not saved for 3 minutes."); };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kSkill);
  ASSERT_TRUE(hand.choose("Nightmare"));
  EXPECT_THAT(hand.all_text(), HasSubstr("Start a new game anyway?"));
  ASSERT_TRUE(hand.choose("No"));
  EXPECT_THAT(hand.commands(), IsEmpty());
  ASSERT_TRUE(hand.choose("Nightmare") && hand.choose("Yes"));
  EXPECT_THAT(hand.commands(), IsSupersetOf({"skill 3", "map start"}));
}

TEST(Menu, QuitsWithoutAQuestionIfNothingWouldBeLost) {
  MenuDriver hand;
  hand.menu().open();
  ASSERT_TRUE(hand.choose("Quit"));
  EXPECT_THAT(hand.commands(), ElementsAre("quit"));
  EXPECT_FALSE(hand.menu().is_open());
  hand.menu().open(MenuPage::kQuit);
  EXPECT_THAT(hand.commands(), ElementsAre("quit"));
}

TEST(Menu, LeavesTheRunningGame) {
  MenuContent content = MenuDriver::some_content();
  bool runs = true;
  content.game_runs = [&] { return runs; };
  content.unsaved = [&] { return runs ? std::string("It would end.") : std::string(); };
  MenuDriver hand(content, kSmallest);
  hand.menu().open();
  ASSERT_TRUE(hand.choose("Leave game") && hand.choose("Yes"));
  EXPECT_THAT(hand.commands(), ElementsAre("disconnect"));
  runs = false;
  hand.menu().open();
  EXPECT_FALSE(hand.go_to("Leave game"));
}

TEST(Menu, AsksBeforeProgressIsLost) {
  MenuContent content = MenuDriver::some_content();
  content.unsaved = [] { return std::string("Ten minutes of play are not saved."); };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kQuit);
  EXPECT_THAT(hand.all_text(), HasSubstr("Ten minutes of play"));
  hand.type("n");
  EXPECT_FALSE(hand.menu().is_open());
  EXPECT_THAT(hand.commands(), IsEmpty());
  hand.menu().open(MenuPage::kQuit);
  hand.type("Y");
  EXPECT_THAT(hand.commands(), ElementsAre("quit"));
  for (const char* level : {"e1m1"}) {
    hand.menu().open(MenuPage::kLevels);
    ASSERT_TRUE(hand.choose(level));
    EXPECT_THAT(hand.commands(), IsEmpty());
    hand.press(Key::kEscape);
    EXPECT_THAT(hand.selected(), StartsWith(level)) << "back on the same row";
    hand.press(Key::kEnter);
    ASSERT_TRUE(hand.choose("Yes"));
    EXPECT_THAT(hand.commands(), Contains("map e1m1"));
  }
  hand.menu().open(MenuPage::kLoad);
  ASSERT_TRUE(hand.choose("Before the bridge"));
  EXPECT_THAT(hand.commands(), ElementsAre("load s0")) << "loading needs no confirmation, as in the original";
}

TEST(Menu, IgnoresTheTextOfTheKeyThatOpenedIt) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kLevels);
  hand.menu().handle({0, platform::TextTyped{"m"}});
  EXPECT_THAT(hand.all_text(), HasSubstr("Type to filter"));
  hand.type("m");
  EXPECT_THAT(hand.all_text(), HasSubstr("Filter: m"));
}

TEST(Menu, TypingFiltersLongLists) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kLevels);
  EXPECT_THAT(hand.all_text(), HasSubstr("Type to filter 31")) << "not 32: the skill is not a level";
  hand.type("number 17");
  EXPECT_THAT(hand.selected(), StartsWith("e1m17"));
  EXPECT_THAT(hand.all_text(), HasSubstr("1 of 31"));
  EXPECT_THAT(hand.all_text(), Not(HasSubstr("start")));
  for (int i = 0; i < 9; ++i) hand.press(Key::kBackspace);
  EXPECT_THAT(hand.all_text(), HasSubstr("start"));
  hand.type("nowhere");
  EXPECT_EQ(hand.selected(), "");
  hand.press(Key::kEnter);
  EXPECT_THAT(hand.commands(), IsEmpty());
  hand.press(Key::kEscape);
  EXPECT_THAT(hand.all_text(), HasSubstr("start")) << "Escape clears the filter first";
  EXPECT_TRUE(hand.menu().is_open());
  hand.press(Key::kBackspace);
  EXPECT_FALSE(hand.menu().is_open()) << "with nothing to erase, Backspace goes back";
}

TEST(Menu, PageAndEndKeysMoveThroughLists) {
  MenuDriver hand(MenuDriver::some_content(), kSmallest);
  hand.menu().open(MenuPage::kLevels);
  hand.draw();
  hand.press(Key::kEnd);
  EXPECT_THAT(hand.selected(), StartsWith("e1m30"));
  hand.press(Key::kDownArrow);
  EXPECT_THAT(hand.selected(), StartsWith("Skill")) << "wraps around";
  hand.press(Key::kUpArrow);
  EXPECT_THAT(hand.selected(), StartsWith("e1m30"));
  hand.press(Key::kHome);
  EXPECT_THAT(hand.selected(), StartsWith("Skill"));
  hand.press(Key::kPageDown);
  EXPECT_THAT(hand.selected(), AllOf(StartsWith("e1m"), Not(StartsWith("e1m1 "))));
  for (int i = 0; i < 10; ++i) hand.press(Key::kPadRightShoulder);
  EXPECT_THAT(hand.selected(), StartsWith("e1m30")) << "paging stops at the end";
}

TEST(Menu, RepeatsHeldGamepadButtonsAndSticks) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kLevels);
  hand.press(Key::kHome);
  const auto is_at = [&](const char* row) { return hand.selected().starts_with(row); };
  hand.hold(Key::kPadDown, true);
  EXPECT_TRUE(is_at("start"));
  hand.wait(0.39);
  EXPECT_TRUE(is_at("start"));
  hand.wait(0.02);
  hand.draw();
  EXPECT_TRUE(is_at("e1m1"));
  hand.wait(0.11);
  hand.draw();
  EXPECT_TRUE(is_at("e1m2"));
  hand.wait(1000);
  hand.draw();
  EXPECT_TRUE(is_at("e1m3")) << "one step a frame, however long the frame took";
  hand.hold(Key::kPadDown, false);
  hand.wait(10);
  hand.draw();
  EXPECT_TRUE(is_at("e1m3"));
  hand.push_stick(0, -1);
  EXPECT_TRUE(is_at("e1m2"));
  hand.push_stick(0.2f, -0.5f);
  hand.push_stick(0, -1);
  EXPECT_TRUE(is_at("e1m2")) << "the stick was not released in between";
  hand.wait(0.41);
  hand.draw();
  EXPECT_TRUE(is_at("e1m1"));
  hand.menu().handle({hand.time_s(), platform::FocusChanged{false}});
  hand.wait(10);
  hand.draw();
  EXPECT_TRUE(is_at("e1m1"));
}

TEST(Menu, JoinsByAddressAndByList) {
  int searches = 0;
  MenuContent content = MenuDriver::some_content();
  content.search_servers = [&] { ++searches; };
  content.clipboard = [] { return std::string("192.168.1.5\n"); };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kMultiplayer);
  ASSERT_TRUE(hand.choose("Join"));
  EXPECT_EQ(searches, 1);
  ASSERT_TRUE(hand.choose("Refresh"));
  EXPECT_EQ(searches, 2);
  EXPECT_THAT(hand.all_text(), AllOf(HasSubstr("Attic"), HasSubstr("3/8"), HasSubstr("21ms")));
  ASSERT_TRUE(hand.choose("Attic"));
  EXPECT_THAT(hand.commands(), ElementsAre("connect 10.0.0.1:26000"));

  hand.menu().open(MenuPage::kJoin);
  ASSERT_TRUE(hand.choose("Address"));
  hand.type("quake.examplX");
  hand.press(Key::kBackspace);
  hand.type("e");
  hand.press(Key::kHome);
  hand.type("a");
  hand.press(Key::kDelete);
  hand.type("q");
  hand.press(Key::kEnter);
  EXPECT_THAT(hand.commands(), ElementsAre("connect aquake.example"));
  hand.menu().open(MenuPage::kJoin);
  EXPECT_THAT(hand.all_text(), HasSubstr("aquake.example")) << "kept";
  hand.press(Key::kDelete);
  hand.hold(Key::kCtrl, true);
  hand.press(Key{'v'});
  hand.hold(Key::kCtrl, false);
  hand.press(Key::kDownArrow);
  EXPECT_THAT(hand.commands(), IsEmpty()) << "leaving the row keeps the text but does not connect";
  ASSERT_TRUE(hand.choose("Connect"));
  EXPECT_THAT(hand.commands(), ElementsAre("connect 192.168.1.5"));
}

TEST(Menu, EscapeCancelsTextEditing) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kPlayer);
  ASSERT_TRUE(hand.choose("Name"));
  hand.type("xyz");
  hand.press(Key::kEscape);
  EXPECT_TRUE(hand.menu().is_open());
  EXPECT_EQ(hand.variables().find("name")->text, "player");
  hand.type("s");
  hand.press(Key::kEnter);
  EXPECT_EQ(hand.variables().find("name")->text, "players") << "typing starts editing";
}

TEST(Menu, TextRowsAcceptPrintableAsciiUpToTheirLimit) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kPlayer);
  ASSERT_TRUE(hand.choose("Name"));
  for (const std::string& typed : {std::string("\n"), std::string("\xc3\xa9\x01"), std::string(10000, 'x')})
    hand.menu().handle({0, platform::TextTyped{typed}});
  hand.press(Key::kEnter);
  EXPECT_EQ(hand.variables().find("name")->text, "player" + std::string(194, 'x'));
}

TEST(Menu, GamepadEditsText) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kPlayer);
  ASSERT_TRUE(hand.choose("Name", Device::kGamepad));
  for (int i = 0; i < 6; ++i) hand.press(Key::kPadX);  // "player"
  for (const Key key : {Key::kPadRight, Key::kPadUp, Key::kPadRight, Key::kPadRightShoulder, Key::kPadDown,
                        Key::kPadRight, Key::kPadDown, Key::kPadRight, Key::kPadLeft})
    hand.press(key);
  hand.press(Key::kPadA);
  EXPECT_EQ(hand.variables().find("name")->text, "bhZ") << "b; a plus eight minus one; the letter before a";
}

TEST(Menu, PlaysDemosAndSwitchesMods) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kDemos);
  ASSERT_TRUE(hand.choose("demo2"));
  EXPECT_THAT(hand.commands(), ElementsAre("playdemo demo2"));
  hand.menu().open(MenuPage::kGameFolders);
  EXPECT_THAT(hand.selected(), AllOf(StartsWith("id1"), HasSubstr("active")));
  ASSERT_TRUE(hand.choose("mymod"));
  EXPECT_THAT(hand.commands(), ElementsAre("game mymod"));
}

TEST(Menu, OffersGameDataOnlyIfThereIsAChoice) {
  MenuDriver without;
  without.menu().open(MenuPage::kOptions);
  EXPECT_FALSE(without.go_to("Game data"));
  MenuContent content = MenuDriver::some_content();
  content.game_data = [] {
    return std::vector<MenuGameData>{{"temblor", "Temblor's own game", "/usr/share/games/temblor", false},
                                     {"/my games/Quake", "Quake (Steam)", "/my games/Quake", true}};
  };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kOptions);
  ASSERT_TRUE(hand.choose("Game data"));
  EXPECT_THAT(hand.selected(), StartsWith("Quake (Steam)")) << "the game that is in use";
  ASSERT_TRUE(hand.choose("Quake (Steam)"));
  EXPECT_THAT(hand.commands(), ElementsAre("basedir \"/my games/Quake\""));
  EXPECT_FALSE(hand.menu().is_open());
}

TEST(Menu, RefreshKeepsTheSelectionAndTheEditedText) {
  std::vector<MenuServer> servers;
  MenuContent content = MenuDriver::some_content();
  content.servers = [&] { return servers; };
  MenuDriver hand(content);
  hand.menu().open(MenuPage::kJoin);
  EXPECT_THAT(hand.all_text(), HasSubstr("No servers found yet"));
  servers = {{"10.0.0.2", "Cellar", "e1m1", 0, 8, 5}};
  hand.menu().refresh();
  ASSERT_TRUE(hand.go_to("Cellar"));
  servers.insert(servers.begin(), {"10.0.0.1", "Attic", "e1m1", 0, 8, 5});
  hand.menu().refresh();
  EXPECT_THAT(hand.selected(), StartsWith("Cellar")) << "the selection stays on its server";
  servers.clear();
  hand.menu().refresh();
  EXPECT_TRUE(hand.menu().is_open());
  ASSERT_TRUE(hand.choose("Address"));
  hand.type("abc");
  servers = {{"10.0.0.1", "Attic", "e1m1", 0, 8, 5}};
  hand.menu().refresh();
  EXPECT_THAT(hand.all_text(), AllOf(HasSubstr("abc"), Not(HasSubstr("Attic"))))
      << "the list waits until editing ends";
  hand.press(Key::kDownArrow);
  EXPECT_THAT(hand.all_text(), AllOf(HasSubstr("abc"), HasSubstr("Attic")));
}

// Both pictures are beside the list, the room above the overview, and keep their proportions.
TEST(Menu, ShowsPicturesOfTheSelectedLevel) {
  const formats::Picture room{4, 2, {1, 2, 3, 4, 5, 6, 7, 8}}, overview{2, 2, {9, 10, 11, 12}};
  std::string asked_for;
  bool is_there = false;
  MenuContent content = MenuDriver::some_content();
  content.level_pictures = [&](std::string_view level) {
    asked_for = level;
    return is_there ? client::MenuLevelPictures{&room, &overview} : client::MenuLevelPictures{};
  };
  for (const MenuDriver::Size& size : {MenuDriver::Size{320, 200}, {640, 480}, {1280, 720}, {1920, 1080}}) {
    is_there = false;
    MenuDriver hand(content, size);
    hand.menu().open(MenuPage::kLevels);
    const auto drawn = [&] {
      std::vector<render::DrawCommand> pictures;
      for (const render::DrawCommand& command : hand.draw().commands)
        if (command.picture != nullptr && command.picture != &test::no_pictures().characters())
          pictures.push_back(command);
      return pictures;
    };
    EXPECT_THAT(drawn(), IsEmpty());
    is_there = true;
    ASSERT_TRUE(hand.go_to("e1m2"));
    const std::vector<render::DrawCommand> pictures = drawn();
    EXPECT_EQ(asked_for, "e1m2");
    ASSERT_EQ(pictures.size(), 2);
    EXPECT_NEAR(pictures[0].area.width, 2 * pictures[0].area.height, 2);
    EXPECT_GT(pictures[0].area.width, size.width / 4);
    EXPECT_NEAR(pictures[1].area.width, pictures[1].area.height, 1);
    EXPECT_GE(pictures[1].area.y, pictures[0].area.y + pictures[0].area.height);
    EXPECT_GT(pictures[1].area.height, size.height / 6);
    EXPECT_LT(pictures[1].area.y + pictures[1].area.height, size.height);
    const formats::Picture& shown = *pictures[0].picture;
    EXPECT_EQ(shown.pixels.front(), 1);
    EXPECT_EQ(shown.pixels[shown.width - 1], 4);
    EXPECT_EQ(shown.pixels.back(), 8);
    EXPECT_EQ(pictures[1].picture->pixels.back(), 12);
  }
}

TEST(Menu, MakesSounds) {
  MenuDriver hand;
  hand.menu().open();
  EXPECT_EQ(hand.sounds(), "misc/menu2.wav ");
  hand.press(Key::kDownArrow);
  EXPECT_EQ(hand.sounds(), "misc/menu1.wav ");
  hand.press(Key::kEnter);
  EXPECT_EQ(hand.sounds(), "misc/menu2.wav ");
  hand.menu().open(MenuPage::kSound);
  hand.sounds();
  hand.press(Key::kRightArrow);
  EXPECT_EQ(hand.sounds(), "misc/menu3.wav ");
}

TEST(Menu, ConsumesPressesAndLeavesReleasesToOthers) {
  MenuDriver hand;
  const auto is_consumed = [&](auto event) { return hand.menu().handle({0, event}); };
  EXPECT_FALSE(is_consumed(platform::KeyChange{Key{'w'}, true, false})) << "closed";
  hand.menu().open();
  EXPECT_TRUE(hand.menu().wants_text());
  EXPECT_TRUE(is_consumed(platform::KeyChange{Key{'w'}, true, false}));
  EXPECT_FALSE(is_consumed(platform::KeyChange{Key{'w'}, false, false})) << "a release reaches the game";
  EXPECT_TRUE(is_consumed(platform::TextTyped{"w"}));
  EXPECT_TRUE(is_consumed(platform::PointerMoved{0.5f, 0.5f}));
  EXPECT_TRUE(is_consumed(platform::MouseMoved{5, 5}));
  EXPECT_TRUE(is_consumed(platform::PadAxisMoved{platform::PadAxis::kRightX, 1}));
  EXPECT_FALSE(is_consumed(platform::PadAxisMoved{platform::PadAxis::kRightX, 0}));
  EXPECT_FALSE(is_consumed(platform::FocusChanged{false}));
  EXPECT_FALSE(is_consumed(platform::WindowChanged{}));
  EXPECT_FALSE(is_consumed(platform::CloseRequested{}));
  hand.menu().close();
  EXPECT_FALSE(hand.menu().is_open());
  EXPECT_FALSE(hand.menu().wants_text());
}

TEST(Menu, NoticesLinkToHelpfulPages) {
  for (const Device device : kDevices)
    for (const MenuDriver::Size& size : {kSmallest, MenuDriver::Size{1280, 720}}) {
      MenuDriver hand(MenuDriver::some_content(), size);
      hand.menu().show_notice(
          {.title = "Gone",
           .text = "The first line.\n\nAnother one that is by far too long for a single line of it.",
           .pages = {{"Other servers", MenuPage::kJoin}}});
      EXPECT_THAT(hand.all_text(),
                  AllOf(HasSubstr("Gone"), HasSubstr("The first line."), HasSubstr("of it.")));
      EXPECT_THAT(hand.selected(), HasSubstr("OK"));
      hand.point(1, 1);  // a pointer that has not moved since the menu opened selects nothing
      ASSERT_TRUE(hand.choose("Other servers", device));
      EXPECT_THAT(hand.all_text(), HasSubstr("Attic"));
      hand.go_back(device);
      ASSERT_TRUE(hand.choose("OK", device));
      EXPECT_THAT(hand.all_text(), HasSubstr("Single player")) << "the main page is below the notice";
    }
  // The newer of two notices is on top.
  MenuDriver hand;
  hand.menu().show_notice({.title = "One", .text = "first"});
  hand.menu().show_notice({.title = "Two", .text = "second"});
  ASSERT_TRUE(hand.choose("OK"));
  EXPECT_THAT(hand.all_text(), HasSubstr("first"));
}

TEST(Menu, EveryCommandOpensItsPage) {
  std::set<std::string_view> names;
  for (const MenuCommand& command : menu_commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    MenuDriver hand;
    hand.menu().open(command.page);
    EXPECT_NE(hand.menu().is_open(), command.page == MenuPage::kQuit) << command.name;
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(MenuPage::kCount));
}

}  // namespace
}  // namespace temblor::client
