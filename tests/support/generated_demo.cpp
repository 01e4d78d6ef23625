#include "support/generated_demo.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include "artgen/palette.h"
#include "base/check.h"
#include "formats/game/dem.h"
#include "formats/models/spr.h"
#include "net/protocol/message_writer.h"
#include "support/models/box_models.h"
#include "support/models/drawable_models.h"
#include "support/pictures/small_pictures.h"

namespace temblor::test {
namespace {

using namespace made_recording;
using net::TempEntityKind;

// Indices in the precache lists, from 1.
constexpr std::array<std::string_view, 7> kModels = {
    "maps/small.bsp", "*1", "progs/walker.mdl", "progs/weapon.mdl", "progs/rocket.mdl", "progs/ball.mdl",
    "progs/star.spr"};
enum Model : std::uint16_t {
  kDoorModel = 2,
  kWalkerModel,
  kWeaponModel,
  kRocketModel,
  kBallModel,
  kStarModel
};
constexpr std::array<std::string_view, 2> kSounds = {"weapons/shot.wav", "ambience/drip.wav"};

enum Entity : std::uint16_t { kPlayerEntity = 1, kDoorEntity, kWalkerEntity, kRocketEntity, kStarEntity };

// Bits of ClientData::items and EntityUpdate::effects, as published.
enum Items : std::uint32_t {
  kShotgun = 1u << 0,
  kShells = 1u << 8,
  kArmor2 = 1u << 14,
  kKey1 = 1u << 17,
  kQuad = 1u << 22
};
enum Effect : std::uint8_t { kBrightField = 1, kMuzzleFlash = 2, kBrightLight = 4, kDimLight = 8 };

formats::Spr star_sprite() {
  constexpr int kSide = 24;
  formats::SprPicture picture{-kSide / 2, kSide / 2, kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double dx = std::abs(x - kSide / 2 + 0.5), dy = std::abs(y - kSide / 2 + 0.5);
      const double edge = dx * dy / 12;
      picture.texels.push_back(edge < 1 ? artgen::ramp_color(artgen::Ramp::kFire, 1 - edge)
                                        : artgen::kTransparent);
    }
  formats::Spr sprite;
  sprite.bounding_radius = kSide;
  sprite.max_width = sprite.max_height = kSide;
  sprite.frames = {{{picture}, {}}};
  return sprite;
}

formats::Mdl ball_mdl() {
  constexpr float kUnits = 48;
  formats::Mdl mdl = sphere_mdl();
  mdl.scale *= kUnits / 255;
  mdl.origin *= kUnits / 255;
  return mdl;
}

net::EntityUpdate make_entity_update(std::uint16_t number, std::uint16_t model, const math::Vec3& origin,
                                     float yaw_deg = 0) {
  net::EntityUpdate update;
  update.number = number;
  update.model = model;
  for (int axis = 0; axis < 3; ++axis) update.origin[static_cast<std::size_t>(axis)] = origin[axis];
  update.angles_deg[1] = yaw_deg;
  return update;
}

// Packets are numbered from 0. An event is in the packet of its time.
class Script {
 public:
  explicit Script(const net::Dialect& dialect) : dialect_(dialect) {}
  MadeRecording play();

 private:
  void say(const net::ServerMessage& message);
  void end_record(const math::Vec3& view_angles_deg = math::Vec3(0.0f));
  void sign_on();
  void packet();

  bool at(double second) const { return packet_ == std::lround(second / kPacket_s); }
  bool from_to(double first, double end) const {
    return packet_ >= std::lround(first / kPacket_s) && packet_ < std::lround(end / kPacket_s);
  }
  double second() const { return packet_ * kPacket_s; }
  bool is_over() const { return !from_to(0, 15); }

  void burst(TempEntityKind kind, const math::Vec3& origin) {
    say(net::TempEntity{.kind = kind, .origin = origin});
  }
  void texts();
  void player();
  void shots();
  void explosions();
  void beams();
  void hurt_and_helped();
  void walker();
  void others();
  void ending();

