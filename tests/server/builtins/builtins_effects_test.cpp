// Sounds, particles and light styles: what clients are sent, and what is an error.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "server/builtins/builtin_stage.h"

namespace temblor::test {
namespace {

using math::Vec3;
using server::Solid;
using ::testing::HasSubstr;
namespace field = server::field;

class Effects : public ::testing::Test {
 protected:
  Effects() {
    stage.run("precache_sound", "a.wav");
    stage.run("precache_sound", "b.wav");
    thing = stage.spawn_box({256, 256, 64}, Solid::kBox);
    stage.edict(thing).set(field::kMaxs, Vec3(16, 16, 48));
  }
  std::vector<net::Sound> sounds() { return messages_in<net::Sound>(stage.outbox.placed_bytes()); }
  std::vector<net::Particles> particles() { return messages_in<net::Particles>(stage.outbox.placed_bytes()); }

  Stage stage;
  vm::EntityIndex thing{};
};

TEST_F(Effects, SoundComesFromTheMiddleOfTheBox) {
  stage.run("sound", thing, 3, "b.wav", 0.5f, 2);
  ASSERT_EQ(sounds().size(), 1u);
  const net::Sound sound = sounds()[0];
  EXPECT_EQ(sound.entity, 3);
  EXPECT_EQ(sound.channel, 3);
  EXPECT_EQ(sound.sound, 2);
  EXPECT_EQ(sound.volume, 127) << "truncated, not rounded";
  EXPECT_EQ(sound.attenuation, 2);
  EXPECT_EQ(sound.origin, Vec3(256, 256, 80));
  EXPECT_EQ(stage.outbox.placed()[0].place, Vec3(256, 256, 80));
}

TEST_F(Effects, ShortEffectsAreOneCallEach) {
  using Kind = net::TempEntityKind;
  const std::pair<const char*, Kind> effects[] = {
      {"te_gunshot", Kind::kGunshot},           {"te_spike", Kind::kSpike},
      {"te_superspike", Kind::kSuperSpike},     {"te_explosion", Kind::kExplosion},
      {"te_tarexplosion", Kind::kTarExplosion}, {"te_wizspike", Kind::kWizSpike},
      {"te_knightspike", Kind::kKnightSpike},   {"te_lavasplash", Kind::kLavaSplash},
      {"te_teleport", Kind::kTeleport}};
  for (const auto& [name, kind] : effects) stage.run(name, Vec3(8, 16, 24));
  stage.run("te_explosion2", Vec3(8, 16, 24), 5, 300);
  for (const char* const name : {"te_lightning1", "te_lightning2", "te_lightning3", "te_beam"})
    stage.run(name, thing, Vec3(8, 16, 24), Vec3(32, 0, 0));
  const auto sent = messages_in<net::TempEntity>(stage.outbox.placed_bytes());
  ASSERT_EQ(sent.size(), std::size(effects) + 5);
  for (const net::TempEntity& effect : sent) EXPECT_EQ(effect.origin, Vec3(8, 16, 24));
  for (std::size_t i = 0; i < std::size(effects); ++i) EXPECT_EQ(sent[i].kind, effects[i].second);
  EXPECT_EQ(sent[std::size(effects)].color_count, 300 & 255);
  EXPECT_EQ(sent.back().kind, Kind::kBeam);
  EXPECT_EQ(sent.back().end, Vec3(32, 0, 0));
  EXPECT_EQ(vm::EntityIndex{sent.back().entity}, thing);
  EXPECT_EQ(stage.outbox.placed().front().place, Vec3(8, 16, 24));
  EXPECT_FALSE(stage.outbox.placed().back().place) << "a beam is long";
}

TEST_F(Effects, SoundsOutOfRangeAreErrors) {
  EXPECT_THAT(stage.error("sound", thing, 8, "a.wav", 1, 1),
              HasSubstr("builtin sound: channel 8 is not between 0 and 7"));
  EXPECT_THAT(stage.error("sound", thing, -1, "a.wav", 1, 1), HasSubstr("channel -1 is not between 0 and 7"));
  EXPECT_THAT(stage.error("sound", thing, 0, "a.wav", 1.5f, 1),
              HasSubstr("volume 1.5 is not between 0 and 1"));
  EXPECT_THAT(stage.error("sound", thing, 0, "a.wav", kNan, 1), HasSubstr("volume nan"));
  EXPECT_THAT(stage.error("sound", thing, 0, "a.wav", 1, 4.5f),
              HasSubstr("attenuation 4.5 is not between 0 and 4"));
  EXPECT_THAT(stage.error("sound", RawWord{99}, 0, "a.wav", 1, 1), HasSubstr("parameter 1 is not an entity"));
  stage.run("sound", thing, 0, "a.wav", 0, 0);
  stage.run("sound", thing, 7, "a.wav", 1, 4);
}

TEST_F(Effects, ASoundThatWasNotPrecachedGivesOneWarning) {
  for (int i = 0; i < 3; ++i) stage.run("sound", thing, 0, "c.wav", 1, 1);
  stage.run("ambientsound", Vec3(0.0f), "c.wav", 1, 1);
  EXPECT_EQ(stage.printed, "builtin sound: \"c.wav\" was not precached\n");
  EXPECT_TRUE(sounds().empty());
  EXPECT_EQ(stage.outbox.signon().size(), 0u);
}

TEST_F(Effects, AmbientsoundIsSentToJoiningClients) {
  stage.run("ambientsound", Vec3(8, 16, 24), "a.wav", 0.5f, 3);
  const auto sent = messages_in<net::SpawnStaticSound>(stage.outbox.signon().view());
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].origin, Vec3(8, 16, 24));
  EXPECT_EQ(sent[0].sound, 1);
  EXPECT_EQ(sent[0].volume, 127);
  EXPECT_EQ(sent[0].attenuation, 3);
  EXPECT_THAT(stage.error("ambientsound", Vec3(0.0f), "a.wav", 2, 3),
              HasSubstr("builtin ambientsound: volume 2"));
}

