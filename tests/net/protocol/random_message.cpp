#include "net/protocol/random_message.h"

#include <array>
#include <variant>

namespace temblor::test {
namespace {

using namespace net;

// Random fields in the resolution of the dialect, computed independently from the protocol description.
class RandomFields {
 public:
  RandomFields(Random& random, const Dialect& dialect)
      : random_(random), dialect_(dialect), extended_(dialect.protocol != Protocol::kNetQuake) {}

  // In [low, high]; both ends are frequent.
  std::int64_t whole(std::int64_t low, std::int64_t high) {
    if (random_.chance(0.1)) return random_.chance(0.5) ? low : high;
    return low + static_cast<std::int64_t>(random_.below(static_cast<std::size_t>(high - low + 1)));
  }
  std::uint8_t u8() { return static_cast<std::uint8_t>(whole(0, 255)); }
  std::int16_t i16() { return static_cast<std::int16_t>(whole(-32768, 32767)); }
  std::int32_t i32() { return static_cast<std::int32_t>(whole(-0x80000000ll, 0x7fffffff)); }
  // A number that has a second byte since FitzQuake.
  std::uint16_t wide() {
    return static_cast<std::uint16_t>(extended_ && random_.chance(0.3) ? whole(0, 65535) : whole(0, 255));
  }
  std::uint16_t entity() { return static_cast<std::uint16_t>(whole(0, kMaxEntities - 1)); }
  std::uint16_t packed_entity() { return static_cast<std::uint16_t>(whole(0, 8191)); }
  std::uint8_t packed_channel() { return static_cast<std::uint8_t>(whole(0, 7)); }
  bool flag() { return random_.chance(0.5); }

  float coord() {
    const bool rmq = dialect_.protocol == Protocol::kRmq;
    if (rmq && (dialect_.flags & kFloatCoord)) return static_cast<float>(random_.uniform(-1e6, 1e6));
    if (rmq && (dialect_.flags & kInt32Coord)) return static_cast<float>(whole(-1 << 24, 1 << 24)) / 16;
    if (rmq && (dialect_.flags & k24BitCoord))
      return static_cast<float>(whole(-32768, 32766)) + static_cast<float>(whole(0, 254)) / 255;
    return static_cast<float>(i16()) / 8;
  }
  float angle() {
    const bool rmq = dialect_.protocol == Protocol::kRmq;
    if (rmq && (dialect_.flags & kFloatAngle)) return static_cast<float>(random_.uniform(-720, 720));
    if (rmq && (dialect_.flags & kShortAngle)) return static_cast<float>(i16()) * 360 / 65536;
    return static_cast<float>(whole(-128, 127)) * 360 / 256;
  }
  math::Vec3 coords() { return {coord(), coord(), coord()}; }
  math::Vec3 angles() { return {angle(), angle(), angle()}; }
  float signed_byte(float step) { return static_cast<float>(whole(-128, 127)) * step; }
  float byte_over(float steps) { return static_cast<float>(u8()) / steps; }
  float alpha() { return extended_ && flag() ? static_cast<float>(whole(0, 254)) / 254 : 1.0f; }
  float scale() { return extended_ && flag() ? byte_over(16) : 1.0f; }
  std::string_view text() {
    constexpr std::array<std::string_view, 6> kTexts = {"",
                                                        "a",
                                                        "hello\n",
                                                        "\x01\xff\x80",
                                                        "maps/start.bsp",
                                                        "unnamed \"quoted\" text that goes on for a while"};
    return kTexts[random_.below(kTexts.size())];
  }
  template <typename T, typename Make>
  void maybe(std::optional<T>& out_field, Make make) {
    if (random_.chance(0.4)) out_field = make();
  }

  bool extended() const { return extended_; }

