// Compares seeking in demos with playing the same demos from the start.
#include "client/demo/demo_session.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "assets/assets.h"
#include "client/demo/demo_builder.h"
#include "client/view/free_camera.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/generated_demo.h"
#include "support/mutations.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using client::DemoSession;
using client::InterpolatedEntity;
using client::Presentation;
using client::PresentationSettings;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A demo and the presentation that plays it.
struct Played {
  Played(const std::filesystem::path& folder, base::ByteVector bytes)
      : library(vfs::FileSystem::open(folder).value()),
        presentation(library),
        session(DemoSession::open(std::move(bytes), "test.dem", presentation).value()) {}

  assets::Library library;
  Presentation presentation;
  DemoSession session;
};

const MadeGame& made_game() {
  static const MadeGame game;
  return game;
}
base::ByteVector made_bytes() {
  return make_recording({}).bytes;
}

// The same demo three times in a row, without its final disconnect.
base::ByteVector made_three_times() {
  const base::ByteVector once = made_bytes();
  formats::DemWriter thrice;
  for (int i = 0; i < 3; ++i) {
    formats::DemReader reader = formats::DemReader::open(once).value();
    for (auto record = reader.next().value(); record; record = reader.next().value())
      if (reader.offset() < reader.size()) thrice.add(record->view_angles_deg, record->message);
  }
  return std::move(thrice).take();
}

auto comparable_values(const InterpolatedEntity& entity) {
  return std::tuple(entity.number, entity.model, entity.origin_world, entity.angles_deg, entity.from_frame,
                    entity.to_frame, entity.blend, entity.skin, entity.colormap, entity.effects, entity.alpha,
                    entity.scale);
}
auto comparable_values(const render::DynamicLight& light) {
  return std::tuple(light.origin_world.x, light.origin_world.y, light.origin_world.z, light.radius);
}
auto comparable_values(const render::AliasInstance& model) {
  return std::tuple(model.origin_world, model.angles_deg, model.blend, model.skin, model.alpha);
}

void expect_same_game(const client::Game& a, const client::Game& b) {
  EXPECT_EQ(a.level_name, b.level_name);
  EXPECT_EQ(a.models, b.models);
  EXPECT_EQ(a.sounds, b.sounds);
  EXPECT_EQ(a.signon, b.signon);
  EXPECT_EQ(a.view_entity, b.view_entity);
  EXPECT_EQ(a.stats, b.stats);
  EXPECT_EQ(a.data.items, b.data.items);
  EXPECT_EQ(a.data.velocity, b.data.velocity);
  EXPECT_EQ(a.data.punch_deg, b.data.punch_deg);
  EXPECT_EQ(a.data.weapon_frame, b.data.weapon_frame);
  EXPECT_EQ(a.light_styles, b.light_styles);
  EXPECT_EQ(a.paused, b.paused);
  EXPECT_EQ(a.ending, b.ending);
  EXPECT_EQ(a.ending_since_s, b.ending_since_s);
  EXPECT_EQ(a.center_text, b.center_text);
  EXPECT_EQ(a.center_text_since_s, b.center_text_since_s);
  ASSERT_EQ(a.players.size(), b.players.size());
  for (std::size_t i = 0; i < a.players.size(); ++i) {
    EXPECT_EQ(a.players[i].name, b.players[i].name);
    EXPECT_EQ(a.players[i].frags, b.players[i].frags);
  }
}

template <typename Item>
auto all_values(std::span<const Item> items) {
  std::vector<decltype(comparable_values(items[0]))> values;
  for (const Item& item : items) values.push_back(comparable_values(item));
  return values;
}

// Places and colors of all particles, sorted.
using PlacedParticles = std::vector<std::tuple<float, float, float, int>>;
PlacedParticles list_particles(const render::Scene& scene) {
  PlacedParticles particles;
  for (std::size_t i = 0; i < scene.particles.x.size(); ++i)
    particles.emplace_back(scene.particles.x[i], scene.particles.y[i], scene.particles.z[i],
                           scene.particles.color[i]);
  std::sort(particles.begin(), particles.end());
  return particles;
}

