// The generated demo, whose script lists what is visible at which time (support/generated_demo.h). It
// contains what stock demos lack. A packet is drawn from the time of the packet before it on, so an event
// begins kPacket_s earlier.
#include "support/generated_demo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "app/demo/demo_run.h"
#include "formats/game/dem.h"
#include "net/protocol/message_reader.h"
#include "support/effort.h"
#include "support/pictures/frames.h"
#include "support/programs/transcode.h"

namespace temblor::app {
namespace {

using namespace test::made_recording;

struct DialectCase {
  const char* name;
  net::Dialect dialect;
};
constexpr DialectCase kDialects[] = {{"made15", {net::Protocol::kNetQuake, 0}},
                                     {"made666", {net::Protocol::kFitzQuake, 0}},
                                     {"made999", {net::Protocol::kRmq, net::kShortAngle | net::kInt32Coord}}};

// The game directory with all three demos.
struct GameWithRecordings {
  test::MadeGame game;
  GameWithRecordings() {
    for (const DialectCase& dialect : kDialects)
      game.folder().write(std::string("id1/") + dialect.name + ".dem",
                          test::make_recording(dialect.dialect).bytes);
  }
};

LoadedDemo load(const char* name) {
  static const GameWithRecordings with_recordings;
  return load_demo({.base_folder = with_recordings.game.path().string(), .games = {}}, name).value();
}

// A demo that is played in steps of 1/40 s.
class Playback {
 public:
  explicit Playback(const char* name, const render::Settings& settings = {},
                    render::PixelFormat format = render::PixelFormat::kRgb)
      : demo_(load(name)),
        run_(DemoRun::start(demo_, {.size = {320, 200}, .format = format, .threads = {}}, {}, settings)
                 .value()) {}

  const render::Scene& scene_at(double second) {
    while (second_ + kStep_s < second) step_to(second_ + kStep_s);
    step_to(second);
    return run_.scene();
  }
  DemoRun& run() { return run_; }

 private:
  static constexpr double kStep_s = 0.025;

  void step_to(double second) {
    second_ = second;
    EXPECT_TRUE(run_.advance_to(kFirstTime_s + second).ok());
  }

