// The light cache: after any edit of the lights, the light equals that without a cache.
#include "compiler/light/light_cache.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "artgen/small_level.h"
#include "compiler/light/lighting.h"
#include "compiler/light/shadows/shadow_record.h"
#include "formats/levels/entities.h"
#include "support/effort.h"
#include "support/mutations.h"
#include "support/random.h"
#include "world/level.h"

namespace temblor::test {
namespace {

using compiler::LightCache;
using formats::Entity;

// A hall with pillars, a door and a court under the sky, with lamps of every kind.
class EditedLevel {
 public:
  explicit EditedLevel(std::uint64_t seed) : bsp_(artgen::make_small_level({.light = false})), random_(seed) {
    entities_ = formats::read_entities(bsp_.entities).value();
    std::erase_if(entities_, [](const Entity& entity) { return entity.classname().starts_with("light"); });
    for (int i = 0; i < 8; ++i) add_lamp();
  }

  formats::Bsp bsp() const {
    formats::Bsp copy = bsp_;
    copy.entities = formats::write_entities(entities_);
    return copy;
  }

  // Makes a random edit and describes it.
  std::string edit() {
    Entity& lamp = entities_[first_lamp() + random_.below(entities_.size() - first_lamp())];
    switch (random_.below(10)) {
      case 0:
      case 1:
        return set(lamp, "origin", place());
      case 2:
        return set(lamp, "light", fmt::format("{}", random_.uniform(-100, 500)));
      case 3:
        return set(lamp, "delay", fmt::format("{}", random_.below(6)));
      case 4:
        return set(lamp, "_color", fmt::format("1 {} 0.5", random_.uniform(0, 1)));
      case 5:
        return set(lamp, "style", fmt::format("{}", random_.below(4)));
      case 6:
        add_lamp();
        return "added";
      case 7:
        std::swap(lamp, entities_.back());
        return "swapped";
      case 8:
        if (entities_.size() - first_lamp() > 2) entities_.pop_back();
        return "removed";
      default:
        return edit_world();
    }
  }

 private:
  std::size_t first_lamp() const {
    const auto lamp = std::find_if(entities_.begin(), entities_.end(),
                                   [](const Entity& entity) { return entity.classname() == "light"; });
    return static_cast<std::size_t>(lamp - entities_.begin());
  }
  // A point in one of the level's rooms, sometimes in a wall.
  std::string place() {
    const auto boxes = artgen::small_level_boxes();
    const math::Bounds& box = boxes[random_.below(boxes.size())].bounds;
    const auto within = [&](int axis) { return random_.uniform(box.mins[axis], box.maxs[axis]); };
    const double x = within(0), y = within(1), z = within(2);
    return fmt::format("{:.0f} {:.0f} {:.0f}", x, y, z);
  }
  void add_lamp() {
    Entity lamp;
    lamp.pairs = {{"classname", "light"}, {"origin", place()}};
    entities_.push_back(std::move(lamp));
  }
  std::string edit_world() {
    static constexpr std::pair<const char*, double> kKeys[] = {
        {"_dirt", 1},          {"_dirtscale", 2},
        {"_bounce", 2.9},      {"_sunlight", 200},
        {"_sunlight2", 60},    {"_range", 1},
        {"_dist", 2},          {"_anglescale", 1},
        {"_minlight", 30},     {"_sunlight_penumbra", 4},
        {"_dirtdepth", 99},    {"_gamma", 2},
        {"_bouncescale", 1.5}, {"_sun2", -60}};
    const auto& [key, most] = kKeys[random_.below(std::size(kKeys))];
    return set(entities_[0], key, fmt::format("{:.3f}", random_.uniform(0, 1) * most));
  }
  static std::string set(Entity& entity, const std::string& key, const std::string& value) {
    std::erase_if(entity.pairs, [&](const auto& pair) { return pair.first == key; });
    entity.pairs.emplace_back(key, value);
    return key + " " + value;
  }