// How many have no equal among the others.
std::size_t without_a_twin(const PlacedParticles& particles, const PlacedParticles& others) {
  constexpr float kNear = 0.01f;
  std::size_t alone = 0;
  for (const auto& [x, y, z, color] : particles) {
    auto other = std::lower_bound(others.begin(), others.end(), std::tuple(x - kNear, 0.0f, 0.0f, 0));
    const auto is_twin = [&, px = x, py = y, pz = z, pc = color](const auto& place) {
      const auto& [x2, y2, z2, color2] = place;
      return std::abs(x2 - px) < kNear && std::abs(y2 - py) < kNear && std::abs(z2 - pz) < kNear &&
             color2 == pc;
    };
    while (other != others.end() && std::get<0>(*other) < x + kNear && !is_twin(*other)) ++other;
    alone += other == others.end() || !is_twin(*other) ? 1 : 0;
  }
  return alone;
}

void expect_same_scene(const render::Scene& a, const render::Scene& b) {
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.camera.origin_world, b.camera.origin_world);
  EXPECT_EQ(a.camera.angles_deg, b.camera.angles_deg);
  // Fading adds up time steps.
  EXPECT_LT(glm::distance(a.tint.color, b.tint.color), 0.01f);
  EXPECT_NEAR(a.tint.opacity, b.tint.opacity, 1e-4);
  EXPECT_EQ(a.underwater, b.underwater);
  EXPECT_EQ(a.light_styles, b.light_styles);
  auto lights_a = all_values(a.lights), lights_b = all_values(b.lights);
  std::sort(lights_a.begin(), lights_a.end());
  std::sort(lights_b.begin(), lights_b.end());
  EXPECT_EQ(lights_a, lights_b);
  EXPECT_EQ(all_values(a.alias_models), all_values(b.alias_models));
  EXPECT_EQ(a.brush_models.size(), b.brush_models.size());
  EXPECT_EQ(a.sprites.size(), b.sprites.size());
  EXPECT_EQ(a.view_weapon == nullptr, b.view_weapon == nullptr);
  // Other frames may change a trail's last particle, and places by rounding.
  EXPECT_LE(without_a_twin(list_particles(a), list_particles(b)), 2u);
  EXPECT_LE(without_a_twin(list_particles(b), list_particles(a)), 2u);
}

// At random times, in random order, a seek shows what playing shows.
void expect_seeks_as_played(const std::filesystem::path& folder, const base::ByteVector& bytes, int times,
                            std::uint64_t seed) {
  Random random(seed);
  Played played(folder, bytes), sought(folder, bytes);
  PresentationSettings settings;
  const double begin_s = played.session.begin_s(), end_s = played.session.end_s();
  std::vector<double> times_s = {begin_s, end_s};
  for (int i = 0; i < times; ++i) times_s.push_back(random.uniform(begin_s, end_s));
  std::sort(times_s.begin(), times_s.end());
  ASSERT_TRUE(played.session.advance(0, settings).value());
  for (const double time_s : times_s) {
    ASSERT_TRUE(played.session.advance(time_s - played.session.time_s(), settings).value());
    ASSERT_TRUE(sought.session.seek(random.uniform(begin_s, end_s), settings).value());
    ASSERT_TRUE(sought.session.seek(time_s, settings).value());
    EXPECT_NEAR(sought.session.time_s(), played.session.time_s(), 1e-9);
    // Not exact to the last bit, as playing adds up times.
    EXPECT_NEAR(sought.session.server_time_s(), played.session.server_time_s(), 1e-9);
    ASSERT_TRUE(sought.session.seek(played.session.time_s(), settings).value());
    EXPECT_EQ(sought.session.server_time_s(), played.session.server_time_s());
    expect_same_game(sought.session.state().game(), played.session.state().game());
    expect_same_scene(sought.presentation.scene(), played.presentation.scene());
    const double server_s = played.session.server_time_s();
    EXPECT_EQ(all_values(sought.session.state().interpolate_entities(server_s, {})),
              all_values(played.session.state().interpolate_entities(server_s, {})));
    if (testing::Test::HasFailure()) FAIL() << "at " << time_s << ", seed " << seed;
  }
}

TEST(DemoSession, SeekingEqualsPlayingWithAllEffects) {
  expect_seeks_as_played(made_game().path(), made_bytes(), effort(60, 10), 1);
}

