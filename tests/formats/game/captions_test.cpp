#include "formats/game/captions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace temblor::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(SoundCaptions, AreReadLineByLine) {
  const Captions captions = read_captions(
      "// a comment\r\n"
      "dog/dattack1.wav   dog snarls \r\n"
      "\n"
      "\tMisc/NULL.wav -\n"
      "a.wav first\n"
      "a.wav second");
  EXPECT_THAT(captions.texts, ElementsAre(Pair("a.wav", "second"), Pair("dog/dattack1.wav", "dog snarls"),
                                          Pair("misc/null.wav", "")));
  EXPECT_THAT(captions.bad_lines, ElementsAre());
}

TEST(SoundCaptions, BadLinesAreNumberedAndCostOnlyThemselves) {
  const Captions captions = read_captions("a.wav\nb.wav b\n" + std::string(200, 'x') + " c\n");
  EXPECT_THAT(captions.texts, ElementsAre(Pair("b.wav", "b")));
  EXPECT_THAT(captions.bad_lines, ElementsAre(1, 3));
}

TEST(SoundCaptions, AreShortPrintableAndBounded) {
  EXPECT_THAT(read_captions("a.wav " + std::string(100, 'b') + "\nc.wav \x01\x80").texts,
              ElementsAre(Pair("a.wav", std::string(32, 'b')), Pair("c.wav", "??")));
  std::string text;
  for (int i = 0; i < 10000; ++i) text += std::to_string(i) + " x\n";
  EXPECT_EQ(read_captions(text).texts.size(), kMaxCaptions);
  EXPECT_EQ(read_captions(std::string(100, '\n') + "x").bad_lines, std::vector<std::size_t>{101});
  EXPECT_TRUE(read_captions("").texts.empty());
}

TEST(SoundCaptions, AreCutBeforeADashMeansSilence) {
  const Captions cut = read_captions("a.wav -" + std::string(kMaxCaptionChars, ' ') + "text");
  EXPECT_THAT(cut.texts, ElementsAre(Pair("a.wav", "")));
}

TEST(SoundCaptions, WrittenLinesAreReadAgain) {
  const std::string text = format_caption_line("a/b.wav", "bell rings") + format_caption_line("c/d.wav", "");
  EXPECT_EQ(text, "a/b.wav bell rings\nc/d.wav -\n");
  EXPECT_THAT(read_captions(text).texts, ElementsAre(Pair("a/b.wav", "bell rings"), Pair("c/d.wav", "")));
}

}  // namespace
}  // namespace temblor::formats