TEST_F(Effects, PointsoundComesFromAPlace) {
  stage.run("pointsound", Vec3(8, 16, 24), "b.wav", 0.5f, 3);
  ASSERT_EQ(sounds().size(), 1u);
  EXPECT_EQ(sounds()[0].entity, 0);
  EXPECT_EQ(sounds()[0].sound, 2);
  EXPECT_EQ(sounds()[0].volume, 127);
  EXPECT_EQ(sounds()[0].attenuation, 3);
  EXPECT_EQ(sounds()[0].origin, Vec3(8, 16, 24));
  EXPECT_THAT(stage.error("pointsound", Vec3(0.0f), "b.wav", 2, 3),
              HasSubstr("builtin pointsound: volume 2"));
}

TEST_F(Effects, Particle) {
  stage.run("particle", Vec3(1, 2, 3), Vec3(0.5f, -1, 100), 73, 20);
  ASSERT_EQ(particles().size(), 1u);
  EXPECT_EQ(particles()[0].origin, Vec3(1, 2, 3));
  EXPECT_EQ(particles()[0].direction, Vec3(0.5f, -1, 127 / 16.0f));
  EXPECT_EQ(particles()[0].color, 73);
  EXPECT_EQ(particles()[0].count, 20);
  EXPECT_EQ(stage.outbox.placed()[0].place, Vec3(1, 2, 3));
}

TEST_F(Effects, ParticleCountsFitTheirByte) {
  for (const float count : {-5.0f, 254.0f, 255.0f, 300.0f, 1024.0f, 1e20f, kNan})
    stage.run("particle", Vec3(0.0f), Vec3(0.0f), 0, count);
  std::vector<int> counts;
  for (const net::Particles& burst : particles()) counts.push_back(burst.count);
  EXPECT_THAT(counts, testing::ElementsAre(0, 254, 1024, 254, 1024, 254, 0));
}

TEST_F(Effects, Lightstyle) {
  stage.run("lightstyle", 5, "mmnn");
  EXPECT_EQ(stage.context.light_styles[5], "mmnn");
  const auto sent = messages_in<net::LightStyle>(stage.outbox.reliable().view());
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].style, 5);
  EXPECT_EQ(sent[0].pattern, "mmnn");
  for (const float style : {-1.0f, 64.0f, kNan, 1e20f})
    EXPECT_THAT(stage.error("lightstyle", style, "m"), HasSubstr("builtin lightstyle: style"));
  // Stock clients have a buffer for 63 characters.
  stage.run("lightstyle", 6, std::string(100, 'z'));
  EXPECT_EQ(stage.context.light_styles[6], std::string(63, 'z'));
}

}  // namespace
}  // namespace temblor::test
