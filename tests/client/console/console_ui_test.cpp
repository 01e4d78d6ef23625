// Tests the effects of keys on the console.
#include "client/console/console_ui.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "client/console/console_screen.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::client {
namespace {

using platform::Key;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class ConsoleUiTest : public ::testing::Test, protected test::ConsoleScreen {};

TEST_F(ConsoleUiTest, UsesNothingWhileClosed) {
  EXPECT_FALSE(press('a') || press(Key::kEnter) || press(Key::kTab) || press(Key::kEscape) ||
               press(Key::kMouse1));
  EXPECT_FALSE(ui.handle({0, platform::TextTyped{"a"}}));
  EXPECT_FALSE(ui.takes_text());
  EXPECT_THAT(ui.take_commands(), IsEmpty());
}

TEST_F(ConsoleUiTest, LinesAreEnteredAndShown) {
  open();
  EXPECT_TRUE(ui.takes_text());
  enter("map start");
  enter("/god");
  enter("\\fly");
  enter("// a comment");
  enter("");
  EXPECT_THAT(ui.take_commands(), ElementsAre("map start", "god", "fly", "// a comment"));
  EXPECT_THAT(ui.take_commands(), IsEmpty());
  EXPECT_EQ(ui.text(), "]map start\n]/god\n]\\fly\n]// a comment\n]\n");
}

TEST_F(ConsoleUiTest, TheKeyThatOpensItTypesNothing) {
  EXPECT_FALSE(press('`'));
  ui.toggle();  // the host does this on that key
  ui.handle({0, platform::TextTyped{"`"}});
  type("god");
  EXPECT_TRUE(press('`')) << "and closes it again";
  EXPECT_FALSE(ui.is_open());
  EXPECT_FALSE(ui.handle({0, platform::TextTyped{"`"}}));
  ui.toggle();
  press(Key::kEnter);
  EXPECT_THAT(ui.take_commands(), ElementsAre("god")) << "the typed text stays";
}

TEST_F(ConsoleUiTest, EscapeClosesItOnlyOverAGame) {
  open();
  EXPECT_TRUE(press(Key::kEscape));
  EXPECT_FALSE(ui.is_open());
  view.game_runs = false;
  open();
  EXPECT_FALSE(press(Key::kEscape));
  EXPECT_FALSE(press('`'));
  EXPECT_TRUE(ui.is_open());
  ui.handle({0, platform::TextTyped{"`"}});
  press(Key::kEnter);
  EXPECT_THAT(ui.take_commands(), IsEmpty());
}

TEST_F(ConsoleUiTest, UsesItsEventsAndLeavesOthers) {
  open();
  for (const Key key : {Key{'w'}, Key::kSpace, Key::kShift, Key::kCtrl, Key::kUpArrow, Key::kPageUp,
                        Key::kWheelUp, Key::kMouse1, Key::kBackspace, Key::kKeypad5, Key::kHome})
    EXPECT_TRUE(press(key)) << static_cast<int>(key);
  for (const Key key : {Key::kF12, Key::kPrintScreen, Key::kPadA, Key::kPause})
    EXPECT_FALSE(press(key)) << static_cast<int>(key);
  EXPECT_FALSE(ui.handle({0, platform::MouseMoved{1, 1}}));
  EXPECT_FALSE(ui.handle({0, platform::CloseRequested{}}));
}

TEST_F(ConsoleUiTest, KeysEditTheLine) {
  open();
  type("bind x jump");
  press(Key::kHome);
  type("un");
  EXPECT_THAT(typed_line(), EndsWith("]unbind x jump"));
  with(Key::kCtrl, Key::kRightArrow);
  press(Key::kDelete);
  press(Key::kDelete);
  EXPECT_THAT(typed_line(), EndsWith("]unbind jump"));
  press(Key::kEnd);
  with(Key::kCtrl, Key::kBackspace);
  press(Key::kBackspace);
  EXPECT_THAT(typed_line(), EndsWith("]unbind"));
  ctrl('u');
  EXPECT_THAT(typed_line(), EndsWith("]"));
}

TEST_F(ConsoleUiTest, HeldKeysAreForgottenWithoutFocus) {
  open();
  type("a bc");
  ui.handle({0, platform::KeyChange{Key::kCtrl, true, false}});
  ui.handle({0, platform::FocusChanged{false}});
  press(Key::kBackspace);
  EXPECT_THAT(typed_line(), EndsWith("]a b"));
}

TEST_F(ConsoleUiTest, CopiesAndPastes) {
  open();
  type("god");
  ctrl('c');
  EXPECT_EQ(clipboard, "god");
  clipboard = "; map start\r\nnoclip\n\n";
  ctrl('v');
  press(Key::kEnter);
  EXPECT_THAT(ui.take_commands(), ElementsAre("god; map start;noclip"));
  type("x");
  ctrl('x');
  with(Key::kShift, Key::kInsert);
  press(Key::kEnter);
  EXPECT_THAT(ui.take_commands(), ElementsAre("x"));
}

TEST_F(ConsoleUiTest, AMegabyteOnTheClipboardIsLimited) {
  open();
  clipboard = std::string(1'000'000, 'x');
  ctrl('v');
  EXPECT_THAT(ui.text(), AllOf(HasSubstr("dropped"), HasSubstr("1000000")));
  press(Key::kEnter);
  EXPECT_EQ(ui.take_commands().at(0), std::string(EditLine::kMaxBytes, 'x'));
}

TEST_F(ConsoleUiTest, WithoutAClipboardNothingHappens) {
  ConsoleUi bare{{}};
  bare.open();
  for (const char key : {'v', 'c', 'x'}) {
    bare.handle({0, platform::KeyChange{Key::kCtrl, true, false}});
    EXPECT_TRUE(bare.handle({0, platform::KeyChange{Key{static_cast<std::uint16_t>(key)}, true, false}}));
  }
  EXPECT_TRUE(bare.handle({0, platform::KeyChange{Key::kTab, true, false}}));
}

TEST_F(ConsoleUiTest, ArrowsStepThroughTheHistory) {
  open();
  enter("one");
  enter("two");
  type("dra");
  press(Key::kUpArrow);
  press(Key::kUpArrow);
  EXPECT_THAT(typed_line(), EndsWith("]one"));
  press(Key::kUpArrow);
  EXPECT_THAT(typed_line(), EndsWith("]one"));
  press(Key::kDownArrow);
  press(Key::kDownArrow);
  EXPECT_THAT(typed_line(), EndsWith("]dra"));
  EXPECT_EQ(ui.history_text(), "one\ntwo\n");
}

TEST_F(ConsoleUiTest, HistoryIsSavedBetweenRuns) {
  ui.load_history("map start\ngod\n");
  open();
  press(Key::kUpArrow);
  EXPECT_THAT(typed_line(), EndsWith("]god"));
}

TEST_F(ConsoleUiTest, CtrlRSearchesTheHistory) {
  ui.load_history("map e1m1\ngod\nmap e1m2\nnoclip\n");
  open();
  type("draft");
  ctrl('r');
  type("map");
  EXPECT_THAT(typed_line(), EndsWith("search \"map\": map e1m2"));
  ctrl('r');
  EXPECT_THAT(typed_line(), EndsWith("search \"map\": map e1m1"));
  ctrl('r');
  EXPECT_THAT(typed_line(), EndsWith("search \"map\": map e1m1")) << "there is no older match";
  press(Key::kBackspace);
  EXPECT_THAT(typed_line(), EndsWith("search \"ma\": map e1m2"));
  press(Key::kEscape);
  EXPECT_TRUE(ui.is_open());
  EXPECT_THAT(typed_line(), EndsWith("]draft"));
  ctrl('r');
  type("gO");
  press(Key::kEnter);
  EXPECT_THAT(ui.take_commands(), ElementsAre("god"));
  ctrl('r');
  type("no");
  press(Key::kLeftArrow);
  type("X");
  EXPECT_THAT(typed_line(), EndsWith("]nocliXp")) << "any other key continues with the match";
}

TEST_F(ConsoleUiTest, TabCompletesAsFarAsAllCandidatesAgree) {
  open();
  type("M");
  press(Key::kTab);
  EXPECT_THAT(ui.text(), AllOf(HasSubstr("m_filter \"0\"  Smooths it."), HasSubstr("m_speed \"3\"  How far"),
                               HasSubstr("  map  map NAME starts")));
  type("_");
  ui.clear();
  press(Key::kTab);
  EXPECT_THAT(ui.text(), AllOf(HasSubstr("m_filter"), Not(HasSubstr("map"))));
  type("s");
  press(Key::kTab);
  EXPECT_THAT(typed_line(), EndsWith("]m_speed"));
  ui.clear();
  press(Key::kTab);
  EXPECT_THAT(ui.text(), AllOf(HasSubstr("m_speed is \"3\""), HasSubstr("0 to 20")))
      << "the values it accepts";
  press(Key::kEnter);
  EXPECT_THAT(ui.take_commands(), ElementsAre("m_speed "));
}

TEST_F(ConsoleUiTest, TabCompletesBeforeTheCursorAndAfterASlash) {
  open();
  type("/togg m_f");
  for (int i = 0; i < 4; ++i) press(Key::kLeftArrow);
  press(Key::kTab);
  press(Key::kDelete);
  EXPECT_THAT(typed_line(), EndsWith("]/toggle m_f"));
  press(Key::kEnd);
  press(Key::kTab);
  press(Key::kEnter);
  EXPECT_THAT(ui.take_commands(), ElementsAre("toggle m_filter "));
}

TEST_F(ConsoleUiTest, TabOnAnEmptyLineListsTheFirstCandidates) {
  for (int i = 0; i < 500; ++i) variables.add_bool("z_" + std::to_string(i), false, "One of many.");
  open();
  press(Key::kTab);
  EXPECT_THAT(ui.text(), HasSubstr(" more\n"));
  EXPECT_LT(ui.text().size(), 20'000u);
  ui.clear();
  type("zebra");
  press(Key::kTab);
  EXPECT_EQ(ui.text(), "");
  EXPECT_THAT(typed_line(), EndsWith("]zebra"));
}

TEST_F(ConsoleUiTest, ChatBecomesASayCommand) {
  ui.begin_chat(false);
  ui.handle({0, platform::TextTyped{"t"}});  // from the key that opened it
  type("he said \"no\"; quit");
  EXPECT_TRUE(press(Key::kEnter));
  EXPECT_FALSE(ui.takes_text());
  ui.begin_chat(true);
  type("a");
  ui.handle({0, platform::TextTyped{"\xc3\xa9"}});
  press(Key::kEnter);
  ui.begin_chat(true);
  press(Key::kEnter);
  ui.begin_chat(false);
  type("not this");
  EXPECT_TRUE(press(Key::kEscape));
  EXPECT_FALSE(ui.takes_text());
  EXPECT_THAT(ui.take_commands(), ElementsAre("say \"he said 'no'; quit\"", "say_team \"a?\""));
  EXPECT_EQ(ui.history_text(), "");
}

TEST_F(ConsoleUiTest, ChatLeavesOtherKeysToTheGame) {
  ui.begin_chat(false);
  EXPECT_TRUE(press('w') && press(Key::kTab) && press(Key::kHome));
  EXPECT_FALSE(press(Key::kMouse1) || press(Key::kF5) || press(Key::kWheelUp) || press(Key::kUpArrow));
}

// Any events in any order: the console keeps working and returns single lines.
TEST_F(ConsoleUiTest, SurvivesAnyKeys) {
  for (int seed = 0; seed < test::effort(60, 10); ++seed) {
    test::Random random(static_cast<std::uint64_t>(seed));
    for (int step = 0; step < 300; ++step) {
      const std::size_t action = random.below(12);
      const Key key{static_cast<std::uint16_t>(random.below(platform::kKeys))};
      if (action < 7)
        ui.handle({0, platform::KeyChange{key, random.chance(0.7), random.chance(0.1)}});
      else if (action < 9)
        ui.handle({0, platform::TextTyped{std::string(random.below(20), static_cast<char>(random.bits()))}});
      else if (action == 9)
        random.chance(0.5) ? ui.toggle() : ui.begin_chat(random.chance(0.5));
      else if (action == 10)
        ui.print(std::string(random.below(500), static_cast<char>(random.bits())), view.time_s);
      else
        clipboard = std::string(random.below(9000), static_cast<char>(random.bits()));
      view.time_s += random.uniform(-0.1, 0.5);
      view.game_runs = random.chance(0.9);
      draw(static_cast<int>(random.log_uniform(1, 3000)), static_cast<int>(random.log_uniform(1, 2000)));
      for (const std::string& line : ui.take_commands()) EXPECT_EQ(line.find('\n'), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace temblor::client
