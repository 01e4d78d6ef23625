#include "client/effects/effects.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <vector>

#include "base/check.h"
#include "client/effects/dynamic_lights.h"
#include "formats/models/mdl.h"
#include "support/allocation_counter.h"
#include "support/levels/drawable_level.h"

namespace temblor::client {
namespace {

using net::TempEntity;
using net::TempEntityKind;

constexpr std::uint32_t kPlayer = 1;
constexpr std::uint16_t kPlain = 1, kRocketModel = 2, kGibModel = 3;
const std::vector<std::uint32_t> kFlags = {0, 0, formats::kMdlRocketTrail, formats::kMdlGibBlood};

const world::Level& level() {
  static const auto small = test::small_level().level;
  return *small;
}

Events event(const TempEntity& what) {
  Events events;
  events.temp_entities.push_back(what);
  return events;
}

Events event(const net::Particles& what) {
  Events events;
  events.particles.push_back(what);
  return events;
}

void advance(Effects& io_effects, double time_s, const Events& events = {},
             std::span<const InterpolatedEntity> entities = {}, const EffectsSettings& settings = {}) {
  io_effects.advance(events, {level(), time_s, entities, kFlags, kPlayer}, settings);
}

InterpolatedEntity entity(std::uint32_t number, std::uint16_t model, const math::Vec3& origin,
                          std::uint8_t effects = 0) {
  InterpolatedEntity seen;
  seen.number = number;
  seen.model = model;
  seen.origin_world = seen.previous_origin_world = origin;
  seen.effects = effects;
  return seen;
}

std::vector<std::tuple<float, float, float, int>> list_particles(const Effects& effects) {
  const render::ParticleCloud cloud = effects.particles();
  std::vector<std::tuple<float, float, float, int>> result;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    result.emplace_back(cloud.x[i], cloud.y[i], cloud.z[i], cloud.color[i]);
  return result;
}

TEST(Effects, TempEntitiesStartParticlesAndLights) {
  struct Case {
    TempEntityKind kind;
    std::size_t particles, lights, pieces;
  };
  const std::vector<Case> cases = {
      {TempEntityKind::kSpike, 10, 0, 0},          {TempEntityKind::kSuperSpike, 20, 0, 0},
      {TempEntityKind::kGunshot, 20, 0, 0},        {TempEntityKind::kExplosion, 1024, 1, 0},
      {TempEntityKind::kTarExplosion, 1024, 0, 0}, {TempEntityKind::kLightning1, 0, 0, 4},
      {TempEntityKind::kLightning2, 0, 0, 4},      {TempEntityKind::kWizSpike, 30, 0, 0},
      {TempEntityKind::kKnightSpike, 20, 0, 0},    {TempEntityKind::kLightning3, 0, 0, 4},
      {TempEntityKind::kLavaSplash, 1024, 0, 0},   {TempEntityKind::kTeleport, 896, 0, 0},
      {TempEntityKind::kExplosion2, 512, 1, 0},    {TempEntityKind::kBeam, 0, 0, 4}};
  for (const Case& c : cases) {
    Effects effects;
    advance(effects, 1, event(TempEntity{c.kind, {0, 0, 0}, {100, 0, 0}, 7, 32, 4}));
    EXPECT_EQ(effects.particles().size(), c.particles) << static_cast<int>(c.kind);
    EXPECT_EQ(effects.lights().size(), c.lights) << static_cast<int>(c.kind);
    EXPECT_EQ(effects.beams().size(), c.pieces) << static_cast<int>(c.kind);
    for (const render::DynamicLight& light : effects.lights()) EXPECT_EQ(light.radius, 350);
    advance(effects, 4);
    EXPECT_EQ(effects.particles().size() + effects.lights().size() + effects.beams().size(), 0u);
  }
}

TEST(Effects, ColorsOfSpikes) {
  const auto row = [](TempEntityKind kind) {
    Effects effects;
    advance(effects, 1, event(TempEntity{.kind = kind}));
    return effects.particles().color[0] / 8 * 8;
  };
  EXPECT_EQ(row(TempEntityKind::kGunshot), 0);
  EXPECT_EQ(row(TempEntityKind::kWizSpike), 16);
  EXPECT_EQ(row(TempEntityKind::kKnightSpike), 224);
}

TEST(Effects, ServerParticleMessagesStartBursts) {
  Effects effects;
  advance(effects, 1, event(net::Particles{{0, 0, 0}, {0, 0, 1}, 35, 73}));
  EXPECT_EQ(effects.particles().size(), 35u);
  advance(effects, 3, event(net::Particles{{0, 0, 0}, {0, 0, 0}, 1024, 73}));
  EXPECT_EQ(effects.particles().size(), 1024u);
  EXPECT_TRUE(effects.lights().empty());
}

TEST(Effects, BeamsOfThePlayerStartAtThePlayer) {
  Effects effects;
  const std::vector<InterpolatedEntity> entities = {entity(kPlayer, kPlain, {50, 0, 0})};
  advance(effects, 1, event(TempEntity{TempEntityKind::kLightning2, {0, 0, 0}, {100, 0, 0}, kPlayer, 0, 0}),
          entities);
  ASSERT_EQ(effects.beams().size(), 2u);
  EXPECT_EQ(effects.beams()[0].model, BeamModel::kBolt2);
  EXPECT_EQ(effects.beams()[0].origin_world, math::Vec3(50, 0, 0));
}

// Everything at once, for a second: a rocket flies, lava splashes, blobs burst.
struct BusySecond {
  explicit BusySecond(int frames_per_second, std::uint32_t seed = 1) : effects(seed) {
    math::Vec3 previous(0.0f);
    for (int frame = 0; frame <= frames_per_second; ++frame) {
      const double time_s = static_cast<double>(frame) / frames_per_second;
      InterpolatedEntity rocket = entity(9, kRocketModel, {1000 * static_cast<float>(time_s), 0, 64});
      rocket.previous_origin_world = previous;
      if (frame == 0) rocket.previous_origin_world = rocket.origin_world;
      previous = rocket.origin_world;
      Events events;
      if (frame == 0) {
        events.temp_entities.push_back({.kind = TempEntityKind::kLavaSplash, .origin = {0, 500, 0}});
        events.temp_entities.push_back({.kind = TempEntityKind::kTarExplosion, .origin = {0, 900, 0}});
      }
      advance(effects, time_s, events, std::vector{rocket});
    }
  }
  Effects effects;
};

// Bursts are the same bit for bit; trails may differ by rounding, 1/1000 unit here, and by one particle
// at their end.
TEST(Effects, AreTheSameAtAnyFrameRate) {
  const BusySecond slow(10), usual(72), fast(1000);
  const auto expected = list_particles(usual.effects);
  for (const Effects* effects : {&slow.effects, &fast.effects}) {
    const auto found = list_particles(*effects);
    ASSERT_NEAR(static_cast<double>(found.size()), static_cast<double>(expected.size()), 2);
    // Oldest first: the bursts' 2048, then the trail.
    ASSERT_GT(found.size(), 2048u + 200);
    for (std::size_t i = 0; i < 2048; ++i) ASSERT_EQ(found[i], expected[i]) << i;
    std::size_t differ = 0;
    const std::size_t common = std::min(found.size(), expected.size());
    for (std::size_t i = 2048; i < common; ++i) {
      const auto& [x, y, z, color] = found[i];
      const auto& [x2, y2, z2, color2] = expected[i];
      differ += std::abs(x - x2) > 0.001f || std::abs(y - y2) > 0.001f || std::abs(z - z2) > 0.001f;
    }
    EXPECT_EQ(differ, 0u);
  }
}

TEST(Effects, TheSameSeedMakesTheSameEffects) {
  EXPECT_EQ(list_particles(BusySecond(72, 5).effects), list_particles(BusySecond(72, 5).effects));
  EXPECT_NE(list_particles(BusySecond(72, 5).effects), list_particles(BusySecond(72, 6).effects));
}

TEST(Effects, EntitiesGlow) {
  Effects effects;
  const auto make_lights = [&](InterpolatedEntity seen, double time_s) {
    advance(effects, time_s, {}, std::vector{seen});
    return std::vector<render::DynamicLight>(effects.lights().begin(), effects.lights().end());
  };
  const double time_s = 3.14;
  const float flicker = light_flicker(4, time_s);

  const auto bright = make_lights(entity(4, kPlain, {1, 2, 3}, kEffectBrightLight), time_s);
  ASSERT_EQ(bright.size(), 1u);
  EXPECT_EQ(bright[0].origin_world, math::Vec3(1, 2, 19));
  EXPECT_EQ(bright[0].radius, 400 + flicker);

  const auto dim = make_lights(entity(4, kPlain, {1, 2, 3}, kEffectDimLight), time_s + 0.01);
  ASSERT_EQ(dim.size(), 1u);
  EXPECT_EQ(dim[0].origin_world, math::Vec3(1, 2, 3));
  EXPECT_EQ(dim[0].radius, 200 + flicker);

  const auto rocket = make_lights(entity(4, kRocketModel, {1, 2, 3}), time_s + 0.02);
  ASSERT_EQ(rocket.size(), 1u);
  EXPECT_EQ(rocket[0].radius, 200);

  EXPECT_TRUE(make_lights(entity(4, kGibModel, {1, 2, 3}), time_s + 0.03).empty());
}

// The player is drawn at the predicted place; the server's place is a round trip old.
TEST(Effects, ThePlayersEffectsFollowThePrediction) {
  const math::Vec3 sent(0, 0, 0), shown(0, 60, 8);
  Effects effects;
  const std::vector<InterpolatedEntity> seen = {entity(kPlayer, kPlain, sent, kEffectDimLight),
                                                entity(2, kPlain, {200, 0, 0}, kEffectDimLight)};
  TempEntity bolt{TempEntityKind::kLightning2, sent, {120, 60, 8}};
  bolt.entity = kPlayer;
  effects.advance(event(bolt), {level(), 1, seen, kFlags, kPlayer, shown}, {});
  ASSERT_EQ(effects.lights().size(), 2u);
  EXPECT_EQ(effects.lights()[0].origin_world, shown);
  EXPECT_EQ(effects.lights()[1].origin_world, seen[1].origin_world);
  ASSERT_FALSE(effects.beams().empty());
  EXPECT_EQ(effects.beams()[0].origin_world, shown);
}

TEST(Effects, MuzzlesFlashForATenthOfASecond) {
  Effects effects;
  InterpolatedEntity seen = entity(4, kPlain, {100, 0, 0});
  seen.angles_deg = {0, 90, 0};
  seen.has_muzzle_flash = true;
  advance(effects, 5, {}, std::vector{seen});
  ASSERT_EQ(effects.lights().size(), 1u);
  const render::DynamicLight light = effects.lights()[0];
  EXPECT_LT(glm::distance(light.origin_world, math::Vec3(100, 18, 16)), 0.001f);
  EXPECT_EQ(light.radius, 200 + light_flicker(4, 5));
  EXPECT_EQ(light.least, 32);
  seen.has_muzzle_flash = false;
  advance(effects, 5.099, {}, std::vector{seen});
  EXPECT_EQ(effects.lights().size(), 1u);
  advance(effects, 5.101, {}, std::vector{seen});
  EXPECT_TRUE(effects.lights().empty());
}

// A light's color follows from its cause; the original's lights are white.
TEST(Effects, LightsHaveColorsOnlyIfEnabled) {
  InterpolatedEntity shooter = entity(4, kPlain, {100, 0, 0});
  shooter.has_muzzle_flash = true;
  const InterpolatedEntity rocket = entity(5, kRocketModel, {200, 0, 0});
  const InterpolatedEntity blue = entity(6, kPlain, {300, 0, 0}, kEffectDimLight | kEffectBlue);
  const InterpolatedEntity plain = entity(7, kPlain, {400, 0, 0}, kEffectDimLight);
  const std::vector<InterpolatedEntity> seen = {shooter, rocket, blue, plain};
  for (const bool colored : {false, true}) {
    Effects effects;
    EffectsSettings settings;
    settings.colored_lights = colored;
    advance(effects, 1, event(TempEntity{.kind = TempEntityKind::kExplosion}), seen, settings);
    ASSERT_EQ(effects.lights().size(), 5u);
    for (const render::DynamicLight& light : effects.lights()) {
      const bool is_white = light.color == math::Vec3(1.0f);
      EXPECT_EQ(is_white, !colored || light.origin_world.x == 400) << light.origin_world.x;
      EXPECT_EQ(std::max({light.color.r, light.color.g, light.color.b}), 1) << light.origin_world.x;
      if (colored && light.origin_world.x == 300) {
        EXPECT_EQ(light.color.b, 1);
      }
      if (colored && light.origin_world.x < 300) {
        EXPECT_GT(light.color.r, light.color.b);
      }
    }
  }
}

// The light stays at the end of a beam for the beam's life, and one beam of an entity has one light.
TEST(Effects, LightningLightsWhatItHits) {
  EffectsSettings settings;
  settings.colored_lights = true;
  TempEntity bolt{TempEntityKind::kLightning2, {0, 0, 0}, {108, 0, 0}};
  bolt.entity = 4;
  Effects effects;
  InterpolatedEntity shooter = entity(4, kPlain, {0, 0, 0});
  shooter.has_muzzle_flash = true;
  advance(effects, 1, event(bolt), std::vector{shooter}, settings);
  ASSERT_EQ(effects.lights().size(), 2u);
  for (const render::DynamicLight& light : effects.lights()) EXPECT_GT(light.color.b, light.color.r);
  EXPECT_EQ(effects.lights()[0].origin_world, math::Vec3(100, 0, 0));
  bolt.end = {0, 108, 0};
  advance(effects, 1.1, event(bolt), {}, settings);
  ASSERT_GE(effects.lights().size(), 1u);
  EXPECT_EQ(effects.lights()[0].origin_world, math::Vec3(0, 100, 0));
  advance(effects, 1.31, {}, {}, settings);
  EXPECT_TRUE(effects.lights().empty());
  // Other beams, such as that of a grappling hook, do not shine.
  bolt.kind = TempEntityKind::kBeam;
  advance(effects, 2, event(bolt), {}, settings);
  EXPECT_TRUE(effects.lights().empty());
}

TEST(Effects, BrightFieldsAreDrawnOncePerTime) {
  Effects effects;
  const std::vector<InterpolatedEntity> seen = {entity(4, kPlain, {0, 0, 0}, kEffectBrightField)};
  for (const double time_s : {1.0, 1.0, 1.001, 1.5, 1.5}) {
    advance(effects, time_s, {}, seen);
    EXPECT_EQ(effects.particles().size(), 162u) << time_s;
  }
}

TEST(Effects, ParticlesAreLimited) {
  Effects effects;
  EffectsSettings settings;
  settings.max_particles = 1500;
  for (int i = 0; i < 3; ++i)
    advance(effects, 1, event(TempEntity{.kind = TempEntityKind::kTarExplosion}), {}, settings);
  EXPECT_EQ(effects.particles().size(), 1500u);
  EXPECT_EQ(effects.dropped_particles(), 3u * 1024 - 1500);
  // Dead particles make room within the same frame.
  advance(effects, 3, event(TempEntity{.kind = TempEntityKind::kTarExplosion}), {}, settings);
  EXPECT_EQ(effects.particles().size(), 1024u);
  EXPECT_EQ(effects.dropped_particles(), 3u * 1024 - 1500);
}

TEST(Effects, RewindingAndNewLevelsEndAllEffects) {
  for (const bool rewind : {false, true}) {
    Effects effects;
    Events events = event(TempEntity{.kind = TempEntityKind::kExplosion});
    events.temp_entities.push_back({TempEntityKind::kBeam, {0, 0, 0}, {100, 0, 0}, 1, 0, 0});
    advance(effects, 10, events);
    EXPECT_GT(effects.particles().size(), 0u);
    if (!rewind) effects.begin_level();
    advance(effects, 9.99);
    EXPECT_EQ(effects.particles().size() + effects.lights().size() + effects.beams().size(), 0u);
  }
}

// Four units above the middle of the first floor of the world.
math::Vec3 place_above_floor() {
  const world::Face* floor = nullptr;
  for (const world::Face& face : level().faces)
    if (floor == nullptr && face.kind == world::FaceKind::kLit && !face.back_side &&
        level().planes[face.plane].normal.z == 1)
      floor = &face;
  CHECK(floor != nullptr);
  math::Vec3 sum(0.0f);
  for (std::uint32_t i = 0; i < floor->surfedge_count; ++i)
    sum += level().vertices[level().surfedge_start(floor->first_surfedge + i)];
  return sum / static_cast<float>(floor->surfedge_count) + math::Vec3(0, 0, 4);
}

TEST(Effects, MarksAppearOnlyIfEnabled) {
  const math::Vec3 above = place_above_floor();
  const std::vector<std::pair<Events, std::size_t>> cases = {
      {event(TempEntity{.kind = TempEntityKind::kGunshot, .origin = above}), 1},
      {event(TempEntity{.kind = TempEntityKind::kExplosion, .origin = above}), 1},
      {event(net::Particles{above, {0, 0, 0}, 20, 73}), 1},
      {event(net::Particles{above, {0, 0, 0}, 20, 20}), 0},
      {event(TempEntity{.kind = TempEntityKind::kTeleport, .origin = above}), 0}};
  for (const auto& [events, least] : cases) {
    Effects with, without;
    EffectsSettings settings;
    advance(without, 1, events, {}, settings);
    EXPECT_EQ(without.marks().size(), 0u);
    settings.marks = true;
    advance(with, 1, events, {}, settings);
    EXPECT_EQ(with.marks().size() > 0, least > 0);
    EXPECT_EQ(list_particles(with), list_particles(without));
    advance(with, 2, {}, {}, {});
    EXPECT_EQ(with.marks().size(), 0u);
  }
}

Events request(const std::string& words) {
  Events events;
  events.marks.push_back(net::read_mark_request("//temblor mark " + words).value());
  return events;
}

TEST(Effects, TheGameCanAskForMarks) {
  // The number of the door's model in the precache list.
  const std::vector<world::ModelIndex> submodels = {{}, {}, {}, {}, world::ModelIndex{1}};
  const world::Model& door = level().models[1];
  const math::Vec3 mins = door.bounds.mins, maxs = door.bounds.maxs;
  const auto count_on_door = [&](const Effects& effects) {
    std::size_t count = 0;
    for (std::uint32_t i = door.first_face; i < door.first_face + door.face_count; ++i)
      count += effects.marks().marks_on_face(base::to_index<world::FaceIndex>(i)).size();
    return count;
  };
  const auto count_after = [&](const std::string& words) {
    Effects effects;
    effects.advance(request(words), {level(), 1, {}, kFlags, kPlayer, {}, submodels}, {});
    return count_on_door(effects);
  };
  const std::string at_door =
      fmt::format("{} {} {} 8 0", (mins.x + maxs.x) / 2, mins.y - 1, (mins.z + maxs.z) / 2);
  EXPECT_GT(count_after("*scorch " + at_door + " *1"), 0u);
  EXPECT_EQ(count_after("*scorch " + at_door), 0u) << "the door is not in view";
  EXPECT_EQ(count_after("*scorch " + at_door + " *2"), 0u);
  EXPECT_EQ(count_after("missing " + at_door + " *1"), 0u);
}

TEST(Effects, MarksOfTheGameStayWithoutMarksOfShots) {
  Effects effects;
  const math::Vec3 above = place_above_floor();
  const Events events = request(fmt::format("*blood {} {} {} 8", above.x, above.y, above.z));
  const auto step = [&](double time_s, const Events& now, bool marks) {
    effects.advance(now, {level(), time_s, {}, kFlags, kPlayer}, {.marks = marks});
    return effects.marks().size();
  };
  const std::size_t asked_for = step(1, events, false);
  EXPECT_GT(asked_for, 0u);
  EXPECT_GT(step(2, event(TempEntity{.kind = TempEntityKind::kGunshot, .origin = above}), true), asked_for);
  EXPECT_EQ(step(3, {}, false), asked_for);
  EXPECT_EQ(step(2, {}, false), 0u) << "time ran back";
}

TEST(Effects, AllocateNothingInTheSteadyState) {
  Effects effects;
  Events events = event(TempEntity{.kind = TempEntityKind::kExplosion});
  events.temp_entities.push_back({TempEntityKind::kBeam, {0, 0, 0}, {600, 0, 0}, 1, 0, 0});
  std::vector<InterpolatedEntity> seen = {entity(4, kRocketModel, {0, 0, 0}, kEffectBrightField)};
  seen[0].origin_world = {50, 0, 0};
  const auto run = [&](double from_s) {
    for (int i = 0; i < 100; ++i) advance(effects, from_s + 0.01 * i, events, seen);
  };
  run(0);
  const std::size_t before = test::allocation_count();
  run(10);
  EXPECT_EQ(test::allocation_count(), before);
}

TEST(Effects, ModelsTurnAHundredDegreesASecond) {
  EXPECT_FLOAT_EQ(compute_rotated_yaw_deg(0), 0);
  EXPECT_FLOAT_EQ(compute_rotated_yaw_deg(1.5), 150);
  EXPECT_FLOAT_EQ(compute_rotated_yaw_deg(3.6), 0);
  EXPECT_NEAR(compute_rotated_yaw_deg(36000.25), 25, 0.001);
  EXPECT_FLOAT_EQ(compute_rotated_yaw_deg(-0.1), 350);
}

}  // namespace
}  // namespace temblor::client
