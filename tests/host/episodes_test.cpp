#include "host/menus/episodes.h"

#include <gmock/gmock.h>

namespace temblor {
namespace {

using host::find_episodes;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> list_places(std::vector<client::MenuLevel> levels) {
  std::vector<std::string> places;
  for (const client::MenuEpisode& place : find_episodes(levels))
    places.push_back(place.first_level + "|" + place.title + "|" + place.level_title);
  return places;
}

TEST(Episodes, AreThoseOfTheStockGame) {
  EXPECT_THAT(list_places({{"dm1", "Place of Two Deaths"},
                           {"e1m1", "the Slipgate Complex"},
                           {"e1m2", "Castle of the Damned"},
                           {"e2m1", "the Installation"},
                           {"end", "Shub-Niggurath's Pit"},
                           {"start", "Introduction"}}),
              ElementsAre("start|Introduction|", "e1m1|Episode 1|the Slipgate Complex",
                          "e2m1|Episode 2|the Installation"));
}

TEST(Episodes, AreSortedByNumber) {
  EXPECT_THAT(list_places({{"lq_e10m1", ""}, {"lq_e2m1", ""}, {"lq_e0m1", "Zero"}}),
              ElementsAre("lq_e0m1|Episode 0|Zero", "lq_e2m1|Episode 2|", "lq_e10m1|Episode 10|"));
}

// Then there is nothing to choose.
TEST(Episodes, NeedTwo) {
  EXPECT_THAT(list_places({}), IsEmpty());
  EXPECT_THAT(list_places({{"start", ""}, {"e1m1", ""}, {"e1m2", ""}}), IsEmpty());
}

TEST(Episodes, IgnoreOtherNames) {
  EXPECT_THAT(
      list_places({{"m1", ""}, {"farm1", ""}, {"em1", ""}, {"e99999999999999999999m1", ""}, {"e1m11", ""}}),
      IsEmpty());
}

}  // namespace
}  // namespace temblor