 private:
  Random& random_;
  Dialect dialect_;
  bool extended_;
};

Baseline random_baseline(RandomFields& f) {
  return {f.wide(), f.wide(), f.u8(), f.u8(), f.coords(), f.angles(), f.alpha(), f.scale()};
}

EntityUpdate random_update(RandomFields& f) {
  EntityUpdate update{.number = f.entity()};
  if (f.flag()) update.number = f.u8();
  f.maybe(update.model, [&] { return f.wide(); });
  f.maybe(update.frame, [&] { return f.wide(); });
  f.maybe(update.colormap, [&] { return f.u8(); });
  f.maybe(update.skin, [&] { return f.u8(); });
  f.maybe(update.effects, [&] { return f.u8(); });
  for (auto& coord : update.origin) f.maybe(coord, [&] { return f.coord(); });
  for (auto& angle : update.angles_deg) f.maybe(angle, [&] { return f.angle(); });
  update.step = f.flag();
  if (!f.extended()) return update;
  f.maybe(update.alpha, [&] { return f.alpha(); });
  f.maybe(update.scale, [&] { return f.scale(); });
  f.maybe(update.next_think_s, [&] { return f.byte_over(255); });
  return update;
}

ClientData random_client_data(RandomFields& f) {
  ClientData data;
  if (f.flag()) data.view_height = f.signed_byte(1);
  if (f.flag()) data.ideal_pitch_deg = f.signed_byte(1);
  for (int axis = 0; axis < 3; ++axis) {
    if (f.flag()) data.punch_deg[axis] = f.signed_byte(1);
    if (f.flag()) data.velocity[axis] = f.signed_byte(16);
  }
  data.items = static_cast<std::uint32_t>(f.i32());
  data.on_ground = f.flag();
  data.in_water = f.flag();
  data.health = f.i16();
  for (const auto field :
       {&ClientData::weapon_frame, &ClientData::armor, &ClientData::weapon_model, &ClientData::ammo,
        &ClientData::shells, &ClientData::nails, &ClientData::rockets, &ClientData::cells})
    data.*field = f.wide();
  data.active_weapon = f.u8();
  data.weapon_alpha = f.alpha();
  return data;
}

Sound random_sound(RandomFields& f) {
  Sound sound;
  if (f.flag()) sound.volume = f.u8();
  if (f.flag()) sound.attenuation = f.byte_over(64);
  const bool wide = f.extended() && f.flag();
  sound.entity = wide ? f.entity() : f.packed_entity();
  sound.channel = wide ? f.u8() : f.packed_channel();
  sound.sound = f.wide();
  sound.origin = f.coords();
  return sound;
}

TempEntity random_temp_entity(RandomFields& f) {
  TempEntity entity{TempEntityKind{static_cast<std::uint8_t>(f.whole(0, 13))}};
  entity.origin = f.coords();
  switch (entity.kind) {
    case TempEntityKind::kLightning1:
    case TempEntityKind::kLightning2:
    case TempEntityKind::kLightning3:
    case TempEntityKind::kBeam:
      entity.entity = f.entity();
      entity.end = f.coords();
      break;
    case TempEntityKind::kExplosion2:
      entity.color_start = f.u8();
      entity.color_count = f.u8();
      break;
    default:
      break;
  }
  return entity;
}

Particles random_particles(RandomFields& f) {
  const math::Vec3 direction{f.signed_byte(1 / 16.0f), f.signed_byte(1 / 16.0f), f.signed_byte(1 / 16.0f)};
  const auto count = static_cast<std::uint16_t>(f.flag() ? 1024 : f.whole(0, 254));
  return {f.coords(), direction, count, f.u8()};
}

}  // namespace

ServerMessage random_message(Random& random, const Dialect& dialect) {
  RandomFields f(random, dialect);
  static constexpr std::array<std::string_view, 2> kChat = {"$chat {0}", ""};
  switch (random.below(f.extended() ? 38 : 35)) {
    case 0:
      return Nop{};
    case 1:
      return Disconnect{};
    case 2:
      return UpdateStat{f.u8(), f.i32()};
    case 3:
      return Version{f.i32()};
    case 4:
      return SetView{f.entity()};
    case 5:
      return random_sound(f);
    case 6:
      return Time{static_cast<float>(random.log_uniform(1e-3, 1e9))};
    case 7:
      return Print{f.text()};
    case 8:
      return StuffText{f.text()};
    case 9:
      return CenterPrint{f.text()};
    case 10:
      return SetAngle{f.angles()};
    case 11:
      return UpdateFrags{f.u8(), f.i16()};
    case 12: {
      LightStyle style;
      style.style = f.u8();
      style.pattern = f.text();
      return style;
    }
    case 13: {
      UpdateName update;
      update.client = f.u8();
      update.name = f.text();
      return update;
    }
    case 14:
      return UpdateColors{f.u8(), f.u8()};
    case 15:
    case 16:
    case 17:
      return random_client_data(f);
    case 18:
      return StopSound{f.packed_entity(), f.packed_channel()};
    case 19:
      return random_particles(f);
    case 20:
      return Damage{f.u8(), f.u8(), f.coords()};
    case 21:
      return SpawnStatic{random_baseline(f)};
    case 22:
      return SpawnBaseline{f.entity(), random_baseline(f)};
    case 23:
    case 24:
    case 25:
      return random_update(f);
    case 26:
      return random_temp_entity(f);
    case 27:
      return SetPause{f.flag()};
    case 28:
      return SignonNumber{f.u8()};
    case 29:
      return f.flag() ? ServerMessage(KilledMonster{}) : ServerMessage(FoundSecret{});
    case 30:
      return SpawnStaticSound{f.coords(), f.wide(), f.u8(), f.byte_over(64)};
    case 31:
      return f.flag() ? ServerMessage(Intermission{}) : ServerMessage(SellScreen{});
    case 32:
      return f.flag() ? ServerMessage(Finale{f.text()}) : ServerMessage(CutScene{f.text()});
    case 33:
      return CdTrack{f.u8(), f.u8()};
    case 34:
      return BotChat{f.u8(), kChat};
    case 35:
      return Skybox{f.text()};
    case 36:
      return BonusFlash{};
    default:
      return Fog{f.byte_over(255),
                 {f.byte_over(255), f.byte_over(255), f.byte_over(255)},
                 static_cast<float>(f.whole(0, 32767)) / 100};
  }
}

}  // namespace temblor::test
