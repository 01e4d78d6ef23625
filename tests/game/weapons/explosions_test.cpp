// Explosions show a fireball: a sprite that plays its frames once and disappears.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/room_level.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace field = server::field;

constexpr std::uint8_t kRocketImpulse = 7;

class Explosions : public ::testing::Test {
 protected:
  void begin(const std::string& entities) {
    data_ = std::make_unique<RoomData>(hall_text({0, -128, 0}, {600, 128, 128}, {}, entities));
    game_ = std::make_unique<PlayedLevel>(data_->path(), "room", kProgs);
    game_->join(0);
    game_->put(game_->player(0), {150, 0, 25});
    game_->run(0.5);
  }

  // Waits for an explosion, and returns the frames that it shows.
  std::vector<int> watch_explosion() {
    for (int tick = 0; tick < 100 && game_->of_class("explosion").empty(); ++tick) game_->tick();
    std::vector<int> frames;
    for (auto found = game_->of_class("explosion"); !found.empty(); found = game_->of_class("explosion")) {
      const server::Edict edict = game_->edict(found[0]);
      EXPECT_EQ(game_->text(edict[field::kModel]), "progs/s_explod.spr");
      EXPECT_EQ(edict.solid(), server::Solid::kNot);
      const int frame = static_cast<int>(edict[field::kFrame]);
      if (frames.empty() || frames.back() != frame) frames.push_back(frame);
      game_->tick();
    }
    return frames;
  }

  std::unique_ptr<RoomData> data_;
  std::unique_ptr<PlayedLevel> game_;
};

TEST_F(Explosions, ARocketBecomesAFireballThatBurnsOut) {
  begin("");
  const server::Edict player = game_->player(0);
  player.set(field::kItems, 255 + 4096);
  player.set(field::kAmmoRockets, 10);
  player.set(field::kImpulse, kRocketImpulse);
  game_->run(0.2);
  game_->input(0).command.view_angles_deg = {};
  game_->input(0).buttons = kAttack;
  game_->tick();
  game_->input(0).buttons = 0;
  EXPECT_THAT(watch_explosion(), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(game_->of_class("rocket"), IsEmpty());
  EXPECT_THAT(game_->errors(), IsEmpty());
}

TEST_F(Explosions, ABarrelBecomesAFireballThatBurnsOut) {
  begin(point_text("misc_explobox2", {400, 0, 1}));
  ASSERT_THAT(game_->of_class("misc_explobox2"), SizeIs(1));
  game_->hurt(game_->of_class("misc_explobox2")[0], 1, 100);
  EXPECT_THAT(watch_explosion(), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(game_->errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
