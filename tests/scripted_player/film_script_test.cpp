// Film scripts: the shots that a script lists, and errors, which name the line.
#include "scripted_player/film/film_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(FilmScript, ListsScenesAndShots) {
  const player::FilmScript script = player::read_film_script(R"(
# A comment.
film track=4 title=progs/title.spr
scene t1 skill=2 seed=7 god tour
  eyes 1 2.5
  camera 3 5
    title 1,2,3 yaw=90
    at 3 10,20,30 look=40,50,60
    at 5 player+-10,0,5 look=player   # behind the player
scene tdm1 bots=3
  eyes 2 3
)")
                                        .value();
  EXPECT_EQ(script.track, 4);
  EXPECT_EQ(script.title_model, "progs/title.spr");
  ASSERT_EQ(script.scenes.size(), 2u);
  const player::FilmScene& scene = script.scenes[0];
  EXPECT_EQ(scene.map, "t1");
  EXPECT_EQ(scene.skill, 2);
  EXPECT_EQ(scene.seed, 7u);
  EXPECT_TRUE(scene.has_god && scene.visits_stops);
  ASSERT_EQ(scene.shots.size(), 2u);
  EXPECT_FALSE(scene.shots[0].is_flight());
  EXPECT_EQ(scene.shots[0].end_s, 2.5);
  const player::Shot& flight = scene.shots[1];
  ASSERT_EQ(flight.camera.size(), 2u);
  EXPECT_EQ(flight.title->yaw_deg, 90);
  EXPECT_EQ(flight.camera[0].place, math::Vec3(10, 20, 30));
  EXPECT_EQ(flight.camera[0].target_world, math::Vec3(40, 50, 60));
  EXPECT_FALSE(flight.camera[0].is_relative);
  EXPECT_EQ(flight.camera[1].place, math::Vec3(-10, 0, 5));
  EXPECT_TRUE(flight.camera[1].is_relative);
  EXPECT_FALSE(flight.camera[1].target_world);
  EXPECT_EQ(script.scenes[1].bots, 3u);
}

TEST(FilmScript, ErrorsNameTheLine) {
  struct Case {
    const char* text;
    const char* line;
    const char* error;
  };
  for (const Case& wrong : {
           Case{"", "the film", "has no scene"},
           Case{"shot 1 2", "line 1", "\"shot\" is not a keyword"},
           Case{"film size=3", "line 1", "\"size=3\" is not a setting of a film"},
           Case{"\nscene", "line 2", "needs the name of a level"},
           Case{"scene t1 skill=4", "line 1", "\"skill=4\" is not a setting of a scene"},
           Case{"scene t1 fast", "line 1", "\"fast\" is not a setting of a scene"},
           Case{"scene t1", "line 1", "has no shot"},
           Case{"eyes 1 2", "line 1", "needs a scene"},
           Case{"scene t1\neyes 2 1", "line 2", "its later end"},
           Case{"scene t1\neyes 2", "line 2", "its later end"},
           Case{"scene t1\neyes 1 3\neyes 2 4", "line 3", "sort the shots"},
           Case{"scene t1\ncamera 1 3", "line 2", "needs two places"},
           Case{"scene t1\neyes 1 2\nat 1 0,0,0 look=player", "line 3", "needs a camera"},
           Case{"scene t1\ncamera 1 2\nat 1 0,0 look=player", "line 3", "needs the form"},
           Case{"scene t1\ncamera 1 2\nat 1 0,0,0 look=nan,0,0", "line 3", "needs the form"},
           Case{"scene t1\ncamera 1 2\nat 1 0,0,0", "line 3", "needs the form"},
           Case{"scene t1\ncamera 1 2\nat 2 0,0,0 look=player\nat 2 1,0,0 look=player", "line 4",
                "in order of time"},
           Case{"scene t1\ncamera 1 2\nat 1 0,0,0 look=player\nat 2 1,0,0 look=player\neyes 2 3", "line 5",
                "cannot follow"},
           Case{"scene t1\ncamera 1 2\ntitle 0,0,0", "line 3", "film title=MODEL"},
           Case{"film title=a.spr\nscene t1\ncamera 1 2\ntitle 0,0,0 size=2", "line 4",
                "expected yaw=DEGREES"},
       }) {
    const base::Result<player::FilmScript> script = player::read_film_script(wrong.text);
    ASSERT_FALSE(script.ok()) << wrong.text;
    EXPECT_THAT(script.error().message(), StartsWith(wrong.line)) << wrong.text;
    EXPECT_THAT(script.error().message(), HasSubstr(wrong.error)) << wrong.text;
  }
}

}  // namespace
}  // namespace temblor::test