// Marks stay, so the whole level is replayed, and every particle is where it was.
TEST(DemoSession, SeekingWithMarksIsExact) {
  Played played(made_game().path(), made_bytes()), sought(made_game().path(), made_bytes());
  PresentationSettings settings;
  settings.effects.marks = true;
  ASSERT_TRUE(played.session.advance(0, settings).value());
  Random random(2);
  for (int second = 1; second < 16; ++second) {
    ASSERT_TRUE(played.session.advance(1, settings).value());
    ASSERT_TRUE(sought.session.seek(random.uniform(0, 20), settings).ok());
    ASSERT_TRUE(sought.session.seek(played.session.time_s(), settings).value());
    EXPECT_EQ(list_particles(sought.presentation.scene()), list_particles(played.presentation.scene()))
        << second;
    EXPECT_EQ(sought.presentation.scene().marks->size(), played.presentation.scene().marks->size()) << second;
  }
  EXPECT_GT(played.presentation.scene().marks->size(), 0u);
}

// The demo with marks that the game asks for: on the floor as the level begins, and on the door after 10
// seconds, in records without a time.
base::ByteVector bytes_with_marks() {
  constexpr std::size_t kSignonRecords = 2, kLaterRecords = 203;
  const Played plain(made_game().path(), made_bytes());
  const math::Bounds door =
      assets::load_level(plain.library.files(), "small").value().level->models[1].bounds;
  const auto make_record = [](const std::string& line) {
    base::ByteWriter writer;
    EXPECT_TRUE(net::write_message(net::StuffText{line}, {}, writer).ok());
    return std::move(writer).take();
  };
  const base::ByteVector bytes = made_bytes();
  formats::DemReader reader = formats::DemReader::open(bytes).value();
  formats::DemWriter marked;
  std::size_t records = 0;
  for (auto record = reader.next().value(); record; record = reader.next().value()) {
    marked.add(record->view_angles_deg, record->message);
    if (++records == kSignonRecords) marked.add({}, make_record("//temblor mark *scorch 210 220 1 24\n"));
    if (records == kLaterRecords)
      marked.add(
          record->view_angles_deg,
          make_record(fmt::format("//temblor mark *hole {} {} {} 8 0 *1\n", (door.mins.x + door.maxs.x) / 2,
                                  door.mins.y - 1, (door.mins.z + door.maxs.z) / 2)));
  }
  return std::move(marked).take();
}

TEST(DemoSession, MarksOfTheGameAreThereAfterSeeking) {
  const base::ByteVector bytes = bytes_with_marks();
  Played played(made_game().path(), bytes), sought(made_game().path(), bytes);
  const PresentationSettings settings;
  const auto count = [](const Played& of) { return of.presentation.scene().marks->size(); };
  Random random(6);
  ASSERT_TRUE(played.session.advance(0, settings).value());
  const std::size_t at_first = count(played);
  EXPECT_GT(at_first, 0u);
  for (int second = 1; second < 16; ++second) {
    ASSERT_TRUE(played.session.advance(1, settings).value());
    EXPECT_EQ(count(played) > at_first, second >= 10) << second;
    ASSERT_TRUE(sought.session.seek(random.uniform(0, 20), settings).ok());
    ASSERT_TRUE(sought.session.seek(played.session.time_s(), settings).value());
    EXPECT_EQ(count(sought), count(played)) << second;
  }
}

// Exact where no trail is drawn.
TEST(DemoSession, BurstsAreTheSameAfterSeeking) {
  Played played(made_game().path(), made_bytes()), sought(made_game().path(), made_bytes());
  const PresentationSettings settings;
  std::size_t most = 0;
  ASSERT_TRUE(played.session.advance(0, settings).value());
  for (int step = 0; step < 12; ++step) {
    ASSERT_TRUE(played.session.advance(step == 0 ? 5.3 : 0.7, settings).value());
    ASSERT_TRUE(sought.session.seek(played.session.time_s(), settings).value());
    EXPECT_EQ(list_particles(sought.presentation.scene()), list_particles(played.presentation.scene()))
        << step;
    most = std::max(most, played.presentation.scene().particles.x.size());
  }
  EXPECT_GT(most, 100u);
}

