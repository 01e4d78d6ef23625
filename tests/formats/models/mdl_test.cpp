#include "formats/models/mdl.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "support/game_data.h"
#include "support/models/small_models.h"
#include "support/mutations.h"

namespace temblor::formats {
namespace {

using ::testing::HasSubstr;

// Offsets of fields in the header.
constexpr std::size_t kVersionAt = 4, kScaleAt = 8, kOriginAt = 20, kRadiusAt = 32, kEyeAt = 36,
                      kSkinsAt = 48, kWidthAt = 52, kHeightAt = 56, kVerticesAt = 60, kTrianglesAt = 64,
                      kFramesAt = 68, kSizeAt = 80, kMdlHeaderBytes = 84;

// The smallest model, byte by byte: one texel, vertex, triangle, and frame.
constexpr std::size_t kSmallestTexelAt = kMdlHeaderBytes + 4 + 1, kSmallestTriangleAt = kSmallestTexelAt + 12,
                      kSmallestFrameAt = kSmallestTriangleAt + 16, kSmallestVertexAt = kSmallestFrameAt + 28;
base::ByteVector smallest_model() {
  base::ByteWriter writer;
  writer.bytes(base::as_bytes("IDPO"));
  writer.i32(6);
  for (const float number : {1.0f, 2.0f, 3.0f, -4.0f, -5.0f, -6.0f, 7.0f, 8.0f, 9.0f, 10.0f})
    writer.f32(number);
  for (const int number : {1, 1, 1, 1, 1, 1, 0, 8 | 2}) writer.i32(number);
  writer.f32(11.0f);
  writer.i32(0);
  writer.u8(77);
  for (const int number : {0x20, 5, -6}) writer.i32(number);
  for (const int number : {0, 0, 0, 0}) writer.i32(number);
  writer.i32(0);
  for (const int byte : {1, 2, 3, 0, 4, 5, 6, 0}) writer.u8(static_cast<std::uint8_t>(byte));
  writer.fixed_text("frame", 16);
  for (const int byte : {9, 8, 7, 161}) writer.u8(static_cast<std::uint8_t>(byte));
  return std::move(writer).take();
}

std::string error_of_mdl(base::Bytes bytes) {
  const auto mdl = read_mdl(bytes);
  return mdl.ok() ? "no error" : mdl.error().what;
}

TEST(Mdl, ReadsHandMadeFile) {
  const auto mdl = read_mdl(smallest_model());
  ASSERT_TRUE(mdl.ok()) << mdl.error().message();
  EXPECT_EQ(mdl->scale, math::Vec3(1, 2, 3));
  EXPECT_EQ(mdl->origin, math::Vec3(-4, -5, -6));
  EXPECT_EQ(mdl->bounding_radius, 7);
  EXPECT_EQ(mdl->eye, math::Vec3(8, 9, 10));
  EXPECT_EQ(mdl->skin_width, 1u);
  EXPECT_EQ(mdl->skin_height, 1u);
  EXPECT_FALSE(mdl->random_phase);
  EXPECT_EQ(mdl->flags, std::uint32_t{kMdlRotate | kMdlGrenadeSmoke});
  EXPECT_EQ(mdl->average_triangle_size, 11);
  ASSERT_EQ(mdl->skins.size(), 1u);
  EXPECT_EQ(mdl->skins[0], (MdlSkin{{{77}}, {}}));
  ASSERT_EQ(mdl->texels.size(), 1u);
  EXPECT_EQ(mdl->texels[0], (MdlTexel{true, 5, -6}));
  ASSERT_EQ(mdl->triangles.size(), 1u);
  EXPECT_EQ(mdl->triangles[0], (MdlTriangle{false, {0, 0, 0}}));
  ASSERT_EQ(mdl->frames.size(), 1u);
  const MdlPose pose{{{1, 2, 3}, 0}, {{4, 5, 6}, 0}, "frame", {{{9, 8, 7}, 161}}};
  EXPECT_EQ(mdl->frames[0], (MdlFrame{{pose}, {}, {}, {}}));
  EXPECT_EQ(write_mdl(*mdl), smallest_model());
}

TEST(Mdl, RoundTrips) {
  const auto back = read_mdl(write_mdl(test::small_mdl()));
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(*back, test::small_mdl());
}

TEST(Mdl, MayBeLargerThanTheOriginalAllowed) {
  Mdl mdl = test::small_mdl();
  mdl.texels.resize(5000, {false, 1, 1});
  mdl.triangles.resize(9000, {true, {4999, 2500, 0}});
  for (MdlFrame& frame : mdl.frames)
    for (MdlPose& pose : frame.poses) pose.vertices.resize(5000);
  mdl.frames.resize(300, mdl.frames.front());
  mdl.skin_width = 33;
  mdl.skin_height = 1000;
  mdl.skins = {{{std::vector<std::uint8_t>(33 * 1000)}, {}}};
  const auto back = read_mdl(write_mdl(mdl));
  ASSERT_TRUE(back.ok()) << back.error().message();
  EXPECT_EQ(*back, mdl);
}

TEST(Mdl, IgnoresTrailingBytes) {
  base::ByteVector bytes = smallest_model();
  bytes.resize(bytes.size() + 3);
  const auto mdl = read_mdl(bytes);
  ASSERT_TRUE(mdl.ok());
  EXPECT_EQ(write_mdl(*mdl), smallest_model());
}

TEST(Mdl, RejectsEveryTruncationWithOffset) {
  for (const base::ByteVector& model : {smallest_model(), write_mdl(test::small_mdl())}) {
    test::for_each_truncation(model, [](const base::ByteVector& bytes) {
      const std::string what = error_of_mdl(bytes);
      EXPECT_THAT(what, HasSubstr(bytes.size() < kMdlHeaderBytes ? "header needs 84 bytes" : "at offset 0x"));
    });
  }
}

TEST(Mdl, RejectsHostileCounts) {
  const base::ByteVector valid = smallest_model();
  struct Count {
    std::size_t at;
    const char* name;
  };
  for (const Count& count :
       {Count{kSkinsAt, "skins"}, Count{kWidthAt, "width"}, Count{kHeightAt, "height"},
        Count{kVerticesAt, "vertices"}, Count{kTrianglesAt, "triangles"}, Count{kFramesAt, "frames"}}) {
    for (const std::uint32_t number : {0u, 1u << 31, ~0u, kMaxMdlTriangles + 1}) {
      const std::string what = error_of_mdl(test::with_number(valid, count.at, number));
      EXPECT_THAT(what, HasSubstr(count.name));
      EXPECT_THAT(what, HasSubstr(fmt::format("offset {:#x}", count.at)));
      EXPECT_THAT(what, HasSubstr(number == 0 ? "no " : std::to_string(number)));
    }
    // The counts are allowed, but the bytes are missing. (The skin coordinates are not valid as a second
    // skin.)
    EXPECT_THAT(error_of_mdl(test::with_number(valid, count.at, kMaxMdlSkinSide)),
                HasSubstr(count.at == kSkinsAt ? "skin 1 at offset 0x59: unknown type" : "are left"));
  }
}

TEST(Mdl, RejectsOtherMagicAndVersion) {
  EXPECT_THAT(error_of_mdl(test::with_number(smallest_model(), 0, std::uint8_t{'J'})),
              HasSubstr("not a model"));
  EXPECT_THAT(error_of_mdl(test::with_number(smallest_model(), kVersionAt, 7)), HasSubstr("version 7"));
}

TEST(Mdl, RejectsNonFiniteNumbers) {
  const float infinity = std::numeric_limits<float>::infinity();
  struct Number {
    std::size_t at;
    const char* name;
  };
  for (const Number& number :
       {Number{kScaleAt, "scale"}, Number{kScaleAt + 8, "scale"}, Number{kOriginAt + 4, "origin"}}) {
    for (const float value : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN()})
      EXPECT_THAT(error_of_mdl(test::with_number(smallest_model(), number.at, value)),
                  HasSubstr(fmt::format("header at offset {:#x}: {} is", number.at, number.name)));
  }
  for (const std::size_t at : {kScaleAt, kOriginAt + 8})
    EXPECT_THAT(error_of_mdl(test::with_number(smallest_model(), at, -1e30f)), HasSubstr("units away")) << at;
}

TEST(Mdl, UnusedNumbersMayBeAnything) {
  for (const std::size_t at : {kRadiusAt, kEyeAt + 8, kSizeAt}) {
    const auto mdl =
        read_mdl(test::with_number(smallest_model(), at, std::numeric_limits<float>::quiet_NaN()));
    ASSERT_TRUE(mdl.ok()) << mdl.error().message();
    EXPECT_EQ(write_mdl(*mdl), test::with_number(smallest_model(), at, 0.0f));
  }
}

TEST(Mdl, ReplacesNormalsThatDoNotExist) {
  for (const int normal : {162, 255}) {
    const auto mdl = read_mdl(
        test::with_number(smallest_model(), kSmallestVertexAt + 3, static_cast<std::uint8_t>(normal)));
    ASSERT_TRUE(mdl.ok()) << mdl.error().message();
    EXPECT_EQ(mdl->frames[0].poses[0].vertices[0].normal, 0);
  }
}

TEST(Mdl, RejectsIndicesOutOfRange) {
  const base::ByteVector valid = smallest_model();
  for (const std::uint32_t vertex : {1u, 1u << 31})
    EXPECT_EQ(
        error_of_mdl(test::with_number(valid, kSmallestTriangleAt + 8, vertex)),
        fmt::format("triangles at offset {:#x}: each has a vertex past the end (1)", kSmallestTriangleAt));
  EXPECT_THAT(error_of_mdl(test::with_number(valid, kSmallestTexelAt + 4, 1 << 30)),
              HasSubstr(fmt::format("vertex 0 at offset {:#x}: 1073741824, -6", kSmallestTexelAt)));
}

TEST(Mdl, LeavesOutTrianglesOfMissingVertices) {
  constexpr std::size_t kTriangleCountAt = 64, kTriangleBytes = 16;
  base::ByteVector bytes = test::with_number(smallest_model(), kTriangleCountAt, 3);
  for (const std::uint32_t vertex : {1u, ~0u}) {
    const auto at = bytes.begin() + kSmallestTriangleAt;
    bytes.insert(at, kTriangleBytes, std::byte{0});
    bytes = test::with_number(bytes, kSmallestTriangleAt + 12, vertex);
  }
  const auto mdl = read_mdl(bytes);
  ASSERT_TRUE(mdl.ok()) << mdl.error().message();
  EXPECT_EQ(write_mdl(*mdl), smallest_model());
}

TEST(Mdl, RejectsUnknownGroupTypes) {
  EXPECT_THAT(error_of_mdl(test::with_number(smallest_model(), kMdlHeaderBytes, 2)),
              HasSubstr("skin 0 at offset 0x54: unknown type 2"));
  EXPECT_THAT(error_of_mdl(test::with_number(smallest_model(), kSmallestFrameAt, -1)),
              HasSubstr(fmt::format("frame 0 at offset {:#x}: unknown type -1", kSmallestFrameAt)));
}

// The second skin of small_mdl() is a group of two; member count and end times follow its type.
TEST(Mdl, GroupsOfSkins) {
  const base::ByteVector valid = write_mdl(test::small_mdl());
  constexpr std::size_t kGroupAt = kMdlHeaderBytes + 4 + 7 * 3;
  EXPECT_THAT(error_of_mdl(test::with_number(valid, kGroupAt + 4, 0)),
              HasSubstr("skin 1 at offset 0x6d: empty group"));
  EXPECT_THAT(error_of_mdl(test::with_number(valid, kGroupAt + 4, 1 << 30)), HasSubstr("4294967296 bytes"));
  const auto with_end = [&](std::size_t at, float end_s) {
    return read_mdl(test::with_number(valid, at, end_s)).value().skins[1].end_times_s;
  };
  const std::vector<float> ends = read_mdl(valid).value().skins[1].end_times_s;
  for (const float end_s : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(with_end(kGroupAt + 8, end_s), (std::vector<float>{0.1f, ends[1]})) << end_s;
  for (const float end_s : {0.25f, 0.1f, std::numeric_limits<float>::infinity()})
    EXPECT_EQ(with_end(kGroupAt + 12, end_s), (std::vector<float>{ends[0], ends[0] + 0.1f})) << end_s;
  // No time is after the largest one.
  EXPECT_THAT(error_of_mdl(test::with_number(valid, kGroupAt + 8, std::numeric_limits<float>::max())),
              HasSubstr(fmt::format("skin 1 at offset {:#x}: end time 1 of 2", kGroupAt + 12)));
}

TEST(Mdl, GroupsOfFrames) {
  const Mdl model = test::small_mdl();
  const base::ByteVector valid = write_mdl(model);
  const std::size_t group_at = valid.size() - (16 + 3 * 4 + 3 * (24 + 4 * 4));
  EXPECT_EQ(read_mdl(test::with_number(valid, group_at + 16 + 4, 0.05f)).value().frames[1].end_times_s[1],
            0.2f);
  // More members than a model may have poses, all present.
  Mdl crowded = model;
  crowded.texels.resize(1);
  crowded.triangles = {{true, {0, 0, 0}}};
  crowded.frames.resize(1);
  crowded.frames[0].poses[0].vertices.resize(1);
  base::ByteVector bytes = write_mdl(crowded);
  const base::ByteVector frame(bytes.end() - 32, bytes.end());
  for (std::uint32_t i = 1; i < kMaxMdlPoses; ++i) bytes.insert(bytes.end(), frame.begin(), frame.end());
  EXPECT_TRUE(read_mdl(test::with_number(bytes, kFramesAt, kMaxMdlPoses)).ok());
}

TEST(Mdl, SurvivesDamagedFiles) {
  const base::ByteVector valid = write_mdl(test::small_mdl());
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    test::Random random(seed);
    const auto mdl = read_mdl(test::with_flipped_bits(valid, random));
    if (!mdl.ok()) continue;
    const auto back = read_mdl(write_mdl(*mdl));
    ASSERT_TRUE(back.ok()) << "seed " << seed << ": " << back.error().message();
    EXPECT_EQ(*back, *mdl) << "seed " << seed;
  }
}

TEST(Mdl, StockModels) {
  DATA_FOLDER_OR_SKIP(data);
  int models = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1" / "progs")) {
    if (entry.path().extension() != ".mdl") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const base::ByteVector bytes = test::read_file(entry.path());
    const auto mdl = read_mdl(bytes);
    ASSERT_TRUE(mdl.ok()) << mdl.error().message();
    const auto back = read_mdl(write_mdl(*mdl));
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_EQ(*back, *mdl);
    ++models;
  }
  EXPECT_GT(models, 50);
}

}  // namespace
}  // namespace temblor::formats
