// Text for players and the console, and messages that game code writes itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "server/builtins/builtin_stage.h"

namespace temblor::test {
namespace {

using server::Outbox;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace global = server::global;

template <typename Message>
std::vector<std::string> texts_in(const base::ByteWriter& writer) {
  std::vector<std::string> texts;
  for (const Message& message : messages_in<Message>(writer.view())) texts.emplace_back(message.text);
  return texts;
}
std::vector<int> numbers_in(const base::ByteWriter& writer) {
  std::vector<int> numbers;
  for (const std::byte byte : writer.view()) numbers.push_back(std::to_integer<int>(byte));
  return numbers;
}

TEST(PrintBuiltins, GoToAllOrOneAndJoinTheirTexts) {
  Stage stage;
  stage.run("bprint", "Joe ", "was ", "here\n");
  EXPECT_THAT(texts_in<net::Print>(stage.outbox.reliable()), ElementsAre("Joe was here\n"));
  stage.run("sprint", Stage::kPlayer2, "you ", "only\n");
  EXPECT_THAT(texts_in<net::Print>(*stage.outbox.reliable_to(Stage::kPlayer2)), ElementsAre("you only\n"));
  EXPECT_EQ(stage.outbox.reliable_to(Stage::kPlayer1)->size(), 0u);
  stage.run("centerprint", Stage::kPlayer1, "a", "b", "c", "d", "e", "f", "g");
  stage.run("centerprint", Stage::kPlayer1, "");
  EXPECT_THAT(texts_in<net::CenterPrint>(*stage.outbox.reliable_to(Stage::kPlayer1)),
              ElementsAre("abcdefg", ""));
}

TEST(PrintBuiltins, OtherEntitiesGetNoText) {
  Stage stage;
  const vm::EntityIndex monster = stage.spawn();
  stage.run("sprint", monster, "x");
  stage.run("centerprint", vm::kWorld, "x");
  EXPECT_THAT(stage.printed, HasSubstr("builtin sprint: entity 3 is not a player"));
  EXPECT_THAT(stage.printed, HasSubstr("builtin centerprint: entity 0 is not a player"));
}

TEST(PrintBuiltins, LongTextsComeInPieces) {
  Stage stage;
  std::string text;
  for (int i = 0; i < 2500; ++i) text += static_cast<char>('a' + i % 26);
  stage.run("bprint", text);
  std::string joined;
  for (const std::string& piece : texts_in<net::Print>(stage.outbox.reliable())) {
    EXPECT_LE(piece.size(), 2047u) << "the buffer of stock clients";
    joined += piece;
  }
  EXPECT_EQ(joined, text);
}

TEST(PrintBuiltins, StuffcmdIsForPlayers) {
  Stage stage;
  stage.run("stuffcmd", Stage::kPlayer1, "bf\n");
  EXPECT_THAT(texts_in<net::StuffText>(*stage.outbox.reliable_to(Stage::kPlayer1)), ElementsAre("bf\n"));
  EXPECT_THAT(stage.error("stuffcmd", vm::kWorld, "quit\n"),
              HasSubstr("builtin stuffcmd: parameter 1 is entity 0, which is not a player"));
}

TEST(PrintBuiltins, DprintIsForDevelopers) {
  Stage stage;
  stage.run("dprint", "hidden");
  stage.variables.add_bool("developer", false, "More words.");
  stage.run("dprint", "hidden");
  EXPECT_EQ(stage.printed, "");
  ASSERT_TRUE(stage.variables.set("developer", "1").ok());
  stage.run("dprint", "seen ", "now\n");
  EXPECT_EQ(stage.printed, "seen now\n");
}

TEST(RereleasePrints, PlacesAreFilled) {
  Stage stage;
  stage.run("ex_bprint", "{0} was killed by {1}{0}\n", "A", "B");
  stage.run("ex_bprint", "{2} {} {x} {0", "A", "B");
  stage.run("ex_bprint", "plain ", "joined");
  EXPECT_THAT(texts_in<net::Print>(stage.outbox.reliable()),
              ElementsAre("A was killed by BA\n", "{2} {} {x} {0", "plain joined"));
  stage.run("ex_sprint", Stage::kPlayer1, "got {0}", "it");
  stage.run("ex_centerprint", Stage::kPlayer2, "{0}!", "out");
  EXPECT_THAT(texts_in<net::Print>(*stage.outbox.reliable_to(Stage::kPlayer1)), ElementsAre("got it"));
  EXPECT_THAT(texts_in<net::CenterPrint>(*stage.outbox.reliable_to(Stage::kPlayer2)), ElementsAre("out!"));
}

// Keys in any place, with and without places to fill.
TEST(LocalizedPrints, ClientsGetTextsInsteadOfKeys) {
  const formats::Localization texts(formats::Localization::Texts{{"hi", "Hello"},
                                                                 {"ogre", "an ogre"},
                                                                 {"died", "{0} was killed by {1}\n"},
                                                                 {"end", std::string(3000, 'x')}});
  Stage stage;
  stage.context.localization = &texts;
  stage.run("bprint", "$hi");
  stage.run("bprint", "$hi", "\n");
  stage.run("bprint", "Joe killed ", "$ogre");
  stage.run("bprint", "$died", "Joe", "$ogre");
  stage.run("bprint", "{0}", "$unknown");
  stage.run("ex_bprint", "$died", "$ogre", "{0}");
  stage.run("ex_bprint", "by {0}", "$ogre");
  EXPECT_THAT(texts_in<net::Print>(stage.outbox.reliable()),
              ElementsAre("Hello", "Hello\n", "Joe killed an ogre", "Joe was killed by an ogre\n",
                          "{0}$unknown", "an ogre was killed by {0}\n", "by an ogre"));
  stage.run("sprint", Stage::kPlayer1, "$hi");
  stage.run("ex_sprint", Stage::kPlayer1, "$hi");
  EXPECT_THAT(texts_in<net::Print>(*stage.outbox.reliable_to(Stage::kPlayer1)),
              ElementsAre("Hello", "Hello"));
  stage.run("centerprint", Stage::kPlayer2, "$hi");
  stage.run("ex_centerprint", Stage::kPlayer2, "$died", "A", "B");
  EXPECT_THAT(texts_in<net::CenterPrint>(*stage.outbox.reliable_to(Stage::kPlayer2)),
              ElementsAre("Hello", "A was killed by B\n"));
  stage.run("WriteByte", 3, 31);
  stage.run("WriteString", 3, "$end");
  stage.run("WriteByte", 0, 26);
  stage.run("WriteString", 0, "$ogre");
  EXPECT_THAT(texts_in<net::Finale>(stage.outbox.signon()), ElementsAre(std::string(2047, 'x')));
  EXPECT_THAT(texts_in<net::CenterPrint>(stage.outbox.broadcast()), ElementsAre("an ogre"));
}

TEST(RereleasePrints, TheFinaleEndsWithItsLastLetter) {
  Stage stage;
  EXPECT_EQ(stage.number("ex_finaleFinished"), 0);
  stage.run("WriteByte", 2, 31);
  stage.run("WriteString", 2, "sixteen letters.");
  const double began_s = stage.world.time_s;
  stage.world.time_s = began_s + 1.9;
  EXPECT_EQ(stage.number("ex_finaleFinished"), 0);
  stage.world.time_s = began_s + 2;
  EXPECT_EQ(stage.number("ex_finaleFinished"), 1);
}

// Stock clients would read them as something else.
TEST(RereleaseMessages, AchievementsAreNotSent) {
  Stage stage;
  stage.run("WriteByte", 2, 1);
  stage.run("WriteByte", 2, 52);
  stage.run("WriteString", 2, "ACH_COMPLETE_E1M1");
  stage.run("WriteString", 2, "ACH_");
  EXPECT_THAT(numbers_in(stage.outbox.reliable()), ElementsAre(1, 'A', 'C', 'H', '_', 0));
}

TEST(RereleasePrints, LocalsoundIsForOne) {
  Stage stage;
  stage.run("precache_sound", "a.wav");
  stage.run("ex_localsound", Stage::kPlayer2, "a.wav");
  stage.run("ex_localsound", Stage::kPlayer2, "b.wav");
  const auto sounds = messages_in<net::Sound>(stage.outbox.reliable_to(Stage::kPlayer2)->view());
  ASSERT_EQ(sounds.size(), 1u);
  EXPECT_EQ(sounds[0].entity, 2);
  EXPECT_EQ(sounds[0].sound, 1);
  EXPECT_EQ(sounds[0].attenuation, 0);
  for (const char* name : {"ex_localsound", "ex_sprint", "ex_centerprint"}) {
    stage.run(name, vm::kWorld, "a.wav");
    EXPECT_THAT(stage.error(name, RawWord{99}, "a.wav"), HasSubstr("parameter 1 is not an entity"));
  }
  EXPECT_THAT(stage.printed, HasSubstr("builtin ex_localsound: entity 0 is not a player: it gets no text"));
}

TEST(WriteBuiltins, NumbersAreLittleEndianLowBytes) {
  Stage stage;
  stage.run("WriteByte", 0, 300);
  stage.run("WriteByte", 0, -1.9f);
  stage.run("WriteChar", 0, -2);
  stage.run("WriteShort", 0, -2);
  stage.run("WriteShort", 0, 70000);
  stage.run("WriteLong", 0, 16909060);
  EXPECT_THAT(numbers_in(stage.outbox.broadcast()),
              ElementsAre(300 - 256, 255, 254, 254, 255, 70000 & 0xff, (70000 >> 8) & 0xff, 4, 3, 2, 1));
}

TEST(WriteBuiltins, AWholeMessageIsReadBack) {
  // An explosion, as game code writes it.
  for (const net::Dialect dialect : {net::Dialect{}, net::Dialect{net::Protocol::kRmq, net::kFloatCoord}}) {
    Stage stage(dialect);
    stage.run("WriteByte", 0, 23);
    stage.run("WriteByte", 0, 3);
    for (const float coord : {100.5f, -20.25f, 8.0f}) stage.run("WriteCoord", 0, coord);
    stage.run("WriteByte", 0, 10);
    for (const float angle : {0.0f, 90.0f, 180.0f}) stage.run("WriteAngle", 0, angle);
    base::Bytes bytes = stage.outbox.broadcast().view();
    const std::size_t angles = bytes.size() - 1 - 3;
    const auto sent = messages_in<net::TempEntity>(bytes.first(angles), dialect);
    ASSERT_EQ(sent.size(), 1u);
    EXPECT_EQ(sent[0].kind, net::TempEntityKind::kExplosion);
    EXPECT_EQ(sent[0].origin, math::Vec3(100.5f, -20.25f, 8));
    const auto turned = messages_in<net::SetAngle>(bytes.subspan(angles), dialect);
    ASSERT_EQ(turned.size(), 1u);
    EXPECT_EQ(turned[0].angles_deg.y, 90);
  }
}

TEST(WriteBuiltins, DestinationsAreTheFour) {
  Stage stage;
  stage.run("WriteByte", 0, 1);
  stage.machine.set_global_entity(global::kMessageEntity, Stage::kPlayer2);
  stage.run("WriteByte", 1, 2);
  stage.run("WriteByte", 2, 3);
  stage.run("WriteByte", 3, 4);
  EXPECT_THAT(numbers_in(stage.outbox.broadcast()), ElementsAre(1));
  EXPECT_THAT(numbers_in(*stage.outbox.reliable_to(Stage::kPlayer2)), ElementsAre(2));
  EXPECT_THAT(numbers_in(stage.outbox.reliable()), ElementsAre(3));
  EXPECT_THAT(numbers_in(stage.outbox.signon()), ElementsAre(4));
  for (const float wrong : {-1.0f, 4.0f, 0.5f, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_THAT(stage.error("WriteByte", wrong, 1), HasSubstr("builtin WriteByte: destination"));
  stage.machine.set_global_entity(global::kMessageEntity, vm::kWorld);
  EXPECT_THAT(stage.error("WriteString", 1, "x"),
              HasSubstr("builtin WriteString: msg_entity is entity 0, which is not a player"));
}

TEST(WriteBuiltins, StringsAndEntities) {
  Stage stage;
  stage.run("WriteString", 2, "hi");
  stage.run("WriteEntity", 2, Stage::kPlayer2);
  EXPECT_THAT(numbers_in(stage.outbox.reliable()), ElementsAre('h', 'i', 0, 2, 0));
  EXPECT_THAT(stage.error("WriteEntity", 2, RawWord{5000}),
              HasSubstr("builtin WriteEntity: parameter 2 is not an entity"));
}

TEST(WriteBuiltins, AnEndlessMessageIsAnError) {
  Stage stage;
  const std::string text(60000, 'x');
  std::string error;
  for (int i = 0; i < 100 && error.empty(); ++i) error = stage.error("WriteString", 3, text);
  EXPECT_THAT(error, HasSubstr("builtin WriteString: more than 1048576 bytes in one tick for destination 3"));
  EXPECT_LE(stage.outbox.signon().size(), Outbox::kMaxBytes);
}

}  // namespace
}  // namespace temblor::test
