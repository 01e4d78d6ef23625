// Films: a film of a made room has the shots of its script, and the shipped film shows what it should.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "client/demo/demo_session.h"
#include "scripted_player/film/make_film.h"
#include "scripted_player/made_rooms.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;

// Calls `see` for each packet after the player has joined, with the player of the demo.
template <typename See>
void for_each_packet(const base::ByteVector& demo, const See& see) {
  client::DemoPlayer player = client::DemoPlayer::open(demo, "film.dem").value();
  while (player.read_packet().value()) see(player);
}

player::CameraKey make_key(double time_s, const math::Vec3& place) {
  return {.time_s = time_s, .place = place, .target_world = math::Vec3(0, 0, 64)};
}

player::FilmScript make_script() {
  player::FilmScene scene{.map = "rooms", .shots = {}};
  scene.shots.push_back({.begin_s = 3, .end_s = 4, .camera = {}, .title = {}});
  scene.shots.push_back({.begin_s = 6,
                         .end_s = 8,
                         .camera = {make_key(6, {-200, 0, 64}), make_key(8, {-100, 0, 64})},
                         .title = {}});
  return {.track = 7, .title_model = "", .scenes = {scene}};
}

TEST(Film, HasTheShotsOfItsScript) {
  const MadeRooms rooms(entity_text("worldspawn", "", walls_text({-320, -320, 0}, {320, 320, 256}, "wall")) +
                        point_text("info_player_start", {0, 0, 32}));
  const player::Film film = player::make_film(make_script(), rooms.setup().session.base_folder).value();
  EXPECT_EQ(film.length_s, 3);
  const client::DemoLength length = client::DemoPlayer::scan(film.demo, "film.dem").value();
  EXPECT_FALSE(length.damage);
  EXPECT_NEAR(length.last_time_s - length.first_time_s, 3, 0.2);
  int own_views = 0, flights = 0;
  for_each_packet(film.demo, [&](client::DemoPlayer& player) {
    const client::Game& game = player.state().game();
    EXPECT_EQ(game.music_track, 7);
    if (game.view_entity == 1) {
      ++own_views;
      EXPECT_EQ(flights, 0);
      EXPECT_EQ(game.ending, client::Ending::kNone);
      return;
    }
    ++flights;
    EXPECT_EQ(game.ending, client::Ending::kCutScene);
  });
  EXPECT_NEAR(own_views, 72, 10);
  EXPECT_NEAR(flights, 144, 3);
}

// The player is in one room, the camera in another, which the player cannot see.
TEST(Film, ShowsWhatTheCameraSees) {
  const math::Vec3d far(2000, 0, 64);
  const MadeRooms rooms(entity_text("worldspawn", "",
                                    walls_text({-320, -320, 0}, {320, 320, 256}, "wall") +
                                        walls_text({1680, -320, 0}, {2320, 320, 256}, "wall")) +
                            point_text("info_player_start", {0, 0, 32}) + point_text("info_notnull", far) +
                            entity_text("func_wall", "", box_text({2100, -32, 0}, {2164, 32, 64}, "wall")),
                        compiler::StagePolicy::kBuild);
  player::FilmScript script = make_script();
  for (player::CameraKey& key : script.scenes.front().shots.back().camera) key.place.x += 2000;
  const player::Film film = player::make_film(script, rooms.setup().session.base_folder).value();
  int flights = 0;
  for_each_packet(film.demo, [&](const client::DemoPlayer& player) {
    std::vector<client::EntityPlace> places;
    player.state().copy_latest_places(places);
    const bool shows_block = std::any_of(places.begin(), places.end(), [&](const client::EntityPlace& place) {
      return place.model > 0 && player.state().game().models.at(place.model) == "*1";
    });
    const bool is_flight = player.state().game().view_entity != 1;
    EXPECT_EQ(shows_block, is_flight);
    flights += is_flight ? 1 : 0;
  });
  EXPECT_NEAR(flights, 144, 3);
}

TEST(ShippedFilm, ShowsRoomsFromInside) {
  const std::filesystem::path file = std::filesystem::path(TEMBLOR_SHIPPED_FOLDER) / "id1/film.dem";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the film has not been built";
  const assets::Library library(vfs::FileSystem::open(TEMBLOR_SHIPPED_FOLDER).value());
  client::Presentation presentation(library);
  auto session = client::DemoSession::open(read_file(file), "film.dem", presentation).value();
  EXPECT_GE(session.end_s() - session.begin_s(), 25);
  EXPECT_LE(session.end_s() - session.begin_s(), 35);
  EXPECT_LE(session.length().levels.size(), 5u);
  constexpr double kStep_s = 0.1;
  for (double time_s = session.begin_s() + kStep_s; time_s < session.end_s(); time_s += kStep_s) {
    ASSERT_TRUE(session.seek(time_s, {}).value());
    EXPECT_THAT(presentation.take_notes(), IsEmpty()) << time_s;
    const render::Scene& scene = presentation.scene();
    EXPECT_NE(world::point_contents(*scene.level, scene.camera.origin_world), world::Contents::kSolid)
        << time_s - session.begin_s() << " s after the beginning";
  }
}

}  // namespace
}  // namespace temblor::test