  formats::Bsp bsp_;
  std::vector<Entity> entities_;
  Random random_;
};

TEST(LightCache, GivesTheSameBytesAfterAnyEdits) {
  for (std::uint64_t seed = 0; seed < effort(12, 1); ++seed) {
    EditedLevel level(seed);
    LightCache cache;
    std::string edits;
    for (int i = 0; i < effort(8, 4); ++i) {
      const LitResult fresh = light(level.bsp()), cached = light(level.bsp(), {}, 2, &cache);
      ASSERT_EQ(cached.bsp, fresh.bsp) << "seed " << seed << edits;
      ASSERT_EQ(cached.summary.lit, fresh.summary.lit) << "seed " << seed << edits;
      // The new cache equals that of a first run.
      LightCache clean_cache;
      light(level.bsp(), {}, 1, &clean_cache);
      ASSERT_EQ(cache, clean_cache) << "seed " << seed << edits;
      edits += "; " + level.edit();
    }
  }
}

// The light with a part of the cache changed by hand, so that its use shows.
template <typename Change>
bool is_used(const formats::Bsp& bsp, const LightCache& cache, Change change) {
  LightCache changed = cache;
  change(changed);
  return light(bsp, {}, 1, &changed).bsp != light(bsp).bsp;
}

std::size_t count_luxels(const world::Face& face) {
  return static_cast<std::size_t>(face.light_width()) * static_cast<std::size_t>(face.light_height());
}

// Changes the answers of a shadow record that cover all luxels to no light at all.
base::ByteVector darkened(const base::ByteVector& shadows, std::size_t luxels, std::size_t lights) {
  std::vector<std::uint32_t> all(luxels);
  std::iota(all.begin(), all.end(), 0u);
  compiler::ShadowReader reader(shadows, luxels);
  compiler::ShadowWriter writer(luxels);
  for (std::uint32_t light = 0; light < lights; ++light)
    for (const bool rough : {false, true})
      if (reader.find({light, all, rough}))
        writer.add({light, all, rough}, std::vector<compiler::Share>(luxels));
  return std::move(writer).take();
}

TEST(LightCache, IsUsed) {
  EditedLevel level(1);
  formats::Bsp bsp = level.bsp();
  bsp.entities.insert(bsp.entities.find('}'), "\"_dirt\" \"1\" \"_bounce\" \"2\" \"_sunlight\" \"200\"");
  LightCache cache;
  light(bsp, {}, 1, &cache);
  EXPECT_TRUE(is_used(bsp, cache, [](LightCache& io_cache) {
    for (LightCache::Map& map : io_cache.maps)
      for (compiler::LightLayer& layer : map.sky)
        for (math::Vec3& sample : layer.samples) sample *= 0.5f;
  }));
  EXPECT_TRUE(is_used(bsp, cache, [](LightCache& io_cache) {
    for (LightCache::Map& map : io_cache.maps)
      for (float& dirt : map.dirt) dirt *= 0.5f;
  }));
  EXPECT_TRUE(is_used(bsp, cache, [](LightCache& io_cache) {
    for (std::uint32_t& seen : io_cache.bounces) seen = 0;
  }));
  EXPECT_TRUE(is_used(bsp, cache, [&](LightCache& io_cache) {
    const auto level_read = world::make_level(bsp, "edited").value();
    for (std::size_t face = 0; face < level_read->faces.size(); ++face)
      io_cache.maps[face].shadows =
          darkened(io_cache.maps[face].shadows, count_luxels(level_read->faces[face]), cache.lights.size());
  }));
}

TEST(LightCache, IgnoresAnotherLevelAndOtherSampling) {
  EditedLevel level(2);
  formats::Bsp moved = level.bsp();
  for (math::Vec3& vertex : moved.vertices) vertex.z = vertex.z * 0.5f;
  LightCache cache;
  light(level.bsp(), {}, 1, &cache);
  LightCache other = cache;
  EXPECT_EQ(light(moved, {}, 1, &other).bsp, light(moved).bsp);
  const compiler::LightOptions finer{.extra = 4};
  EXPECT_EQ(light(level.bsp(), finer, 1, &cache).bsp, light(level.bsp(), finer).bsp);
}

TEST(LightCache, StoppingLeavesItUnchanged) {
  EditedLevel level(3);
  LightCache cache;
  light(level.bsp(), {}, 1, &cache);
  const LightCache before = cache;
  level.edit();
  formats::Bsp bsp = level.bsp();
  base::Jobs jobs(2, base::JobBackend::kStdThread);
  compiler::Warnings warnings;
  const auto keys = compiler::find_face_keys(bsp, formats::read_entities(bsp.entities).value());
  const auto stop_midway = [](std::size_t done, std::size_t total) { return done * 2 < total; };
  EXPECT_FALSE(compiler::light_level(bsp, keys, {}, jobs, stop_midway, warnings, &cache).ok());
  EXPECT_EQ(cache, before);
  EXPECT_EQ(bsp, level.bsp());
}

LightCache small_cache() {
  LightCache cache;
  light(room_with({"{ 'classname' 'light' 'origin' '10 0 0' 'light' '100' }", "'_dirt' '1' '_sunlight' '50'",
                   true}),
        {}, 1, &cache);
  cache.bounces = {1, 2, 3};
  return cache;
}

TEST(LightCacheFile, ReadsBackEqual) {
  for (const LightCache& cache : {LightCache{}, small_cache()}) {
    const auto read = compiler::read_light_cache(compiler::write_light_cache(cache));
    ASSERT_TRUE(read.ok()) << read.error().message();
    EXPECT_EQ(*read, cache);
  }
}

TEST(LightCacheFile, RejectsTruncationAndDamage) {
  const base::ByteVector bytes = compiler::write_light_cache(small_cache());
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / static_cast<std::size_t>(effort(60, 6)))
    ASSERT_FALSE(compiler::read_light_cache(base::Bytes(bytes).first(size)).ok()) << size;
  Random random(5);
  for (int i = 0; i < effort(200, 20); ++i) {
    const base::ByteVector damaged = with_flipped_bits(bytes, random);
    if (damaged == bytes) continue;
    ASSERT_FALSE(compiler::read_light_cache(damaged).ok()) << i;
  }
}

TEST(LightCacheFile, RejectsAnotherVersion) {
  base::ByteVector bytes = compiler::write_light_cache({});
  bytes[4] = std::byte{200};
  const auto read = compiler::read_light_cache(bytes);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, base::ErrorCode::kUnsupported);
}

}  // namespace
}  // namespace temblor::test
