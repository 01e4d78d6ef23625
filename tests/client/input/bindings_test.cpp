// Key names, bindings, and keys that must not stay pressed.
#include "client/input/bindings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/input/input_variables.h"
#include "client/input/key_names.h"

namespace temblor::client {
namespace {

using platform::Key;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Some names that stock configuration files use.
TEST(KeyNames, AreTheStockOnes) {
  EXPECT_EQ(key_name(Key::kUpArrow), "UPARROW");
  EXPECT_EQ(key_name(Key{'w'}), "w");
  EXPECT_EQ(key_name(Key{';'}), "SEMICOLON");
  EXPECT_EQ(key_name(Key::kWheelUp), "MWHEELUP");
  EXPECT_EQ(find_key("mouse1"), Key::kMouse1);
  EXPECT_EQ(find_key("W"), Key{'w'});
  EXPECT_EQ(find_key("KP_HOME"), Key::kKeypad7);
  EXPECT_EQ(find_key("BACKSLASH"), Key{'\\'});
  EXPECT_EQ(key_name(Key{'\\'}), "\\");
  EXPECT_EQ(find_key("KP_DIVIDE"), Key::kKeypadDivide);
  EXPECT_EQ(find_key("X360_LEFT_TRIGGER"), Key::kPadLeftTrigger);
  EXPECT_EQ(find_key("NOSUCHKEY"), std::nullopt);
  EXPECT_EQ(find_key(""), std::nullopt);
  EXPECT_EQ(find_key("\xe4"), std::nullopt);
}

TEST(KeyNames, EveryKeyIsFoundByItsName) {
  for (std::uint16_t i = 0; i < platform::kKeys; ++i) {
    const Key key{i};
    const std::string name = key_name(key);
    if (name.starts_with("KEY")) continue;
    // A capital letter means the key of the small letter.
    if (i >= 'A' && i <= 'Z') continue;
    EXPECT_EQ(find_key(name), key) << name;
  }
}

class BoundConsole {
 public:
  command::Variables variables;
  std::vector<std::string> lines;
  command::Console console{variables, [this](std::string_view line) { lines.emplace_back(line); }};
  Bindings bindings;
  PlayerInput input;
  double time_s = 0;

  BoundConsole() {
    const auto print = [this](std::string_view line) { lines.emplace_back(line); };
    add_binding_commands(console, bindings, print);
    add_input_commands(console, input, time_s);
  }
  void run(std::string_view text) {
    console.append(text);
    console.run();
  }
};

TEST(Bindings, AreSavedAsTextThatRestoresThem) {
  BoundConsole bound;
  bound.run("bind w +forward; bind SEMICOLON \"echo a; echo b\"; bind MOUSE1 \"+attack\"; bind x impulse 9");
  EXPECT_EQ(bound.bindings.commands(Key{';'}), "echo a; echo b");
  EXPECT_EQ(bound.bindings.commands(Key{'x'}), "impulse 9");
  BoundConsole again;
  again.run("bind q quit");
  again.run(bound.bindings.to_text());
  for (std::uint16_t i = 0; i < platform::kKeys; ++i)
    EXPECT_EQ(again.bindings.commands(Key{i}), bound.bindings.commands(Key{i})) << key_name(Key{i});
}

TEST(Bindings, ImpulsesMustFitAByte) {
  BoundConsole bound;
  bound.run("impulse; impulse abc; impulse 256; impulse -1; impulse 1 2");
  EXPECT_THAT(bound.lines, ::testing::AllOf(::testing::SizeIs(5), ::testing::Each(HasSubstr("0 to 255"))));
  bound.run("impulse 255");
  EXPECT_EQ(bound.lines.size(), 5u);
}

TEST(Bindings, ErrorsInAFileNameItsLine) {
  BoundConsole bound;
  bound.console.set_loader([](std::string_view) -> base::Result<std::string> {
    return std::string("bind w +forward\nbind NOSUCHKEY quit\nimpulse ten\nunbind\n");
  });
  bound.run("exec autoexec.cfg");
  EXPECT_THAT(bound.lines,
              ElementsAre("exec autoexec.cfg", HasSubstr("autoexec.cfg:2: Unknown key \"NOSUCHKEY\""),
                          HasSubstr("autoexec.cfg:3: Usage: impulse"), HasSubstr("autoexec.cfg:4: ")));
}

TEST(Bindings, DefaultsLeaveOtherKeysAlone) {
  BoundConsole bound;
  bound.run("bind F11 \"echo mod\"; bind w \"echo mod\"");
  bound.bindings.add_defaults();
  EXPECT_EQ(bound.bindings.commands(Key::kF11), "echo mod");
  EXPECT_EQ(bound.bindings.commands(Key{'w'}), "+forward");
  EXPECT_THAT(bound.bindings.find_keys("+FORWARD"), ElementsAre(Key{'w'}, Key::kUpArrow));
}

TEST(Bindings, WrongKeysAreNamed) {
  BoundConsole bound;
  bound.run("bind nokey quit\nbind\nbind w\nunbind nokey");
  EXPECT_THAT(bound.lines, ElementsAre(HasSubstr("\"nokey\""), HasSubstr("bind KEY"),
                                       HasSubstr("is not bound"), HasSubstr("\"nokey\"")));
}

TEST(HeldKeys, TwoKeysHoldOneAction) {
  BoundConsole bound;
  HeldKeys held;
  bound.run(held.press(Key{'w'}, "+forward"));
  bound.run(held.press(Key::kUpArrow, "+forward"));
  bound.run(held.release(Key{'w'}));
  EXPECT_TRUE(bound.input.buttons()[Button::kForward].is_down());
  bound.run(held.release(Key::kUpArrow));
  EXPECT_FALSE(bound.input.buttons()[Button::kForward].is_down());
}

TEST(HeldKeys, OneKeyMayHoldSeveralActions) {
  BoundConsole bound;
  HeldKeys held;
  bound.run(held.press(Key{'r'}, "+forward; echo ran; +jump"));
  EXPECT_THAT(bound.lines, ElementsAre("ran"));
  EXPECT_TRUE(bound.input.buttons()[Button::kForward].is_down());
  EXPECT_TRUE(bound.input.buttons()[Button::kJump].is_down());
  bound.run(held.release(Key{'r'}));
  EXPECT_FALSE(bound.input.buttons()[Button::kForward].is_down());
  EXPECT_FALSE(bound.input.buttons()[Button::kJump].is_down());
}

// A key that is bound to something else while it is held still ends its action.
TEST(HeldKeys, EndTheActionThatTheyStarted) {
  BoundConsole bound;
  HeldKeys held;
  bound.run(held.press(Key{'w'}, "+forward"));
  EXPECT_EQ(held.press(Key{'w'}, "+back"), "");
  bound.bindings.bind(Key{'w'}, "+back");
  bound.run(held.release(Key{'w'}));
  EXPECT_FALSE(bound.input.buttons()[Button::kForward].is_down());
}

TEST(HeldKeys, NothingSticksWhenTheWindowLosesFocus) {
  BoundConsole bound;
  bound.bindings.add_defaults();
  HeldKeys held;
  for (std::uint16_t i = 0; i < platform::kKeys; ++i)
    if (bound.bindings.commands(Key{i}).starts_with('+'))
      bound.run(held.press(Key{i}, bound.bindings.commands(Key{i})));
  bound.run(held.release_all());
  for (std::uint8_t i = 0; i < kButtons; ++i) EXPECT_FALSE(bound.input.buttons()[Button{i}].is_down()) << +i;
}

}  // namespace
}  // namespace temblor::client
