// Robustness: menus with hostile content, at any size, with any input.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "client/menu/lettering.h"
#include "client/menu/menu_driver.h"
#include "command/text.h"
#include "render/renderer.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::client {
namespace {

using platform::Key;
using test::MenuDriver;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr MenuDriver::Size kSizes[] = {{1, 1},     {39, 500},   {64, 9},     {100, 50},    {320, 200},
                                       {640, 480}, {400, 1600}, {1600, 240}, {1920, 1080}, {3840, 2160}};

MenuContent hostile_content() {
  const std::string long_title(1000, 'x');
  const std::string words = "a title of many words, " + std::string(500, ' ') + "and spaces";
  const std::string control = "\n\t\x01\x0b\x0d\x7f\x80\xff;\"quit\"\r//$";
  MenuContent content = MenuDriver::some_content();
  content.levels = [=] {
    std::vector<MenuLevel> levels = {
        {"", ""}, {"", long_title}, {long_title, ""}, {control, control}, {"words", words}};
    for (int i = 0; i < 10000; ++i) levels.push_back({fmt::format("level{}", i), control});
    return levels;
  };
  content.episodes = [=] { return std::vector<MenuEpisode>{{long_title, control}, {"", ""}}; };
  content.saves = [=] {
    return std::vector<MenuSave>{
        {control, control, long_title, long_title, -7, std::numeric_limits<double>::quiet_NaN(), -5, -7},
        {"", "", "", "", 1 << 30, 1e300, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()},
        {"s0", words, words, words, 3, -1e300, 0, 0}};
  };
  content.demos = [=] { return std::vector<MenuDemo>{{control, long_title}, {"", words}}; };
  content.game_folders = [=] { return std::vector<MenuGameFolder>{{long_title, control, true}}; };
  content.game_data = [=] {
    return std::vector<MenuGameData>{{control, long_title, words, true}, {"", "", "", true}};
  };
  content.servers = [=] {
    return std::vector<MenuServer>{{control, long_title, long_title, -1, 999999999, -5},
                                   {"", "", "", 0, 0, 0}};
  };
  content.display_sizes = [](int) {
    return std::vector<platform::PixelSize>{{0, 0}, {-5, 7}, {1 << 30, 1 << 30}};
  };
  content.displays = [] { return 1000; };
  content.unsaved = [=] { return words + '\n' + long_title; };
  content.find_keys = [](std::string_view) {
    std::vector<Key> keys;
    for (int i = 0; i < 300; ++i) keys.push_back(Key{static_cast<std::uint16_t>(i)});
    return keys;
  };
  content.help_text = [=] { return control + words + long_title; };
  return content;
}

// Draws with the renderer, which CHECKs that parts are inside their pictures. No text may leave the frame.
void expect_drawable(MenuDriver& hand, const MenuDriver::Size& size) {
  static const render::Renderer painter({}, {});
  hand.resize(size);
  render::FrameBuffer frame(size.width, size.height, render::PixelFormat::kIndexed);
  render::FrameStats stats;
  const render::DrawList& list = hand.draw();
  painter.draw_overlay(list, frame, stats);
  for (const render::DrawCommand& command : list.commands)
    if (command.picture == &test::no_pictures().characters()) {
      EXPECT_TRUE(command.area.x >= 0 && command.area.x + command.area.width <= size.width &&
                  command.area.y >= 0 && command.area.y + command.area.height <= size.height)
          << command.area.x << ',' << command.area.y << " in " << size.width << 'x' << size.height;
    }
}

// Whether letters overlap; knobs and carets may.
bool letters_overlap(const render::DrawList& list) {
  std::vector<const render::DrawCommand*> letters;
  for (const render::DrawCommand& command : list.commands) {
    const int code = command.part_y / 8 * 16 + command.part_x / 8;
    const bool is_knob = code == 0x83 || code == 11;
    if (command.picture == &test::no_pictures().characters() && !is_knob) letters.push_back(&command);
  }
  for (std::size_t i = 0; i < letters.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const render::ScreenRect &a = letters[i]->area, &b = letters[j]->area;
      if (a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height)
        return true;
    }
  return false;
}

TEST(MenuWithstands, AnyPageFitsAnyFrame) {
  const std::vector<const char*> text_sizes =
      test::kQuick ? std::vector{"0.5", "4"} : std::vector{"0.5", "1", "2", "4"};
  for (const bool hostile : {false, true})
    for (const MenuPage page : test::all_pages()) {
      MenuDriver hand(hostile ? hostile_content() : MenuDriver::some_content());
      hand.menu().open(page);
      for (const MenuDriver::Size& size : kSizes) {
        SCOPED_TRACE(testing::Message()
                     << "page " << static_cast<int>(page) << ", " << size.width << 'x' << size.height);
        for (const char* text_size : text_sizes) {
          ASSERT_TRUE(hand.variables().set("scr_textsize", text_size).ok());
          expect_drawable(hand, size);
          EXPECT_FALSE(letters_overlap(hand.draw()));
        }
      }
    }
}

TEST(MenuWithstands, WorksInAFrameOfOnePixel) {
  MenuDriver hand(MenuDriver::some_content(), {1, 1});
  hand.menu().open();
  EXPECT_THAT(hand.draw().commands, IsEmpty());
  hand.point(0, 0);
  hand.press(Key::kMouse1);
  hand.press(Key::kDownArrow);
  hand.press(Key::kEnter);
  hand.resize({640, 480});
  EXPECT_THAT(hand.all_text(), ::testing::HasSubstr("Join")) << "it still works in a larger frame";
}

TEST(MenuWithstands, HostileNamesStayOneWordOfOneCommand) {
  MenuDriver hand(hostile_content());
  const auto expect_one = [&](const char* command) {
    for (const std::string& line : hand.commands())
      if (line.starts_with(command)) {
        EXPECT_EQ(command::command_length(line), line.size()) << line;
        EXPECT_THAT(command::split_words(line), SizeIs(2)) << line;
      }
  };
  hand.menu().open(MenuPage::kDemos);
  hand.press(Key::kEnter);
  ASSERT_TRUE(hand.choose("Yes"));
  expect_one("playdemo");
  hand.menu().open(MenuPage::kLoad);
  hand.press(Key::kEnter);
  expect_one("load");
}

TEST(MenuWithstands, FiltersAndScrollsTenThousandLevels) {
  MenuDriver hand(hostile_content(), {320, 200});
  hand.menu().open(MenuPage::kLevels);
  hand.type("level9876");
  EXPECT_THAT(hand.selected(), ::testing::StartsWith("level9876"));
  hand.press(Key::kEscape);
  hand.press(Key::kEnd);
  EXPECT_THAT(hand.selected(), ::testing::StartsWith("level9999"));
  // The scroll bar is right of the list: pressed halfway down, it scrolls halfway.
  hand.draw();
  bool found = false;
  for (int x = 100; x < 320 && !found; ++x) {
    hand.press(Key::kEnd);
    hand.draw();
    hand.point(x, 110);
    hand.hold(Key::kMouse1, true);
    hand.hold(Key::kMouse1, false);
    if (!hand.menu().is_open() || hand.all_text().find("Are you sure") != std::string::npos) {
      hand.menu().close();
      hand.menu().open(MenuPage::kLevels);
      hand.draw();
      continue;
    }
    const std::string row = hand.selected();
    found = row.starts_with("level4") || row.starts_with("level5");
  }
  EXPECT_TRUE(found);
}

platform::InputEvent random_event(test::Random& random, double time_s) {
  static constexpr Key kKeys[] = {
      Key::kUpArrow,  Key::kDownArrow, Key::kLeftArrow, Key::kRightArrow, Key::kEnter,     Key::kEnter,
      Key::kEscape,   Key::kBackspace, Key::kDelete,    Key::kHome,       Key::kEnd,       Key::kPageUp,
      Key::kPageDown, Key::kMouse1,    Key::kMouse2,    Key::kWheelUp,    Key::kWheelDown, Key::kPadA,
      Key::kPadB,     Key::kPadX,      Key::kPadStart,  Key::kPadUp,      Key::kPadDown,   Key::kTab,
      Key::kCtrl,     Key{'v'},        Key{'y'}};
  switch (random.below(8)) {
    case 0:
      return {time_s, platform::PointerMoved{static_cast<float>(random.uniform(-0.5, 1.5)),
                                             static_cast<float>(random.uniform(-0.5, 1.5))}};
    case 1:
      return {time_s, platform::PadAxisMoved{static_cast<platform::PadAxis>(random.below(4)),
                                             static_cast<float>(random.uniform(-1, 1))}};
    case 2:
      return {time_s, platform::TextTyped{std::string(1, static_cast<char>(random.bits()))}};
    case 3:
      if (random.chance(0.1)) return {time_s, platform::FocusChanged{random.chance(0.5)}};
      [[fallthrough]];
    default: {
      const Key key = random.chance(0.9) ? kKeys[random.below(std::size(kKeys))]
                                         : Key{static_cast<std::uint16_t>(random.below(platform::kKeys))};
      return {time_s, platform::KeyChange{key, random.chance(0.8), random.chance(0.2)}};
    }
  }
}

TEST(MenuWithstands, SurvivesAnyInput) {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::effort(40, 6)); ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    MenuContent content = random.chance(0.3) ? hostile_content() : MenuDriver::some_content();
    if (random.chance(0.1)) content = {};
    content.clipboard = [] { return std::string("\n\x7f pasted \"text\""); };
    MenuDriver hand(content, {320, 200});
    for (int i = 0; i < 1500; ++i) {
      if (!hand.menu().is_open())
        hand.menu().open(static_cast<MenuPage>(random.below(static_cast<std::size_t>(MenuPage::kCount))));
      hand.wait(random.uniform(0, 0.2));
      hand.menu().handle(random_event(random, hand.time_s()));
      if (random.chance(0.02)) hand.menu().refresh();
      if (random.chance(0.02))
        hand.resize({static_cast<int>(1 + random.below(900)), static_cast<int>(1 + random.below(600))});
      if (random.chance(0.5)) hand.draw();
      hand.commands();
      hand.sounds();
    }
    for (int i = 0; i < 60 && hand.menu().is_open(); ++i) hand.press(Key::kEscape);
    EXPECT_FALSE(hand.menu().is_open()) << "enough Escapes close the menu";
  }
}

