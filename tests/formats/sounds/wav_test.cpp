#include "formats/sounds/wav.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/game_data.h"
#include "support/mutations.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::size_t kFormatAt = 12, kKindAt = 20, kChannelsAt = 22, kRateAt = 24, kBitsAt = 34,
                      kDataAt = 36, kSamplesAt = 44;

void add_chunk(base::ByteWriter& io_writer, std::string_view name, const base::ByteWriter& content) {
  io_writer.bytes(base::as_bytes(name));
  io_writer.u32(static_cast<std::uint32_t>(content.size()));
  io_writer.bytes(content.view());
  io_writer.align(2);
}

// A file, byte by byte, from the description of the format of 1991.
class HandMade {
 public:
  HandMade(std::uint16_t channels, std::uint32_t rate, std::uint16_t bits) {
    base::ByteWriter format;
    format.u16(1);
    format.u16(channels);
    format.u32(rate);
    format.u32(rate * channels * bits / 8);
    format.u16(static_cast<std::uint16_t>(channels * bits / 8));
    format.u16(bits);
    add_chunk(chunks_, "fmt ", format);
  }
  HandMade& data(std::string_view bytes) {
    base::ByteWriter content;
    content.bytes(base::as_bytes(bytes));
    return chunk("data", content);
  }
  HandMade& cue(std::uint32_t number, std::uint32_t frame) {
    base::ByteWriter content;
    for (const std::uint32_t word : {1u, number, 0u}) content.u32(word);
    content.bytes(base::as_bytes("data"));
    for (const std::uint32_t word : {0u, 0u, frame}) content.u32(word);
    return chunk("cue ", content);
  }
  HandMade& mark(std::uint32_t cue_number, std::uint32_t frames, std::string_view purpose = "mark") {
    base::ByteWriter text;
    text.u32(cue_number);
    text.u32(frames);
    text.bytes(base::as_bytes(purpose));
    for (int i = 0; i < 4; ++i) text.u16(0);
    base::ByteWriter list;
    list.bytes(base::as_bytes("adtl"));
    add_chunk(list, "ltxt", text);
    return chunk("LIST", list);
  }
  HandMade& chunk(std::string_view name, const base::ByteWriter& content) {
    add_chunk(chunks_, name, content);
    return *this;
  }
  base::ByteVector bytes() const {
    base::ByteWriter writer;
    writer.bytes(base::as_bytes("RIFF"));
    writer.u32(static_cast<std::uint32_t>(4 + chunks_.size()));
    writer.bytes(base::as_bytes("WAVE"));
    writer.bytes(chunks_.view());
    return std::move(writer).take();
  }

 private:
  base::ByteWriter chunks_;
};

base::ByteVector ten_bytes() {
  return HandMade(1, 11025, 8).data("\x80\x81\x7f\xff\x01\x90\xa0\xb0\xc0\xd0").bytes();
}

std::string error_of_wav(base::Bytes bytes) {
  const auto wav = read_wav(bytes);
  return wav.ok() ? "no error" : wav.error().what;
}

std::optional<WavLoop> read_loop(const HandMade& file) {
  return read_wav(file.bytes()).value().loop;
}

TEST(Wav, EightBitsAreUnsignedInTheFile) {
  const Wav wav = read_wav(ten_bytes()).value();
  EXPECT_EQ(wav.frames_per_second, 11025u);
  EXPECT_EQ(wav.channels, 1);
  EXPECT_EQ(wav.bits, 8);
  EXPECT_THAT(wav.samples, ElementsAre(0, 1, -1, 127, -127, 16, 32, 48, 64, 80));
  EXPECT_FALSE(wav.loop);
}

TEST(Wav, SixteenBitsAreSigned) {
  using namespace std::string_view_literals;
  const Wav wav = read_wav(HandMade(2, 48000, 16).data("\x00\x00\xff\xff\x00\x80\xff\x7f"sv).bytes()).value();
  EXPECT_EQ(wav.frame_count(), 2u);
  EXPECT_THAT(wav.samples, ElementsAre(0, -1, -32768, 32767));
}

TEST(Wav, LoopStartsAtCueAndEndsAtMark) {
  const auto file = [] { return HandMade(1, 11025, 8).data("0123456789"); };
  EXPECT_EQ(read_loop(file()), std::nullopt);
  EXPECT_EQ(read_loop(file().cue(1, 0)), (WavLoop{0, 10}));
  EXPECT_EQ(read_loop(file().cue(1, 4)), (WavLoop{4, 10}));
  EXPECT_EQ(read_loop(file().cue(1, 4).mark(1, 3)), (WavLoop{4, 7}));
  EXPECT_EQ(read_loop(file().cue(1, 4).mark(1, 6)), (WavLoop{4, 10}));
  EXPECT_EQ(read_loop(file().cue(1, 4).mark(1, 7)), (WavLoop{4, 10})) << "too long";
  EXPECT_EQ(read_loop(file().cue(1, 4).mark(2, 3)), (WavLoop{4, 10})) << "of another point";
  EXPECT_EQ(read_loop(file().cue(1, 4).mark(1, 3, "rgn ")), (WavLoop{4, 10})) << "no mark";
  EXPECT_EQ(read_loop(file().cue(1, 10)), std::nullopt) << "outside";
  EXPECT_EQ(read_loop(file().cue(1, 0xffffffffu).mark(1, 0xffffffffu)), std::nullopt);
  EXPECT_EQ(read_loop(HandMade(1, 11025, 8).cue(1, 4).mark(1, 3).data("0123456789")), (WavLoop{4, 7}))
      << "in any order";
}