  net::Dialect dialect_;
  formats::DemWriter demo_;
  base::ByteWriter writer_;
  MadeRecording made_;
  int packet_ = 0;
};

void Script::say(const net::ServerMessage& message) {
  CHECK(net::write_message(message, dialect_, writer_).ok(), "{}", net::message_name(message));
  ++made_.messages;
}

void Script::end_record(const math::Vec3& view_angles_deg) {
  demo_.add(view_angles_deg, writer_.view());
  writer_ = {};
  ++made_.records;
}

void Script::sign_on() {
  net::ServerInfo info;
  info.dialect = dialect_;
  info.level_name = "The Small Level";
  info.models = kModels;
  info.sounds = kSounds;
  say(net::Print{"made in code\n"});
  say(info);
  say(net::CdTrack{2, 2});
  say(net::SetView{kPlayerEntity});
  say(net::SignonNumber{1});
  end_record();
  say(net::SpawnBaseline{kPlayerEntity, {.colormap = 1, .origin = kPlayer}});
  say(net::SpawnBaseline{kDoorEntity, {.model = kDoorModel}});
  say(net::SpawnStatic{{.model = kBallModel, .origin = {200, 130, 40}}});
  say(net::SpawnStaticSound{{1216, 224, -150}, 2, 255, 3});
  say(net::SignonNumber{2});
  end_record();
  say(net::UpdateName{0, "Player"});
  say(net::UpdateFrags{0, 0});
  say(net::UpdateColors{0, 4 << 4 | 13});
  say(net::LightStyle{0, "m"});
  say(net::LightStyle{1, "mmnmmommommnonmmonqnmmo"});
  say(net::UpdateStat{11, 2});
  say(net::UpdateStat{12, 4});
  say(net::SetAngle{{0, 0, 0}});
  say(net::SignonNumber{3});
  end_record();
}

void Script::texts() {
  if (at(0)) say(net::CenterPrint{"Made in code"});
  if (at(1)) say(net::Print{"bang\n"});
  if (at(1)) say(net::Sound{.entity = kPlayerEntity, .channel = 1, .sound = 1, .origin = kPlayer});
  if (at(1.5)) say(net::StopSound{kPlayerEntity, 1});
  if (at(7)) say(net::FoundSecret{});
  if (from_to(5, 5.1) || at(6)) say(net::KilledMonster{});
}

void Script::player() {
  net::ClientData data;
  data.on_ground = true;
  data.items = kShotgun | kShells;
  data.active_weapon = kShotgun;
  data.weapon_model = kWeaponModel;
  data.health = from_to(0, 13.5) ? 100 : 42;
  data.ammo = data.shells = from_to(0, 1) ? 25 : 24;
  // Ten frames per second: 1, 2, 3, and back.
  if (from_to(1, 1.3)) data.weapon_frame = static_cast<std::uint16_t>(1 + (packet_ - 20) / 2);
  if (!from_to(0, 14)) {
    data.items |= kArmor2 | kKey1 | kQuad;
    data.armor = 150;
  }
  say(data);
  net::EntityUpdate update = make_entity_update(kPlayerEntity, kWalkerModel, kPlayer);
  if (at(1)) update.effects = kMuzzleFlash;
  if (is_over()) {
    update = make_entity_update(kPlayerEntity, 0, kAboveTheCourt, 45);
    update.angles_deg[0] = 20.0f;
  }
  say(update);
}

void Script::shots() {
  if (at(1)) {
    burst(TempEntityKind::kGunshot, {210, 220, 1});
    burst(TempEntityKind::kGunshot, {230, 300, 1});
  }
  if (at(1.1))
    say(net::Particles{.origin = walker_at(1.1), .direction = {-1, 0, 1}, .count = 60, .color = 73});
  const math::Vec3 before{200, 226, 1};
  if (at(4.0)) burst(TempEntityKind::kSpike, before);
  if (at(4.2)) burst(TempEntityKind::kSuperSpike, before);
  if (at(4.4)) burst(TempEntityKind::kWizSpike, before);
  if (at(4.6)) burst(TempEntityKind::kKnightSpike, before);
}

void Script::explosions() {
  if (at(3)) burst(TempEntityKind::kExplosion, kRocketTo);
  if (at(5)) burst(TempEntityKind::kTarExplosion, kMiddle);
  if (at(6))
    say(net::TempEntity{.kind = TempEntityKind::kExplosion2,
                        .origin = kMiddle,
                        .color_start = kFirstBlue,
                        .color_count = kBlues});
  if (at(7)) burst(TempEntityKind::kTeleport, kMiddle);
  if (at(8)) burst(TempEntityKind::kLavaSplash, {220, 256, 0});
}

void Script::beams() {
  const auto beam = [&](TempEntityKind kind, std::uint16_t entity, const math::Vec3& from,
                        const math::Vec3& to) {
    say(net::TempEntity{.kind = kind, .origin = from, .end = to, .entity = entity});
  };
  if (from_to(11.5, 12)) beam(TempEntityKind::kLightning1, kPlayerEntity, kPlayer, {480, 330, 90});
  if (from_to(12, 12.5)) beam(TempEntityKind::kLightning2, 10, {200, 460, 100}, {200, 60, 100});
  if (from_to(12.5, 13)) beam(TempEntityKind::kLightning3, 11, {240, 256, 190}, {240, 256, 0});
  if (from_to(13, 13.5)) beam(TempEntityKind::kBeam, 12, {300, 60, 30}, {300, 440, 150});
}

void Script::hurt_and_helped() {
  if (at(13.5)) say(net::Damage{.armor = 0, .blood = 58, .from = {300, 256, 40}});
  if (at(14)) say(net::StuffText{"bf\n"});
  if (at(14.5)) say(net::LightStyle{0, "a"});
  if (at(15)) say(net::LightStyle{0, "m"});
}

void Script::walker() {
  if (is_over()) return;
  const bool is_back = !from_to(0, 7);
  if (!is_back && !from_to(0, 4)) return;
  net::EntityUpdate update =
      make_entity_update(kWalkerEntity, kWalkerModel,
                         is_back ? math::Vec3(220, 256, 24) : walker_at(second()), is_back ? 180.0f : -90.0f);
  if (!is_back) update.frame = static_cast<std::uint16_t>(packet_ / 4 % 4);
  if (is_back) update.colormap = 1;
  if (from_to(0, 1)) update.alpha = 0.5f;
  say(update);
}

void Script::others() {
  if (is_over()) return;
  say(make_entity_update(kDoorEntity, kDoorModel, {0, 0, 0}));
  if (from_to(2, 3))
    say(make_entity_update(kRocketEntity, kRocketModel,
                           kRocketFrom + (kRocketTo - kRocketFrom) * static_cast<float>(second() - 2),
                           static_cast<float>(std::atan2(-90.0, 300.0) * 57.29578)));
  if (from_to(10.2, 11.4)) {
    net::EntityUpdate star = make_entity_update(kStarEntity, kStarModel, {200, 300, 70});
    star.effects = from_to(10.2, 10.6) ? kBrightField : from_to(10.6, 11) ? kBrightLight : kDimLight;
    say(star);
  }
}

void Script::ending() {
  if (at(15)) say(net::Intermission{});
}

void Script::packet() {
  say(net::Time{static_cast<float>(kFirstTime_s + second())});
  texts();
  ending();
  player();
  shots();
  explosions();
  beams();
  hurt_and_helped();
  walker();
  others();
  end_record();
}

MadeRecording Script::play() {
  sign_on();
  for (; second() <= kLength_s + kPacket_s / 2; ++packet_) packet();
  say(net::Disconnect{});
  end_record();
  made_.bytes = std::move(demo_).take();
  return std::move(made_);
}

}  // namespace

MadeGame::MadeGame() {
  write_small_pictures(folder());
  const auto write_model = [&](std::string_view name, const formats::Mdl& mdl) {
    folder().write("id1/progs/" + std::string(name), formats::write_mdl(mdl));
  };
  write_model("walker.mdl", walker_mdl());
  write_model("weapon.mdl", weapon_mdl());
  write_model("rocket.mdl", rocket_mdl());
  write_model("ball.mdl", ball_mdl());
  for (const std::string_view name : {"bolt.mdl", "bolt2.mdl", "bolt3.mdl", "beam.mdl"})
    write_model(name, bolt_mdl());
  folder().write("id1/progs/star.spr", formats::write_spr(star_sprite()));
}

MadeRecording make_recording(const net::Dialect& dialect) {
  return Script(dialect).play();
}

}  // namespace temblor::test