  LoadedDemo demo_;
  DemoRun run_;
  double second_ = 0;
};

std::size_t count_colors(const render::ParticleCloud& cloud, int first, int count) {
  return static_cast<std::size_t>(
      std::count_if(cloud.color.begin(), cloud.color.end(),
                    [&](std::uint8_t color) { return color >= first && color < first + count; }));
}

// Returns the only light; fails the test if there is not exactly one.
render::DynamicLight one_light(const render::Scene& scene) {
  EXPECT_EQ(scene.lights.size(), 1u);
  return scene.lights.empty() ? render::DynamicLight{} : scene.lights.front();
}

// Returns the first model whose origin is within 2 units of a point; null if there is none.
const render::AliasInstance* model_at(const render::Scene& scene, const math::Vec3& place) {
  for (const render::AliasInstance& model : scene.alias_models)
    if (glm::distance(model.origin_world, place) < 2) return &model;
  return nullptr;
}

class GeneratedDemo : public ::testing::TestWithParam<DialectCase> {
 protected:
  const char* name() const { return GetParam().name; }
};

TEST_P(GeneratedDemo, IsReadToItsLastMessage) {
  const test::MadeRecording made = test::make_recording(GetParam().dialect);
  formats::DemReader records = formats::DemReader::open(made.bytes).value();
  net::MessageReader reader;
  std::size_t record_count = 0, message_count = 0;
  while (const auto record = records.next().value()) {
    ++record_count;
    reader.begin(record->message, record->offset);
    while (reader.next().value()) ++message_count;
  }
  EXPECT_FALSE(records.is_truncated());
  EXPECT_EQ(record_count, made.records);
  EXPECT_EQ(message_count, made.messages);

  const client::DemoLength length = client::DemoPlayer::scan(made.bytes, name()).value();
  EXPECT_FALSE(length.damage);
  EXPECT_NEAR(length.last_time_s - length.first_time_s, kLength_s, 1e-4);
}

TEST_P(GeneratedDemo, ShowsThingsWhereTheyAre) {
  Playback playback(name());
  for (const double second : {0.4, 0.925, 1.6, 2.325, 3.5}) {
    const render::Scene& scene = playback.scene_at(second);
    const render::AliasInstance* walker = model_at(scene, walker_at(second));
    ASSERT_NE(walker, nullptr) << second;
    EXPECT_FLOAT_EQ(walker->angles_deg.y, -90);
    const bool clear = second < 0.95 && GetParam().dialect.protocol != net::Protocol::kNetQuake;
    EXPECT_NEAR(walker->alpha, clear ? 0.5 : 1, 0.01) << second;
    EXPECT_NE(model_at(scene, {200, 130, 40}), nullptr) << "the ball";
    EXPECT_EQ(scene.brush_models.size(), 1u) << "the door";
    EXPECT_NE(scene.view_weapon, nullptr);
    const bool rocket = second > 2 && second < 3;
    EXPECT_EQ(scene.alias_models.size(), rocket ? 3u : 2u) << second;
    if (rocket) {
      const auto passed = static_cast<float>(second - 2);
      EXPECT_NE(model_at(scene, kRocketFrom + passed * (kRocketTo - kRocketFrom)), nullptr);
    }
  }
  const render::AliasInstance* walker = model_at(playback.scene_at(7.5), {220, 256, 24});
  ASSERT_NE(walker, nullptr);
  ASSERT_TRUE(walker->colors);
  EXPECT_EQ(walker->colors->shirt, 4);
  EXPECT_EQ(walker->colors->pants, 13);
  EXPECT_EQ(playback.scene_at(10.3).sprites.size(), 1u);
}

TEST_P(GeneratedDemo, ShowsShotsAndARocket) {
  Playback playback(name());
  const render::DynamicLight flash = one_light(playback.scene_at(1));
  EXPECT_LT(glm::distance(flash.origin_world, kPlayer + math::Vec3(18, 0, 16)), 0.5f);
  EXPECT_GE(flash.radius, 200);
  EXPECT_LT(flash.radius, 232);
  EXPECT_GT(count_colors(playback.run().scene().particles, 0, 8), 20u)
      << "two gunshots with 20 particles each, some short-lived";
  EXPECT_TRUE(playback.scene_at(1.12).lights.empty()) << "0.1 s after the update with the flash was left";
  EXPECT_GT(count_colors(playback.run().scene().particles, 72, 8), 30u) << "blood: 60";

  EXPECT_EQ(playback.scene_at(1.9).particles.size(), 0u);
  const render::Scene& flight = playback.scene_at(2.6);
  const math::Vec3 way = kRocketTo - kRocketFrom, rocket = kRocketFrom + 0.6f * way;
  EXPECT_LT(glm::distance(one_light(flight).origin_world, rocket), 2);
  EXPECT_FLOAT_EQ(one_light(flight).radius, 200);
  // One particle every 3 units; the oldest have burnt out after 0.6 s.
  EXPECT_NEAR(static_cast<double>(flight.particles.size()), glm::length(0.6f * way) / 3, 15);
  for (std::size_t i = 0; i < flight.particles.size(); ++i) {
    const math::Vec3 place{flight.particles.x[i], flight.particles.y[i], flight.particles.z[i]};
    const float along = glm::dot(place - kRocketFrom, way) / glm::dot(way, way);
    EXPECT_GT(along, -0.03f);
    EXPECT_LT(along, 0.63f);
    const math::Vec3 beside = place - kRocketFrom - along * way;
    EXPECT_LT(std::hypot(beside.x, beside.y), 6) << "smoke only rises";
  }
}

TEST_P(GeneratedDemo, ShowsExplosionsOfAllKinds) {
  Playback playback(name());
  const auto expect_flash = [&](double second, double age_s, const math::Vec3& place) {
    const render::DynamicLight light = one_light(playback.scene_at(second));
    EXPECT_LT(glm::distance(light.origin_world, place), 0.2f);
    EXPECT_NEAR(light.radius, 350 - 300 * age_s, 0.1);
  };
  expect_flash(3, 0.05, kRocketTo);
  EXPECT_GE(playback.run().scene().particles.size(), 1024u);
  EXPECT_LT(playback.run().scene().particles.size(), 1024u + 110)
      << "including what is left of the rocket's trail";
  expect_flash(3.3, 0.35, kRocketTo);
  EXPECT_TRUE(playback.scene_at(3.5).lights.empty());

  const render::Scene& tar = playback.scene_at(5.2);
  EXPECT_EQ(tar.particles.size(), 1024u);
  EXPECT_EQ(count_colors(tar.particles, 66, 6) + count_colors(tar.particles, 150, 6), 1024u);
  EXPECT_TRUE(tar.lights.empty());

  expect_flash(6.1, 0.15, kMiddle);
  EXPECT_EQ(count_colors(playback.run().scene().particles, kFirstBlue, kBlues), 512u);

  EXPECT_EQ(playback.scene_at(6.9).particles.size(), 0u);
  const render::Scene& teleport = playback.scene_at(7);
  EXPECT_EQ(teleport.particles.size(), 8u * 8 * 14);
  EXPECT_EQ(count_colors(teleport.particles, 7, 8), 8u * 8 * 14);

  EXPECT_EQ(playback.scene_at(7.9).particles.size(), 0u);
  const render::Scene& lava = playback.scene_at(8.5);
  EXPECT_EQ(lava.particles.size(), 1024u);
  EXPECT_EQ(count_colors(lava.particles, 224, 8), 1024u);
}

TEST_P(GeneratedDemo, ShowsSpikes) {
  Playback playback(name());
  // The time at which each spike hits, and colors and number of its particles. Those without lifetime have
  // disappeared by then.
  const struct {
    double second;
    int color;
    std::size_t count;
  } spikes[] = {{4.0, 0, 10}, {4.2, 0, 20}, {4.4, 16, 30}, {4.6, 224, 20}};
  for (const auto& spike : spikes) {
    const std::size_t before = count_colors(playback.scene_at(spike.second - 0.06).particles, spike.color, 8);
    const std::size_t born = count_colors(playback.scene_at(spike.second - 0.04).particles, spike.color, 8);
    EXPECT_GT(born, before + spike.count / 2) << spike.second;
    EXPECT_LE(born, before + spike.count) << spike.second;
  }
}

TEST_P(GeneratedDemo, ShowsEntitiesThatShine) {
  Playback playback(name());
  const math::Vec3 star{200, 300, 70};
  EXPECT_EQ(count_colors(playback.scene_at(10.4).particles, 0x6f, 1), 162u);
  const render::DynamicLight bright = one_light(playback.scene_at(10.8));
  EXPECT_LT(glm::distance(bright.origin_world, star + math::Vec3(0, 0, 16)), 0.2f);
  EXPECT_GE(bright.radius, 400);
  EXPECT_LT(bright.radius, 432);
  EXPECT_EQ(count_colors(playback.run().scene().particles, 0x6f, 1), 0u);
  const render::DynamicLight dim = one_light(playback.scene_at(11.2));
  EXPECT_GE(dim.radius, 200);
  EXPECT_LT(dim.radius, 232);
  EXPECT_TRUE(playback.scene_at(11.45).lights.empty());
}

TEST_P(GeneratedDemo, ShowsLightning) {
  Playback playback(name());
  const struct {
    double second;
    math::Vec3 from, to;
  } beams[] = {{11.8, kPlayer, {480, 330, 90}},
               {12.3, {200, 460, 100}, {200, 60, 100}},
               {12.8, {240, 256, 190}, {240, 256, 0}},
               {13.3, {300, 60, 30}, {300, 440, 150}}};
  for (const auto& beam : beams) {
    std::vector<const render::AliasInstance*> pieces;
    for (const render::AliasInstance& model : playback.scene_at(beam.second).alias_models)
      if (model.full_bright) pieces.push_back(&model);
    ASSERT_EQ(pieces.size(), static_cast<std::size_t>(std::ceil(glm::distance(beam.from, beam.to) / 30)))
        << beam.second;
    EXPECT_LT(glm::distance(pieces.front()->origin_world, beam.from), 0.5f);
    EXPECT_LT(glm::distance(pieces.back()->origin_world, beam.to), 30.5f);
  }
}

TEST_P(GeneratedDemo, ColorsTheView) {
  Playback playback(name());
  EXPECT_EQ(playback.scene_at(13.4).tint.opacity, 0);
  EXPECT_EQ(playback.run().scene().camera.angles_deg.z, 0);
  // Half of the damage of 58 counts three times, and fades by 150/256 per second.
  const render::Tint pain = playback.scene_at(13.5).tint;
  EXPECT_EQ(pain.color, math::Vec3(255, 0, 0));
  EXPECT_NEAR(pain.opacity, (87 - 0.05 * 150) / 256, 1e-3);
  EXPECT_NE(playback.run().scene().camera.angles_deg.x, 0) << "the view is kicked";
  EXPECT_GT(playback.scene_at(14.05).tint.color.r, 100) << "gold over blue";
  const render::Tint quad = playback.scene_at(14.48).tint;
  EXPECT_EQ(quad.color, math::Vec3(0, 0, 255));
  EXPECT_NEAR(quad.opacity, 30.0 / 256, 1e-6);
}

TEST_P(GeneratedDemo, GoesDarkAndEndsAboveTheCourt) {
  Playback playback(name());
  EXPECT_EQ(playback.scene_at(14.4).light_styles[0], 264) << "12 steps of 22";
  EXPECT_EQ(playback.scene_at(14.7).light_styles[0], 0);
  const render::Scene& ending = playback.scene_at(16);
  EXPECT_EQ(ending.light_styles[0], 264);
  EXPECT_EQ(ending.view_weapon, nullptr);
  EXPECT_EQ(ending.camera.origin_world, kAboveTheCourt);
  EXPECT_NEAR(ending.camera.angles_deg.x, 20, 1.5);
  EXPECT_NEAR(ending.camera.angles_deg.y, 45, 1.5);
}

INSTANTIATE_TEST_SUITE_P(Dialects, GeneratedDemo, ::testing::ValuesIn(kDialects),
                         [](const auto& dialect) { return std::string(dialect.param.name); });

// Returns hashes of every `draw_every`-th frame.
std::vector<std::uint64_t> frame_hashes(int frames_per_second, int draw_every,
                                        const render::Settings& settings, render::PixelFormat format) {
  Playback playback("made15", settings, format);
  std::vector<std::uint64_t> hashes;
  const int count = static_cast<int>(kLength_s * frames_per_second);
  for (int number = 0; number < count; ++number) {
    const double second = static_cast<double>(number) / frames_per_second;
    EXPECT_TRUE(playback.run().advance_to(kFirstTime_s + second).ok());
    if (number % draw_every != 0) continue;
    EXPECT_TRUE(playback.run().draw().ok());
    hashes.push_back(test::compute_hash(playback.run().frame()));
  }
  return hashes;
}

TEST(GeneratedDemoFrames, DoNotDependOnThreads) {
  const auto hashes = [](int threads, render::PixelFormat format) {
    const render::Settings settings = {.threads = threads, .job_backend = base::JobBackend::kStdThread};
    return frame_hashes(20, test::effort(5, 20), settings, format);
  };
  for (const render::PixelFormat format : {render::PixelFormat::kRgb, render::PixelFormat::kIndexed}) {
    const std::vector<std::uint64_t> one = hashes(1, format);
    EXPECT_GT(std::set<std::uint64_t>(one.begin(), one.end()).size(), one.size() * 3 / 4);
    EXPECT_EQ(hashes(2, format), one);
    EXPECT_EQ(hashes(8, format), one);
  }
}

// The effects of a scene.
struct SeenEffects {
  std::vector<math::Vec3> particles;
  std::vector<float> radii;  // of lights
  float tint = 0;
};
std::vector<SeenEffects> twice_a_second(int frames_per_second) {
  Playback playback("made15");
  std::vector<SeenEffects> seen;
  for (int number = 0; number < static_cast<int>(kLength_s) * frames_per_second; ++number) {
    const double second = static_cast<double>(number) / frames_per_second;
    EXPECT_TRUE(playback.run().advance_to(kFirstTime_s + second).ok());
    if (number % (frames_per_second / 2) != 0) continue;
    const render::Scene& scene = playback.run().scene();
    seen.push_back({{}, {}, scene.tint.opacity});
    for (std::size_t i = 0; i < scene.particles.size(); ++i)
      seen.back().particles.emplace_back(scene.particles.x[i], scene.particles.y[i], scene.particles.z[i]);
    for (const render::DynamicLight& light : scene.lights) seen.back().radii.push_back(light.radius);
  }
  return seen;
}

// Effects begin at their own time, not at that of the next frame, and with the same random numbers. At two
// frames per second, trails may be rounded differently: particles are equal to a hundredth of a unit.
TEST(GeneratedDemoFrames, HaveTheSameEffectsAtAnyFrameRate) {
  const std::vector<SeenEffects> few = twice_a_second(2);
  for (const int frames_per_second : {10, 30, 72}) {
    const std::vector<SeenEffects> many = twice_a_second(frames_per_second);
    ASSERT_EQ(many.size(), few.size());
    for (std::size_t i = 0; i < few.size(); ++i) {
      SCOPED_TRACE(testing::Message()
                   << frames_per_second << " a second, at " << 0.5 * static_cast<double>(i));
      EXPECT_NEAR(many[i].tint, few[i].tint, 1e-4);
      ASSERT_EQ(many[i].radii.size(), few[i].radii.size());
      for (std::size_t k = 0; k < few[i].radii.size(); ++k)
        EXPECT_NEAR(many[i].radii[k], few[i].radii[k], 0.01);
      ASSERT_EQ(many[i].particles.size(), few[i].particles.size());
      for (std::size_t k = 0; k < few[i].particles.size(); ++k)
        ASSERT_LT(glm::distance(many[i].particles[k], few[i].particles[k]), 0.01f) << k;
    }
  }
}

TEST(GeneratedDemoBytes, SurviveTranscodingToProtocol15) {
  const base::ByteVector original = test::make_recording({}).bytes;
  for (const DialectCase& dialect : kDialects)
    EXPECT_EQ(test::transcode(test::make_recording(dialect.dialect).bytes, {}).value(), original)
        << dialect.name;
}

}  // namespace
}  // namespace temblor::app