class StockSeeks : public ::testing::TestWithParam<const char*> {};

TEST_P(StockSeeks, EqualPlaying) {
  DATA_FOLDER_OR_SKIP(folder);
  expect_seeks_as_played(folder, read_file(folder / "id1" / GetParam()), effort(24, 3), 3);
}

INSTANTIATE_TEST_SUITE_P(All, StockSeeks,
                         ::testing::Values("demo1_lite.dem", "demo2_lite.dem", "demo3_lite.dem", "demo3.dem"),
                         [](const auto& demo) {
                           const std::string name = demo.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(DemoSession, PlaysAtItsSpeed) {
  Played played(made_game().path(), made_bytes());
  DemoSession& session = played.session;
  const PresentationSettings settings;
  EXPECT_EQ(session.time_s(), session.begin_s());
  ASSERT_TRUE(session.advance(9, settings).value());
  EXPECT_EQ(session.time_s(), session.begin_s()) << "the first call only begins";
  ASSERT_TRUE(session.advance(0.5, settings).value());
  EXPECT_DOUBLE_EQ(session.time_s(), session.begin_s() + 0.5);
  session.set_speed(0.1);
  ASSERT_TRUE(session.advance(1, settings).value());
  EXPECT_DOUBLE_EQ(session.time_s(), session.begin_s() + 0.6);
  session.set_speed(8);
  ASSERT_TRUE(session.advance(0.05, settings).value());
  EXPECT_DOUBLE_EQ(session.time_s(), session.begin_s() + 1);
  session.pause(true);
  ASSERT_TRUE(session.advance(100, settings).value());
  ASSERT_TRUE(session.advance(-100, settings).value());
  EXPECT_DOUBLE_EQ(session.time_s(), session.begin_s() + 1);
  for (const double wild : {1e9, -3.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    session.set_speed(wild);
    EXPECT_EQ(session.speed(), wild > 1 ? 8 : 0.1);
  }
}

TEST(DemoSession, EndsAndCanBeRewound) {
  Played played(made_game().path(), made_bytes());
  DemoSession& session = played.session;
  const PresentationSettings settings;
  ASSERT_TRUE(session.advance(0, settings).value());
  EXPECT_FALSE(session.advance(1000, settings).value());
  EXPECT_TRUE(session.has_ended());
  EXPECT_EQ(session.time_s(), session.end_s());
  EXPECT_FALSE(session.advance(1, settings).value());
  ASSERT_TRUE(session.seek(-1e30, settings).value());
  EXPECT_EQ(session.time_s(), session.begin_s());
  EXPECT_FALSE(session.has_ended());
  EXPECT_FALSE(session.seek(std::numeric_limits<double>::infinity(), settings).value());
  EXPECT_EQ(session.time_s(), session.end_s());
  ASSERT_TRUE(session.seek(std::numeric_limits<double>::quiet_NaN(), settings).value());
  EXPECT_EQ(session.time_s(), session.begin_s());
  ASSERT_TRUE(session.seek(session.end_s(), settings).value()) << "the last moment is not past the end";
}

TEST(DemoSession, StepsFromPacketToPacket) {
  Played played(made_game().path(), made_bytes());
  DemoSession& session = played.session;
  const PresentationSettings settings;
  ASSERT_TRUE(session.seek(session.begin_s() + 2, settings).value());
  const double here_s = session.time_s();
  ASSERT_TRUE(session.step(1, settings).value());
  EXPECT_NEAR(session.time_s(), here_s + made_recording::kPacket_s, 1e-6);
  ASSERT_TRUE(session.step(-3, settings).value());
  EXPECT_NEAR(session.time_s(), here_s - 2 * made_recording::kPacket_s, 1e-6);
  ASSERT_TRUE(session.step(-1'000'000, settings).value());
  EXPECT_EQ(session.time_s(), session.begin_s());
  EXPECT_FALSE(session.step(1'000'000, settings).value());
  ASSERT_TRUE(session.step(0, settings).value()) << "the last packet";
  EXPECT_EQ(session.time_s(), session.end_s());
  ASSERT_TRUE(session.step(0, settings).value()) << "and there it stays";
  EXPECT_EQ(session.time_s(), session.end_s());
  ASSERT_TRUE(session.step(-1, settings).value());
  ASSERT_TRUE(session.step(1, settings).value()) << "the last packet";
  EXPECT_FALSE(session.step(1, settings).value());
}

// Plays like a benchmark: each time of the demo once, then the end. Some packets have equal times.
TEST(DemoSession, StepsToItsEnd) {
  Played played(made_game().path(), made_three_times());
  const PresentationSettings settings;
  std::size_t steps = 0;
  double before_s = -1;
  for (; played.session.step(1, settings).value(); ++steps) {
    ASSERT_GT(played.session.time_s(), before_s);
    before_s = played.session.time_s();
  }
  EXPECT_GT(steps, 3 * made_recording::kLength_s / made_recording::kPacket_s - 10);
  EXPECT_LE(steps, played.session.length().packets);
}

// Playing reports every event once; seeking reports only the level.
TEST(DemoSession, ListenersGetPlayedEventsOnly) {
  Played played(made_game().path(), made_bytes());
  DemoSession& session = played.session;
  const PresentationSettings settings;
  std::size_t sounds = 0, levels = 0, temp_entities = 0;
  session.set_listener([&](const client::Events& events, const client::Game& game, double) {
    sounds += events.sounds.size();
    temp_entities += events.temp_entities.size();
    levels += events.new_level ? 1 : 0;
    EXPECT_FALSE(game.models.empty());
  });
  ASSERT_TRUE(session.advance(0, settings).value());
  EXPECT_EQ(levels, 1u);
  while (session.advance(0.013, settings).value()) continue;
  const std::size_t all = temp_entities;
  EXPECT_GT(all, 10u);
  EXPECT_EQ(levels, 1u);
  ASSERT_TRUE(session.seek(session.begin_s() + 7, settings).value());
  EXPECT_EQ(temp_entities, all);
  EXPECT_EQ(levels, 2u);
  ASSERT_TRUE(session.seek(session.begin_s(), settings).value());
  while (session.advance(0.3, settings).value()) continue;
  EXPECT_EQ(temp_entities, 2 * all);
}

// The test's game has no sounds; their entities and places show that they were requested.
TEST(DemoSession, SkippedSoundsAreNotPlayed) {
  Played played(made_game().path(), made_bytes());
  DemoSession& session = played.session;
  PresentationSettings settings;
  settings.sound = true;
  audio::SoundEvents& events = played.presentation.audio_scene().events();
  ASSERT_TRUE(session.advance(0, settings).value());
  events.clear();
  for (double second = 0; second < 1.5; second += 0.02) ASSERT_TRUE(session.advance(0.02, settings).value());
  EXPECT_FALSE(events.started.empty()) << "the shot";
  events.clear();
  ASSERT_TRUE(session.seek(session.begin_s() + 5.5, settings).value());
  EXPECT_TRUE(events.stops_all);
  EXPECT_TRUE(events.started.empty()) << "the explosion on the way";
}

TEST(DemoSession, SeeksAcrossLevels) {
  const base::ByteVector bytes = made_three_times();
  Played played(made_game().path(), bytes);
  ASSERT_EQ(played.session.length().levels.size(), 3u);
  expect_seeks_as_played(made_game().path(), bytes, effort(60, 10), 4);
}

base::ByteVector damaged_bytes() {
  base::ByteVector bytes = made_bytes();
  // In the middle of the file: an impossible record length.
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2), bytes.end(), std::byte{0xfe});
  return bytes;
}

TEST(DemoSession, DamageIsReportedOnceAndSeekingContinues) {
  for (const bool by_seeking : {false, true}) {
    Played played(made_game().path(), damaged_bytes());
    DemoSession& session = played.session;
    const PresentationSettings settings;
    ASSERT_TRUE(session.length().damage);
    EXPECT_LT(session.end_s(), session.begin_s() + made_recording::kLength_s);
    ASSERT_TRUE(session.advance(0, settings).value());
    ASSERT_TRUE(session.seek(session.end_s(), settings).value())
        << "everything before the damage can be shown";
    const auto end = by_seeking ? session.seek(1e6, settings) : session.advance(1e6, settings);
    ASSERT_FALSE(end.ok());
    EXPECT_EQ(end.error().message(), session.length().damage->message());
    EXPECT_TRUE(session.has_ended());
    EXPECT_EQ(session.time_s(), session.end_s());
    EXPECT_FALSE(session.advance(1, settings).value());
    ASSERT_TRUE(session.seek(session.begin_s() + 1, settings).value());
    EXPECT_FALSE(session.seek(1e6, settings).value()) << "not again";
    EXPECT_TRUE(played.presentation.has_level());
  }
}

// With any bytes changed: if the demo opens, every seek ends.
TEST(DemoSession, SurvivesChangedBytes) {
  const base::ByteVector whole = made_bytes();
  const assets::Library library(vfs::FileSystem::open(made_game().path()).value());
  const PresentationSettings settings;
  for (int seed = 0; seed < effort(40, 6); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    base::ByteVector bytes = whole;
    for (std::size_t i = 1 + random.below(30); i > 0; --i)
      bytes[random.below(bytes.size())] = static_cast<std::byte>(random.bits());
    Presentation presentation(library);
    auto session = DemoSession::open(bytes, "changed.dem", presentation);
    if (!session.ok()) continue;
    for (int i = 0; i < 6; ++i) {
      const double time_s = random.uniform(session->begin_s() - 1, session->end_s() + 1);
      const auto sought = session->seek(time_s, settings);
      if (!sought.ok() && !session->length().damage) break;  // its level is not in the test's game
      (void)session->advance(random.uniform(0, 1), settings);
    }
  }
}

TEST(DemoSession, NothingToShowIsAnError) {
  const assets::Library library(vfs::FileSystem::open(made_game().path()).value());
  Presentation presentation(library);
  EXPECT_FALSE(DemoSession::open(to_bytes("PACK"), "x.dem", presentation).ok());
  EXPECT_FALSE(DemoSession::open(DemoBuilder().bytes(), "x.dem", presentation).ok());
}

TEST(DemoSession, AFreeCameraSeesThePlayer) {
  Played played(made_game().path(), made_bytes());
  PresentationSettings settings;
  ASSERT_TRUE(played.session.seek(played.session.begin_s() + 2.5, settings).value());
  const render::Scene eyes = played.presentation.scene();
  const std::size_t models = eyes.alias_models.size();
  client::FreeCamera camera;
  camera.place(eyes.camera);
  camera.fly({.forward = 1}, 100, 0.5, nullptr);
  settings.camera = camera.camera();
  played.session.pause(true);
  ASSERT_TRUE(played.session.advance(1, settings).value());
  const render::Scene& free = played.presentation.scene();
  EXPECT_EQ(free.camera.origin_world, camera.camera().origin_world);
  EXPECT_EQ(free.view_weapon, nullptr);
  EXPECT_GE(free.alias_models.size(), models);
  settings.camera.reset();
  ASSERT_TRUE(played.session.advance(1, settings).value());
  EXPECT_NE(played.presentation.scene().view_weapon, nullptr);
}

// The index is made in one pass; a seek replays seconds, not minutes.
TEST(DemoSession, SeeksAreQuick) {
  DATA_FOLDER_OR_SKIP(folder);
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  const assets::Library library(vfs::FileSystem::open(folder).value());
  Presentation presentation(library);
  const PresentationSettings settings;
  const auto begin = Clock::now();
  auto session =
      DemoSession::open(read_file(folder / "id1" / "demo1_lite.dem"), "demo1_lite.dem", presentation).value();
  ::testing::Test::RecordProperty("open_ms", std::to_string(1000 * seconds_since(begin)));
  ASSERT_TRUE(session.advance(0, settings).value());
  Random random(5);
  double worst_s = 0;
  for (int i = 0; i < 10; ++i) {
    const auto before = Clock::now();
    ASSERT_TRUE(session.seek(random.uniform(session.begin_s(), session.end_s()), settings).value());
    worst_s = std::max(worst_s, seconds_since(before));
  }
  ::testing::Test::RecordProperty("worst_seek_ms", std::to_string(1000 * worst_s));
  EXPECT_LT(worst_s, kQuick ? 60 : 3) << "far more than needed";
}

}  // namespace
}  // namespace temblor::test
