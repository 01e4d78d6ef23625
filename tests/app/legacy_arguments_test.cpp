#include "app/commands/legacy_arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace temblor::test {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> ours(const std::vector<const char*>& words) {
  const std::vector<std::string> commands = {"play", "serve", "render"};
  return app::convert_legacy_arguments(words, commands);
}

TEST(LegacyArguments, PlusStartsAConsoleCommand) {
  EXPECT_THAT(ours({"play", "+skill", "2", "+map", "start"}),
              ElementsAre("play", "--exec", "skill 2", "--exec", "map start"));
  EXPECT_THAT(ours({"serve", "+deathmatch", "1", "--port", "26001", "+map", "dm1"}),
              ElementsAre("serve", "--port", "26001", "--exec", "deathmatch 1", "--exec", "map dm1"));
}

TEST(LegacyArguments, DefaultCommandIsPlay) {
  EXPECT_THAT(ours({"-basedir", "quake", "-game", "mod", "+map", "e1m1"}),
              ElementsAre("--basedir", "quake", "--game", "mod", "play", "--exec", "map e1m1"));
}

TEST(LegacyArguments, WindowAndSoundAreThoseOfOtherEngines) {
  EXPECT_THAT(ours({"-window", "-width", "800", "-height", "600", "-nosound", "-basedir", "quake"}),
              ElementsAre("--set", "vid_mode=window", "--set", "vid_width=800", "--set", "vid_height=600",
                          "--basedir", "quake", "play", "--nosound"));
  EXPECT_THAT(ours({"+map", "start", "-fullscreen"}),
              ElementsAre("--set", "vid_mode=fullscreen", "play", "--exec", "map start"));
  EXPECT_THAT(ours({"+map", "start", "-width"}), ElementsAre("-width", "play", "--exec", "map start"));
  EXPECT_THAT(ours({"render", "-width", "8", "-window"}), ElementsAre("render", "-width", "8", "-window"));
}

TEST(LegacyArguments, ServersAreThoseOfOtherEngines) {
  EXPECT_THAT(
      ours({"-dedicated", "8", "-basedir", "quake", "-port", "26001", "+deathmatch", "1", "+map", "dm1"}),
      ElementsAre("--basedir", "quake", "serve", "--maxclients", "8", "--port", "26001", "--map", "dm1",
                  "--exec", "deathmatch 1"));
  EXPECT_THAT(ours({"-dedicated"}), ElementsAre("serve", "--map", "start"));
  EXPECT_THAT(ours({"-listen", "-udpport", "26001", "+map", "dm1"}),
              ElementsAre("--set", "maxplayers=8", "play", "--set", "port=26001", "--exec", "map dm1"));
  EXPECT_THAT(ours({"-listen", "4", "-game", "mod"}),
              ElementsAre("--set", "maxplayers=4", "--game", "mod", "play"));
}

TEST(LegacyArguments, OptionsWithoutMeaningAreDropped) {
  EXPECT_THAT(ours({"-heapsize", "64000", "-nojoy", "-zone", "512", "+map", "start", "-condebug"}),
              ElementsAre("play", "--exec", "map start"));
  EXPECT_THAT(ours({"-heapsize"}), ElementsAre("-heapsize"));
}

TEST(LegacyArguments, MissionPacksAreGamesBelowTheMods) {
  EXPECT_THAT(ours({"-game", "mod", "-hipnotic", "+map", "hip1m1"}),
              ElementsAre("--game", "hipnotic", "--game", "mod", "play", "--exec", "map hip1m1"));
  EXPECT_THAT(ours({"+map", "r1m1", "-rogue", "serve"}),
              ElementsAre("--game", "rogue", "serve", "--exec", "map r1m1"));
  EXPECT_THAT(ours({"render", "-quoth", "-o", "a.png"}),
              ElementsAre("--game", "quoth", "render", "-o", "a.png"));
}

TEST(LegacyArguments, WordsWithSpacesAreQuoted) {
  EXPECT_THAT(ours({"play", "+name", "the player"}), ElementsAre("play", "--exec", "name \"the player\""));
}

TEST(LegacyArguments, OtherWordsAreUnchanged) {
  EXPECT_THAT(ours({"render", "--map", "start", "-o", "+0button.png"}),
              ElementsAre("render", "--map", "start", "-o", "+0button.png"));
  EXPECT_THAT(ours({"-game", "mod", "render", "+map", "start"}),
              ElementsAre("--game", "mod", "render", "+map", "start"));
  EXPECT_THAT(ours({}), ElementsAre());
}

}  // namespace
}  // namespace temblor::test