TEST(MenuWithstands, SurvivesNanAndInfinityFromThePointer) {
  MenuDriver hand;
  hand.menu().open(MenuPage::kSound);
  hand.draw();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kInf = std::numeric_limits<float>::infinity();
  for (const float bad : {kNan, kInf, -kInf, 1e30f}) {
    hand.menu().handle({0, platform::PointerMoved{bad, bad}});
    hand.press(Key::kMouse1);
    hand.push_stick(bad, bad);
    hand.draw();
  }
  EXPECT_TRUE(hand.menu().is_open());
}

TEST(Lettering, BreaksLinesBetweenWords) {
  EXPECT_THAT(wrap("one two three", 7), ElementsAre("one two", "three"));
  EXPECT_THAT(wrap("one two three", 8), ElementsAre("one two", "three"));
  EXPECT_THAT(wrap("onetwothree", 4), ElementsAre("onet", "woth", "ree"));
  EXPECT_THAT(wrap("a\n\nb\n", 4), ElementsAre("a", "", "b"));
  EXPECT_THAT(wrap("one two three four", 7, 2), ElementsAre("one two", "three.."));
  EXPECT_THAT(wrap("one\ntwo\nthree", 7, 2), ElementsAre("one", "two t.."));
  EXPECT_THAT(wrap("", 7), IsEmpty());
}

TEST(Lettering, ReplacesSymbolsAndTruncates) {
  EXPECT_EQ(to_printable("a\nb\x01\x12\x8d\xe1"), "a b \x12 \xe1");
  EXPECT_EQ(truncate("abcdef", 6), "abcdef");
  EXPECT_EQ(truncate("abcdefg", 6), "abcd..");
  EXPECT_EQ(truncate("abc", 2), "ab");
  EXPECT_TRUE(contains_text("The Slipgate", "slip") && contains_text(to_second_color("Slip"), "SLIP"));
  EXPECT_FALSE(contains_text("Slip", "gate"));
}

}  // namespace
}  // namespace temblor::client
