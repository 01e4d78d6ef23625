// Every message as hand-made bytes from the protocol description: read, and written again.
#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

#include "net/protocol/dialects.h"
#include "net/protocol/message_text.h"

namespace temblor::net {
namespace {

using test::k15;
using test::k666;
using test::k999;
using test::make_reader;

// Builds bytes from numbers, and text without a terminating zero.
class Packet {
 public:
  Packet(std::initializer_list<int> bytes) { add(bytes); }
  Packet& add(std::initializer_list<int> bytes) {
    for (const int byte : bytes) writer_.u8(static_cast<std::uint8_t>(byte));
    return *this;
  }
  Packet& text(std::string_view text) {
    writer_.bytes(base::as_bytes(text));
    return *this;
  }
  Packet& f32(float value) {
    writer_.f32(value);
    return *this;
  }
  const base::ByteVector& bytes() const { return writer_.view(); }

 private:
  base::ByteWriter writer_;
};

void expect_read(const Dialect& dialect, const Packet& packet, const ServerMessage& expected) {
  MessageReader reader = make_reader(dialect);
  reader.begin(packet.bytes());
  const auto message = reader.next();
  ASSERT_TRUE(message.ok()) << message.error().message();
  ASSERT_TRUE(message->has_value());
  EXPECT_EQ(test::get_text(**message), test::get_text(expected));
  const auto end = reader.next();
  ASSERT_TRUE(end.ok()) << end.error().message();
  EXPECT_FALSE(end->has_value()) << "unread bytes";
}

void expect_written(const Dialect& dialect, const Packet& packet, const ServerMessage& message) {
  base::ByteWriter writer;
  const base::Status status = write_message(message, dialect, writer);
  ASSERT_TRUE(status.ok()) << status.error().message();
  EXPECT_EQ(writer.view(), packet.bytes()) << test::get_text(message);
}

void expect_both_ways(const Dialect& dialect, const Packet& packet, const ServerMessage& message) {
  SCOPED_TRACE(test::get_text(message));
  expect_read(dialect, packet, message);
  expect_written(dialect, packet, message);
}

void expect_in_all(const Packet& packet, const ServerMessage& message) {
  for (const Dialect& dialect : {k15, k666, k999}) expect_both_ways(dialect, packet, message);
}

TEST(MessageBytes, MessagesWithoutFields) {
  expect_in_all({1}, Nop{});
  expect_in_all({2}, Disconnect{});
  expect_in_all({27}, KilledMonster{});
  expect_in_all({28}, FoundSecret{});
  expect_in_all({30}, Intermission{});
  expect_in_all({33}, SellScreen{});
}

TEST(MessageBytes, NumbersAndText) {
  expect_in_all({3, 12, 0x04, 0x03, 0x02, 0x81},
                UpdateStat{12, std::numeric_limits<std::int32_t>::min() + 0x1020304});
  expect_in_all({4, 15, 0, 0, 0}, Version{15});
  expect_in_all({5, 0x34, 0x12}, SetView{0x1234});
  expect_in_all(Packet{7}.f32(1.25f), Time{1.25f});
  expect_in_all(Packet{8}.text("hi\n").add({0}), Print{"hi\n"});
  expect_in_all(Packet{9}.text("bf\n").add({0}), StuffText{"bf\n"});
  expect_in_all({26, 0}, CenterPrint{""});
  expect_in_all(Packet{12, 63}.text("az").add({0}), LightStyle{63, "az"});
  expect_in_all(Packet{13, 3}.text("Ranger").add({0}), UpdateName{3, "Ranger"});
  expect_in_all({14, 3, 0xfe, 0xff}, UpdateFrags{3, -2});
  expect_in_all({17, 3, 0x4d}, UpdateColors{3, 0x4d});
  expect_in_all({24, 1}, SetPause{true});
  expect_in_all({24, 0}, SetPause{false});
  expect_in_all({25, 4}, SignonNumber{4});
  expect_in_all(Packet{31}.text("The end").add({0}), Finale{"The end"});
  expect_in_all({32, 5, 6}, CdTrack{5, 6});
  expect_in_all(Packet{34}.text("x").add({0}), CutScene{"x"});
}

TEST(MessageBytes, NamesMatchProtocol) {
  const std::vector<std::pair<ServerMessage, std::string>> names = {
      {Nop{}, "svc_nop"},
      {Disconnect{}, "svc_disconnect"},
      {UpdateStat{}, "svc_updatestat"},
      {Version{}, "svc_version"},
      {SetView{}, "svc_setview"},
      {Sound{}, "svc_sound"},
      {Time{}, "svc_time"},
      {Print{}, "svc_print"},
      {StuffText{}, "svc_stufftext"},
      {CenterPrint{}, "svc_centerprint"},
      {SetAngle{}, "svc_setangle"},
      {ServerInfo{}, "svc_serverinfo"},
      {LightStyle{}, "svc_lightstyle"},
      {UpdateName{}, "svc_updatename"},
      {UpdateFrags{}, "svc_updatefrags"},
      {UpdateColors{}, "svc_updatecolors"},
      {ClientData{}, "svc_clientdata"},
      {StopSound{}, "svc_stopsound"},
      {Particles{}, "svc_particle"},
      {Damage{}, "svc_damage"},
      {SpawnStatic{}, "svc_spawnstatic"},
      {SpawnBaseline{}, "svc_spawnbaseline"},
      {EntityUpdate{}, "fast update"},
      {TempEntity{}, "svc_temp_entity"},
      {SetPause{}, "svc_setpause"},
      {SignonNumber{}, "svc_signonnum"},
      {KilledMonster{}, "svc_killedmonster"},
      {FoundSecret{}, "svc_foundsecret"},
      {SpawnStaticSound{}, "svc_spawnstaticsound"},
      {Intermission{}, "svc_intermission"},
      {SellScreen{}, "svc_sellscreen"},
      {Finale{}, "svc_finale"},
      {CutScene{}, "svc_cutscene"},
      {CdTrack{}, "svc_cdtrack"},
      {Skybox{}, "svc_skybox"},
      {BonusFlash{}, "svc_bf"},
      {Fog{}, "svc_fog"},
      {BotChat{}, "svc_botchat"},
      {Ignored{52}, "svc_achievement"},
      {Ignored{54}, "svc_levelcompleted"},
      {Ignored{55}, "svc_backtolobby"},
  };
  for (const auto& [message, name] : names) EXPECT_EQ(message_name(message), name);
}

TEST(MessageBytes, ServerInfoOfEachProtocol) {
  const std::array<std::string_view, 2> models = {"maps/e1m1.bsp", "*1"};
  const std::array<std::string_view, 1> sounds = {"a.wav"};
  const auto packet = [](std::initializer_list<int> protocol) {
    return Packet{11}
        .add(protocol)
        .add({4, 1})
        .text("Slipgate")
        .add({0})
        .text("maps/e1m1.bsp")
        .add({0, '*', '1', 0, 0})
        .text("a.wav")
        .add({0, 0});
  };
  const auto info = [&](const Dialect& dialect) {
    return ServerInfo{dialect, 4, 1, "Slipgate", models, sounds};
  };
  expect_both_ways(k15, packet({15, 0, 0, 0}), info(k15));
  expect_both_ways(k15, packet({0x9a, 0x02, 0, 0}), info(k666));
  expect_both_ways(k15, packet({0xe7, 0x03, 0, 0, 0x82, 0, 0, 0}), info(k999));
}

TEST(MessageBytes, LastServerInfoSetsDialect) {
  const Packet packet = Packet{11, 15, 0, 0, 0, 1, 0, 0, 0, 0}  //
                            .add({10, 64, 0, 0})                // setangle: bytes
                            .add({11, 0xe7, 3, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 0})
                            .add({10, 0, 64, 0, 0, 0, 0});  // setangle: 16 bits
  MessageReader reader;
  reader.begin(packet.bytes());
  for (const Dialect& dialect : {Dialect{}, Dialect{Protocol::kRmq, kShortAngle}}) {
    ASSERT_TRUE(reader.next().ok());
    EXPECT_EQ(reader.dialect(), dialect);
    const auto angle = reader.next();
    ASSERT_TRUE(angle.ok());
    EXPECT_EQ(std::get<SetAngle>(**angle).angles_deg.x, 90);
  }
  EXPECT_FALSE(reader.next()->has_value());
}

TEST(MessageBytes, CoordinatesAndAnglesOfEachEncoding) {
  const auto damage = [](float coord) { return Damage{1, 2, {coord, 0, 0}}; };
  expect_both_ways(k15, {19, 1, 2, 0xff, 0xff, 0, 0, 0, 0}, damage(-0.125f));
  expect_both_ways(k666, {19, 1, 2, 0x09, 0x00, 0, 0, 0, 0}, damage(1.125f));
  const Dialect int32{Protocol::kRmq, kInt32Coord};
  expect_both_ways(int32, {19, 1, 2, 0x01, 0x00, 0x10, 0x00, 0, 0, 0, 0, 0, 0, 0, 0}, damage(65536.0625f));
  const Dialect wide{Protocol::kRmq, k24BitCoord};
  expect_both_ways(wide, {19, 1, 2, 0xfe, 0xff, 51, 0, 0, 0, 0, 0, 0}, damage(-2 + 51 / 255.0f));
  const Dialect floats{Protocol::kRmq, kFloatCoord | kFloatAngle};
  expect_both_ways(floats, Packet{19, 1, 2}.f32(0.3f).f32(0).f32(0), damage(0.3f));

  const auto angle = [](float angle_deg) { return SetAngle{{0, angle_deg, 0}}; };
  expect_both_ways(k15, {10, 0, 0xc0, 0}, angle(-90));
  expect_both_ways(k999, {10, 0, 0, 1, 0, 0, 0}, angle(360.0f / 65536));
  expect_both_ways(floats, Packet{10}.f32(0).f32(359.5f).f32(0), angle(359.5f));
  // 24-bit coordinates do not affect angles.
  expect_both_ways(wide, {10, 0, 1, 0}, angle(360.0f / 256));
}

TEST(MessageBytes, FlagsThatChangeNoEncoding) {
  const Dialect dialect{Protocol::kRmq, kEdictScale | kAlphaSanity};
  expect_both_ways(dialect, {19, 1, 2, 8, 0, 0, 0, 0, 0}, Damage{1, 2, {1, 0, 0}});
}

TEST(MessageBytes, WidestEncodingWins) {
  const Dialect dialect{Protocol::kRmq, k24BitCoord | kFloatCoord | kInt32Coord | kShortAngle | kFloatAngle};
  expect_both_ways(dialect, Packet{19, 1, 2}.f32(8).f32(0).f32(0), Damage{1, 2, {8, 0, 0}});
  expect_both_ways(dialect, Packet{10}.f32(8).f32(0).f32(0), SetAngle{{8, 0, 0}});
}

TEST(MessageBytes, RoundsToTheNearest) {
  expect_written(k15, {19, 1, 2, 2, 0, 0xfe, 0xff, 0, 0}, Damage{1, 2, {0.2f, -0.2f, 0.05f}});
  expect_written(k15, {10, 1, 0xff, 0}, SetAngle{{1.0f, -1.0f, 359.5f}});
  // Several turns, and half a turn either way.
  expect_written(k15, {10, 64, 128, 128}, SetAngle{{90 + 720, 180, -180}});
}

TEST(MessageBytes, Sounds) {
  const Sound plain{.entity = 5, .channel = 2, .sound = 9, .origin = {1, 2, -1}};
  expect_both_ways(k15, {6, 0, 5 << 3 | 2, 0, 9, 8, 0, 16, 0, 0xf8, 0xff}, plain);
  Sound sound = plain;
  sound.volume = 100;
  expect_both_ways(k15, {6, 1, 100, 42, 0, 9, 8, 0, 16, 0, 0xf8, 0xff}, sound);
  sound.attenuation = 0.5f;
  expect_both_ways(k666, {6, 3, 100, 32, 42, 0, 9, 8, 0, 16, 0, 0xf8, 0xff}, sound);
  sound.volume = 255;
  expect_both_ways(k15, {6, 2, 32, 42, 0, 9, 8, 0, 16, 0, 0xf8, 0xff}, sound);
  sound = plain;
  sound.entity = 8191;
  sound.channel = 7;
  expect_both_ways(k15, {6, 0, 0xff, 0xff, 9, 8, 0, 16, 0, 0xf8, 0xff}, sound);
  sound.entity = 8192;
  expect_both_ways(k666, {6, 8, 0x00, 0x20, 7, 9, 8, 0, 16, 0, 0xf8, 0xff}, sound);
  sound.entity = 5;
  sound.channel = 8;
  expect_both_ways(k666, {6, 8, 5, 0, 8, 9, 8, 0, 16, 0, 0xf8, 0xff}, sound);
  sound = plain;
  sound.sound = 0x123;
  expect_both_ways(k666, {6, 16, 42, 0, 0x23, 0x01, 8, 0, 16, 0, 0xf8, 0xff}, sound);
  expect_in_all({16, 42, 0}, StopSound{5, 2});
}

TEST(MessageBytes, StaticSounds) {
  const SpawnStaticSound sound{{1, 2, -1}, 9, 128, 3};
  expect_both_ways(k15, {29, 8, 0, 16, 0, 0xf8, 0xff, 9, 128, 192}, sound);
  expect_both_ways(k666, {44, 8, 0, 16, 0, 0xf8, 0xff, 0x00, 0x01, 128, 192},
                   SpawnStaticSound{{1, 2, -1}, 256, 128, 3});
  expect_read(k15, {44, 8, 0, 16, 0, 0xf8, 0xff, 9, 0, 128, 192}, sound);
}

TEST(MessageBytes, Particles) {
  expect_both_ways(k15, {18, 8, 0, 0, 0, 0, 0, 16, 0xf0, 0x80, 254, 73},
                   Particles{{1, 0, 0}, {1, -1, -8}, 254, 73});
  expect_both_ways(k15, {18, 8, 0, 0, 0, 0, 0, 0, 0, 0, 255, 0}, Particles{{1, 0, 0}, {0, 0, 0}, 1024, 0});
  expect_written(k15, {18, 0, 0, 0, 0, 0, 0, 127, 0x80, 2, 1, 0},
                 Particles{{0, 0, 0}, {1e9f, -1e9f, 0.1f}, 1, 0});
}

TEST(MessageBytes, TemporaryEntities) {
  for (const int kind : {0, 1, 2, 3, 4, 7, 8, 10, 11}) {
    TempEntity entity{TempEntityKind{static_cast<std::uint8_t>(kind)}};
    entity.origin = {1, 0, -1};
    expect_both_ways(k15, {23, kind, 8, 0, 0, 0, 0xf8, 0xff}, entity);
  }
  for (const int kind : {5, 6, 9, 13}) {
    TempEntity beam{TempEntityKind{static_cast<std::uint8_t>(kind)}};
    beam.entity = 0x102;
    beam.origin = {1, 0, -1};
    beam.end = {0, 2, 0};
    expect_both_ways(k15, {23, kind, 2, 1, 8, 0, 0, 0, 0xf8, 0xff, 0, 0, 16, 0, 0, 0}, beam);
  }
  TempEntity explosion{TempEntityKind::kExplosion2, {1, 0, -1}};
  explosion.color_start = 200;
  explosion.color_count = 5;
  expect_both_ways(k15, {23, 12, 8, 0, 0, 0, 0xf8, 0xff, 200, 5}, explosion);
}

TEST(MessageBytes, Baselines) {
  Baseline baseline{3, 4, 5, 6, {1, 2, -1}, {90, -90, 0}};
  const std::initializer_list<int> place = {5, 6, 8, 0, 64, 16, 0, 192, 0xf8, 0xff, 0};
  expect_both_ways(k15, Packet{22, 7, 1, 3, 4}.add(place), SpawnBaseline{0x107, baseline});
  expect_both_ways(k15, Packet{20, 3, 4}.add(place), SpawnStatic{baseline});
  expect_both_ways(k666, Packet{20, 3, 4}.add(place), SpawnStatic{baseline});
  expect_read(k666, Packet{43, 0, 3, 4}.add(place), SpawnStatic{baseline});
  baseline.alpha = 0;
  expect_both_ways(k666, Packet{42, 7, 1, 4, 3, 4}.add(place).add({1}), SpawnBaseline{0x107, baseline});
  baseline.scale = 2.5f;
  expect_both_ways(k666, Packet{43, 12, 3, 4}.add(place).add({1, 40}), SpawnStatic{baseline});
  baseline.alpha = 1;
  baseline.model = 0x301;
  expect_both_ways(k666, Packet{43, 9, 1, 3, 4}.add(place).add({40}), SpawnStatic{baseline});
  baseline.frame = 0x204;
  expect_both_ways(k666, Packet{42, 7, 1, 11, 1, 3, 4, 2}.add(place).add({40}),
                   SpawnBaseline{0x107, baseline});
  // Protocol 15 omits fields that it does not have.
  expect_written(k15, Packet{20, 3, 4}.add(place),
                 SpawnStatic{{3, 4, 5, 6, {1, 2, -1}, {90, -90, 0}, 0.5f, 3}});
}

TEST(MessageBytes, EntityUpdates) {
  EntityUpdate update{.number = 7};
  expect_both_ways(k15, {0x80, 7}, update);
  update.step = true;
  expect_both_ways(k15, {0xa0, 7}, update);
  update.step = false;
  update.frame = 3;
  expect_both_ways(k15, {0xc0, 7, 3}, update);
  update.origin[1] = 2.0f;
  update.angles_deg[1] = 90.0f;
  expect_both_ways(k15, {0x80 | 64 | 4 | 16, 7, 3, 16, 0, 64}, update);
  // Every field of protocol 15, in wire order.
  const EntityUpdate all{.number = 0x1234,
                         .model = 1,
                         .frame = 2,
                         .colormap = 3,
                         .skin = 4,
                         .effects = 5,
                         .origin = {1, 2, 3},
                         .angles_deg = {90, -90, 45},
                         .step = true};
  expect_both_ways(k15, {0xff, 0x7f, 0x34, 0x12, 1, 2, 3, 4, 5, 8, 0, 64, 16, 0, 192, 24, 0, 32}, all);
  expect_both_ways(k999, {0xff, 0x7f, 0x34, 0x12, 1, 2, 3,   4,  5, 16, 0, 0, 0, 0,
                          64,   32,   0,    0,    0, 0, 192, 48, 0, 0,  0, 0, 32},
                   all);
}

TEST(MessageBytes, EntityUpdatesOfFitzQuake) {
  EntityUpdate update{.number = 7};
  update.alpha = 0.5f;
  update.scale = 3.5f;
  update.next_think_s = 0.2f;
  update.model = 0x102;
  update.frame = 0x304;
  // Alpha byte 128 is 127 / 254.
  expect_both_ways(k666, {0x80 | 64 | 1, 0x80 | 4, 0x1f, 7, 2, 4, 128, 56, 3, 1, 51}, update);
  expect_read(k666, {0x80 | 64 | 1, 0x80 | 4, 0x9f, 0, 7, 2, 4, 128, 56, 3, 1, 51}, update);
  // Protocol 15 does not have three of these fields.
  update.model = 2;
  update.frame = 4;
  expect_written(k15, {0x80 | 64 | 1, 4, 7, 2, 4}, update);
}

TEST(MessageBytes, Alpha) {
  const auto update = [](float alpha) { return EntityUpdate{.number = 7, .alpha = alpha}; };
  const auto packet = [](int byte) { return Packet{0x81, 0x80, 1, 7, byte}; };
  expect_read(k666, packet(0), update(1));
  expect_both_ways(k666, packet(1), update(0));
  expect_both_ways(k666, packet(2), update(1 / 254.0f));
  expect_both_ways(k666, packet(254), update(253 / 254.0f));
  expect_both_ways(k666, packet(255), update(1));
  expect_written(k666, packet(255), update(7));
  expect_written(k666, packet(1), update(-7));
  expect_written(k666, packet(1), update(std::numeric_limits<float>::quiet_NaN()));
}

// Flags that are always set: items and weapon model.
constexpr int kBits1 = 2 | 64;

TEST(MessageBytes, ClientDataWithDefaults) {
  expect_in_all({15, 0, kBits1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, ClientData{});
  // Without its flag, the weapon byte is absent; the items are present even without theirs.
  expect_read(k15, {15, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, ClientData{});
}

TEST(MessageBytes, ClientDataWithEverything) {
  ClientData data{.view_height = -8,
                  .ideal_pitch_deg = 5,
                  .punch_deg = {-1, 2, 3},
                  .velocity = {320, -16, 48},
                  .items = 0x80000001,
                  .on_ground = true,
                  .in_water = true,
                  .weapon_frame = 9,
                  .armor = 200,
                  .weapon_model = 77,
                  .health = -12,
                  .ammo = 1,
                  .shells = 2,
                  .nails = 3,
                  .rockets = 4,
                  .cells = 5,
                  .active_weapon = 32};
  const std::initializer_list<int> axes = {0xf8, 5, 0xff, 20, 2, 0xff, 3, 3};
  expect_in_all(Packet{15, 0xff, kBits1 | 4 | 8 | 16 | 32}.add(axes).add(
                    {1, 0, 0, 0x80, 9, 200, 77, 0xf4, 0xff, 1, 2, 3, 4, 5, 32}),
                data);
  data.weapon_frame += 0x800;
  data.armor += 0x100;
  data.weapon_model += 0x200;
  data.ammo += 0x300;
  data.shells += 0x400;
  data.nails += 0x500;
  data.rockets += 0x600;
  data.cells += 0x700;
  data.weapon_alpha = 0;
  expect_both_ways(k666,
                   Packet{15, 0xff, 0xff - 1, 0xff, 3}.add(axes).add(
                       {1, 0, 0, 0x80, 9, 200, 77, 0xf4, 0xff, 1, 2, 3, 4, 5, 32, 2, 1, 3, 4, 5, 6, 7, 8, 1}),
                   data);
}

TEST(MessageBytes, ClientDataRoundsAndClamps) {
  const ClientData data{
      .view_height = 21.7f, .ideal_pitch_deg = 0.4f, .punch_deg = {-200, 0, 0}, .velocity = {1e9f, 7.9f, 8}};
  expect_written(k15, {15, 4 | 32 | 128, kBits1, 0x80, 127, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, data);
}

TEST(MessageBytes, FitzQuakeMessages) {
  for (const Dialect& dialect : {k666, k999}) {
    expect_both_ways(dialect, Packet{37}.text("unit1_").add({0}), Skybox{"unit1_"});
    expect_both_ways(dialect, {40}, BonusFlash{});
    expect_both_ways(dialect, {41, 51, 255, 0, 102, 0xfa, 0x00}, Fog{0.2f, {1, 0, 0.4f}, 2.5f});
  }
  // A negative time becomes 0.
  expect_read(k666, {41, 51, 255, 0, 102, 0xff, 0xff}, Fog{0.2f, {1, 0, 0.4f}, 0});
}

TEST(MessageBytes, AcceptsFitzQuakeMessagesInProtocol15) {
  expect_read(k15, {40}, BonusFlash{});
  expect_read(k15, {41, 51, 255, 0, 102, 0, 0}, Fog{0.2f, {1, 0, 0.4f}, 0});
  for (const ServerMessage& message :
       {ServerMessage(Skybox{"x"}), ServerMessage(BonusFlash{}), ServerMessage(Fog{})}) {
    base::ByteWriter writer;
    EXPECT_TRUE(write_message(message, k15, writer).ok());
    EXPECT_EQ(writer.size(), 0u) << test::get_text(message);
  }
}

// 8, 16, 24 units in eighths.
constexpr std::initializer_list<int> kPlace = {64, 0, 128, 0, 192, 0};

TEST(MessageBytes, ReadsEffectsOfDarkPlaces) {
  const auto effect = [](int kind) { return Packet{23, kind}.add(kPlace); };
  const math::Vec3 place{8, 16, 24};
  expect_read(k15, effect(50).add({0xf0, 0, 32, 20}),
              Particles{.origin = place, .direction = {-1, 0, 2}, .count = 20, .color = 73});
  expect_read(k15, effect(50).add({0, 0, 0, 255}), Particles{.origin = place, .count = 254, .color = 73});
  expect_read(k15, effect(53).add({255, 0, 0}), TempEntity{TempEntityKind::kExplosion, place});
  expect_read(k15, effect(57), TempEntity{TempEntityKind::kGunshot, place});
  expect_read(k15, effect(58), TempEntity{TempEntityKind::kSpike, place});
  expect_read(k15, effect(59), TempEntity{TempEntityKind::kSuperSpike, place});
  expect_read(k15, effect(70), TempEntity{TempEntityKind::kExplosion, place});
  const Ignored ignored{23};
  expect_read(k15, effect(51).add({0, 0, 0, 9}), ignored);
  expect_read(k15, effect(52).add(kPlace).add({0, 1, 50, 0}), ignored);
  expect_read(k15, effect(54).add(kPlace).add(kPlace).add({50, 0, 4, 1, 0, 1}), ignored);
  for (const int rain_or_snow : {55, 56})
    expect_read(k15, effect(rain_or_snow).add(kPlace).add(kPlace).add({50, 0, 4}), ignored);
  for (const int flash_or_plasma : {72, 75}) expect_read(k15, effect(flash_or_plasma), ignored);
  expect_read(k15, effect(73).add({10, 10, 255, 0, 0}), ignored);
  expect_read(k15, effect(74).add(kPlace).add({9}), ignored);
  expect_read(k15, Packet{52}.add(kPlace).add({3, 0, 6, 10}), Ignored{52});
}

TEST(MessageBytes, ReadsMessagesOf2021WithKnownLength) {
  expect_read(k666, Packet{52}.text("ACH_X").add({0}), Ignored{52});
  for (const std::uint8_t id : {std::uint8_t{54}, std::uint8_t{55}}) expect_read(k666, {id}, Ignored{id});
  expect_read(k666, {56, 0, 7}, Sound{.attenuation = 0, .sound = 7});
  expect_read(k666, {56, 16, 7, 1}, Sound{.attenuation = 0, .sound = 263});
  const std::array<std::string_view, 2> texts = {"$chat {0}", "Ann"};
  expect_both_ways(k666, Packet{38, 3, 2, 0}.text("$chat {0}").add({0}).text("Ann").add({0}),
                   BotChat{3, texts});
  expect_both_ways(k666, {38, 0, 0, 0}, BotChat{});
  expect_read(k666, {38, 0, 0xff, 0xff}, BotChat{});
  base::ByteWriter writer;
  EXPECT_TRUE(write_message(Ignored{52}, k666, writer).ok());
  EXPECT_EQ(writer.size(), 0u);
}

}  // namespace
}  // namespace temblor::net
