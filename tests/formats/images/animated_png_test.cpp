// Animated PNG files: each frame, taken out again, is the file that went in.
#include "formats/images/animated_png.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/images/image.h"
#include "formats/images/png.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

constexpr int kWidth = 70, kHeight = 40;

std::vector<std::uint32_t> make_pixels(std::uint64_t seed) {
  test::Random random(seed);
  std::vector<std::uint32_t> pixels(kWidth * kHeight);
  for (std::uint32_t& pixel : pixels) pixel = static_cast<std::uint32_t>(random.bits()) | 0xff000000;
  return pixels;
}

struct Chunk {
  std::string type;
  base::ByteVector content;
};

std::uint32_t big_endian(base::Bytes bytes) {
  std::uint32_t value = 0;
  for (const std::byte byte : bytes.first(4)) value = value << 8 | static_cast<std::uint32_t>(byte);
  return value;
}

std::vector<Chunk> read_chunks(base::Bytes png) {
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at < png.size();) {
    const std::size_t size = big_endian(png.subspan(at));
    const base::Bytes content = png.subspan(at + 8, size);
    chunks.push_back({std::string(base::as_text(png.subspan(at + 4, 4))), {content.begin(), content.end()}});
    at += size + 12;
  }
  return chunks;
}

TEST(AnimatedPng, HoldsAllFrames) {
  std::vector<base::ByteVector> files;
  for (std::uint64_t i = 0; i < 5; ++i) files.push_back(write_png(make_pixels(i), kWidth, kHeight).value());
  const base::ByteVector film = join_png_frames(files, 12);

  // A reader that does not know films sees the first frame. It checks all checksums.
  const auto still = read_png(film);
  ASSERT_TRUE(still.ok()) << still.error().message();
  EXPECT_EQ(still->pixels, make_pixels(0));

  std::uint32_t sequence = 0;
  std::vector<base::ByteVector> pixels;  // by frame
  for (const Chunk& chunk : read_chunks(film)) {
    const base::Bytes content = chunk.content;
    if (chunk.type == "acTL") {
      EXPECT_EQ(big_endian(content), files.size());
      EXPECT_TRUE(pixels.empty());
    } else if (chunk.type == "fcTL") {
      EXPECT_EQ(big_endian(content), sequence++);
      EXPECT_EQ(big_endian(content.subspan(4)), static_cast<std::uint32_t>(kWidth));
      EXPECT_EQ(big_endian(content.subspan(8)), static_cast<std::uint32_t>(kHeight));
      EXPECT_EQ(big_endian(content.subspan(20)), 1u << 16 | 12u) << "a twelfth of a second";
      pixels.emplace_back();
    } else if (chunk.type == "IDAT") {
      EXPECT_EQ(pixels.size(), 1u);
      pixels.back().insert(pixels.back().end(), content.begin(), content.end());
    } else if (chunk.type == "fdAT") {
      EXPECT_EQ(big_endian(content), sequence++);
      EXPECT_GT(pixels.size(), 1u);
      pixels.back().insert(pixels.back().end(), content.begin() + 4, content.end());
    }
  }
  ASSERT_EQ(pixels.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    base::ByteVector wanted;
    for (const Chunk& chunk : read_chunks(files[i]))
      if (chunk.type == "IDAT") wanted.insert(wanted.end(), chunk.content.begin(), chunk.content.end());
    EXPECT_EQ(pixels[i], wanted) << i;
  }
}

}  // namespace
}  // namespace temblor::formats
