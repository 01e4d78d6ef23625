// The scripted player chooses between several routes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "scripted_player/made_rooms.h"
#include "scripted_player/navigation/level_map.h"
#include "scripted_player/navigation/mover_watch.h"
#include "scripted_player/navigation/router.h"
#include "scripted_player/session/session.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

// Two tables with a gap between them that the player can jump, from west to east, and a bridge around it.
// `pit` are brushes in the gap.
std::string tables_with_bridge(const std::string& pit) {
  return entity_text("worldspawn", "",
                     walls_text({0, 0, 0}, {768, 640, 256}, "wall") +
                         box_text({64, 64, 0}, {256, 192, 96}, "table") +
                         box_text({390, 64, 0}, {600, 192, 128}, "table") +
                         box_text({64, 192, 0}, {256, 544, 104}, "bridge") +
                         box_text({256, 448, 0}, {600, 544, 112}, "bridge") +
                         box_text({440, 192, 0}, {600, 448, 120}, "bridge") + pit) +
         entity_text("info_player_start", "\"origin\" \"128 128 128\"\n\"angle\" \"0\"");
}

// Routes in one level, from its start to a place.
class Routes {
 public:
  explicit Routes(const std::string& map_text)
      : rooms_(map_text), session_(player::Session::start(rooms_.setup().session).value()) {
    for (int i = 0; i < 36; ++i) session_->step(std::vector<net::Move>(1));
    map_ = player::LevelMap::make(session_->game());
    movers_.emplace(map_->facts);
    router_.emplace(map_->graph, *movers_);
  }
  player::Router& router() { return *router_; }
  player::Route to(const math::Vec3& place) {
    const std::uint32_t goal = nearest(place);
    return router_->find(nearest({128, 128, 120}), {&goal, 1}).value();
  }

 private:
  std::uint32_t nearest(const math::Vec3& place) const {
    return static_cast<std::uint32_t>(map_->graph.find_nearest(place));
  }

  MadeRooms rooms_;
  std::unique_ptr<player::Session> session_;
  std::unique_ptr<const player::LevelMap> map_;
  std::optional<player::MoverWatch> movers_;
  std::optional<player::Router> router_;
};

constexpr math::Vec3 kFarTable(480, 128, 152);

std::size_t jumps_in(const player::Route& route) {
  return static_cast<std::size_t>(
      std::count_if(route.links.begin(), route.links.end(),
                    [](const player::Link& link) { return link.kind == player::LinkKind::kJump; }));
}

TEST(Routes, JumpsWhereAFallIsHarmless) {
  EXPECT_EQ(jumps_in(Routes(tables_with_bridge("")).to(kFarTable)), 1u);
}

TEST(Routes, AvoidsAJumpThatCouldFallShortIntoLava) {
  const std::string lava = box_text({300, 0, 0}, {390, 448, 32}, "*lava1");
  EXPECT_EQ(jumps_in(Routes(tables_with_bridge(lava)).to(kFarTable)), 0u);
}

TEST(Routes, KeepsOnlyThePenaltyOfADeadEnd) {
  Routes routes(tables_with_bridge(""));
  const auto penalize_jumps = [&] {
    const player::Route route = routes.to(kFarTable);
    for (std::size_t i = 0; i < route.links.size(); ++i)
      if (route.links[i].kind == player::LinkKind::kJump)
        routes.router().penalize_link(route.places[i], route.places[i + 1], 1500);
    return route;
  };
  const player::Route first = penalize_jumps();
  routes.router().clear_penalties();
  EXPECT_EQ(routes.to(kFarTable).places, first.places);

  penalize_jumps();
  routes.router().keep_last_penalty();
  routes.router().clear_penalties();
  EXPECT_NE(routes.to(kFarTable).places, first.places);
}

}  // namespace
}  // namespace temblor::test