TEST(Wav, SkipsOtherChunks) {
  base::ByteWriter odd;
  odd.bytes(base::as_bytes("odd"));
  const Wav wav =
      read_wav(HandMade(1, 11025, 8).chunk("JUNK", odd).data("012").chunk("id3 ", odd).cue(1, 1).bytes())
          .value();
  EXPECT_EQ(wav.samples.size(), 3u);
  EXPECT_EQ(wav.loop, (WavLoop{1, 3}));
}

TEST(Wav, RoundTrips) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    Wav wav{.frames_per_second = 1000 + static_cast<std::uint32_t>(random.below(100000)),
            .channels = static_cast<std::uint16_t>(1 + random.below(3)),
            .bits = static_cast<std::uint16_t>(random.chance(0.5) ? 8 : 16),
            .samples = {},
            .loop = {}};
    const std::size_t frames = random.below(30);
    for (std::size_t i = 0; i < frames * wav.channels; ++i)
      wav.samples.push_back(wav.bits == 8
                                ? static_cast<std::int16_t>(static_cast<int>(random.below(256)) - 128)
                                : static_cast<std::int16_t>(random.bits()));
    if (frames > 1) {
      const auto start = static_cast<std::uint32_t>(random.below(frames - 1));
      wav.loop = WavLoop{start, start + 1 + static_cast<std::uint32_t>(random.below(frames - start))};
    }
    const auto back = read_wav(write_wav(wav));
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_EQ(*back, wav) << seed;
  }
}

TEST(Wav, HeaderMatchesWholeFile) {
  const Wav wav{.frames_per_second = 48000, .channels = 2, .bits = 16, .samples = {1, 2, 3, 4}, .loop = {}};
  const base::ByteVector whole = write_wav(wav), header = make_wav_header(48000, 2, 8);
  ASSERT_EQ(header.size(), kSamplesAt);
  EXPECT_TRUE(std::equal(header.begin(), header.end(), whole.begin()));
}

TEST(Wav, RejectsTruncationsWithoutSamples) {
  test::for_each_truncation(ten_bytes(), [](const base::ByteVector& bytes) {
    const std::string what = error_of_wav(bytes);
    if (bytes.size() < 12) {
      EXPECT_THAT(what, HasSubstr("not a WAV file"));
    } else if (bytes.size() < kFormatAt + 8) {
      EXPECT_THAT(what, HasSubstr("no fmt chunk"));
    } else if (bytes.size() < kDataAt) {
      EXPECT_THAT(what, HasSubstr("fmt chunk at offset 0xc"));
    } else if (bytes.size() < kSamplesAt) {
      EXPECT_THAT(what, HasSubstr("no data chunk"));
    } else {
      EXPECT_EQ(read_wav(bytes)->samples.size(), bytes.size() - kSamplesAt);
    }
  });
}

TEST(Wav, RejectsFaultsWithReason) {
  const base::ByteVector valid = ten_bytes();
  const auto with = [&](std::size_t at, auto number) {
    return error_of_wav(test::with_number(valid, at, number));
  };
  EXPECT_THAT(with(0, 0u), HasSubstr("not a WAV file"));
  EXPECT_THAT(with(kKindAt, std::uint16_t{2}), HasSubstr("format 2 of 8 bits; convert it to PCM"));
  EXPECT_THAT(with(kKindAt, std::uint16_t{0xfffe}), HasSubstr("format 65534"));
  EXPECT_THAT(with(kBitsAt, std::uint16_t{24}), HasSubstr("24 bits; convert it"));
  EXPECT_THAT(with(kChannelsAt, std::uint16_t{0}), HasSubstr("0 channels"));
  EXPECT_THAT(with(kChannelsAt, std::uint16_t{9}), HasSubstr("9 channels"));
  EXPECT_THAT(with(kRateAt, 999u), HasSubstr("999 frames per second"));
  EXPECT_THAT(with(kRateAt, 0xffffffffu), HasSubstr("4294967295 frames per second"));
  EXPECT_EQ(with(kDataAt + 4, 0xffffffffu), "no error");  // plays the ten bytes that are there
}

TEST(Wav, DamagedFilesStayInBounds) {
  const base::ByteVector valid = HandMade(2, 22050, 16).data("0123456789ab").cue(1, 1).mark(1, 2).bytes();
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    test::Random random(seed);
    const auto wav = read_wav(test::with_flipped_bits(valid, random));
    if (wav.ok() && wav->loop) {
      ASSERT_LT(wav->loop->start, wav->loop->end) << seed;
      ASSERT_LE(wav->loop->end, wav->frame_count()) << seed;
    }
  }
}

TEST(Wav, StockSoundsAreRead) {
  DATA_FOLDER_OR_SKIP(data);
  std::size_t count = 0, loops = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data / "id1/sound")) {
    if (entry.path().extension() != ".wav") continue;
    const auto wav = read_wav(test::read_file(entry.path()));
    ASSERT_TRUE(wav.ok()) << entry.path() << ": " << wav.error().message();
    ++count;
    if (wav->loop) ++loops;
  }
  EXPECT_GT(count, 200u);
  EXPECT_GT(loops, 10u) << "LibreQuake has 18";
}

}  // namespace
}  // namespace temblor::formats
