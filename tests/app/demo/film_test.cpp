// Films against the definition of their format, and as ffmpeg reads them.
#include "app/demo/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "app/files/child_process.h"
#include "app/program.h"
#include "artgen/palette.h"
#include "support/programs/temporary_folder.h"
#include "support/random.h"

namespace temblor::app {
namespace {

// A frame in one color.
render::FrameBuffer plain_frame(FrameSize size, std::uint32_t rgb) {
  render::FrameBuffer frame(size.width, size.height, render::PixelFormat::kRgb);
  std::fill(frame.rgb().begin(), frame.rgb().end(), rgb);
  return frame;
}

bool have_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

TEST(OutputKind, FollowsTheName) {
  EXPECT_EQ(find_output_kind("a.png").value(), OutputKind::kPicture);
  EXPECT_EQ(find_output_kind("a-%05d.PNG").value(), OutputKind::kNumberedPictures);
  EXPECT_EQ(find_output_kind("a.mp4").value(), OutputKind::kMp4);
  EXPECT_EQ(find_output_kind("dir.png/a.Y4M").value(), OutputKind::kY4m);
  for (const char* wrong : {"", "a", "a.avi", "a-%s.png", "a-%d-%d.png"}) {
    ASSERT_FALSE(find_output_kind(wrong).ok()) << wrong;
    EXPECT_EQ(find_output_kind(wrong).error().code, base::ErrorCode::kUsage);
  }
}

TEST(Film, Y4mHasAHeaderAndPlanesForEachFrame) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "x.y4m").string();
  const FrameSize size{5, 3};
  Film film = Film::open(path, {size, 25}, artgen::make_palette()).value();
  ASSERT_TRUE(film.add(plain_frame(size, 0xffffffff)).ok());
  ASSERT_TRUE(film.add(plain_frame(size, 0xff000000)).ok());
  ASSERT_TRUE(film.finish().ok());
  const std::string white = std::string(15, '\xeb') + std::string(30, '\x80');  // 235, 128, 128
  const std::string black = std::string(15, '\x10') + std::string(30, '\x80');  // 16, 128, 128
  EXPECT_EQ(test::read_text(path), "YUV4MPEG2 W5 H3 F25:1 Ip A1:1 C444\nFRAME\n" + white + "FRAME\n" + black);
}

// ITU-R BT.601 in floating point.
TEST(Film, Y4mColorsFollowTheStandard) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "x.y4m").string();
  const FrameSize size{64, 16};
  render::FrameBuffer frame(size.width, size.height, render::PixelFormat::kRgb);
  test::Random random(5);
  for (std::uint32_t& pixel : frame.rgb()) pixel = 0xff000000u | static_cast<std::uint32_t>(random.bits());
  Film film = Film::open(path, {size, 25}, artgen::make_palette()).value();
  ASSERT_TRUE(film.add(frame).ok());
  ASSERT_TRUE(film.finish().ok());
  const std::string bytes = test::read_text(path);
  const std::size_t count = frame.pixel_count(), first = bytes.size() - 3 * count;
  for (std::size_t i = 0; i < count; ++i) {
    const double r = frame.rgb()[i] >> 16 & 255, g = frame.rgb()[i] >> 8 & 255, b = frame.rgb()[i] & 255;
    const double luma = (0.299 * r + 0.587 * g + 0.114 * b) / 255;
    const auto at = [&](std::size_t plane) {
      return static_cast<double>(static_cast<unsigned char>(bytes[first + plane * count + i]));
    };
    ASSERT_NEAR(at(0), 16 + 219 * luma, 0.6);
    ASSERT_NEAR(at(1), 128 + 224 * (b / 255 - luma) / 1.772, 0.6);
    ASSERT_NEAR(at(2), 128 + 224 * (r / 255 - luma) / 1.402, 0.6);
  }
}

TEST(Film, NumbersPicturesFromTheFirstNumber) {
  const test::TemporaryFolder folder;
  const FrameSize size{4, 4};
  Film film =
      Film::open((folder.path() / "x-%03d.png").string(), {size, 30, 41}, artgen::make_palette()).value();
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(film.add(plain_frame(size, 0)).ok());
  ASSERT_TRUE(film.finish().ok());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "x-041.png"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "x-042.png"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "x-043.png"));
}

// ffprobe prints a line with the size of each frame.
TEST(Film, Mp4IsReadByFfmpegWithEveryFrame) {
  if (!have_program("ffmpeg") || !have_program("ffprobe")) GTEST_SKIP() << "no ffmpeg program";
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "odd name'%.mp4";
  const FrameSize size{101, 75};  // odd sides
  Film film = Film::open(path.string(), {size, 24}, artgen::make_palette()).value();
  for (int i = 0; i < 7; ++i) ASSERT_TRUE(film.add(plain_frame(size, 0xff204060)).ok());
  ASSERT_TRUE(film.finish().ok());
  const std::filesystem::path report = folder.path() / "report";
  ChildProcess probe = ChildProcess::start({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                            "stream=width,height,nb_read_frames,r_frame_rate", "-of",
                                            "csv=p=0", "-o", report.string(), "file:" + path.string()})
                           .value();
  ASSERT_TRUE(probe.finish().ok());
  EXPECT_EQ(test::read_text(report), "102,76,24/1,7\n");
}

TEST(Film, MissingFolderIsAnError) {
  const test::TemporaryFolder folder;
  const std::string name = (folder.path() / "none" / "x.y4m").string();
  const base::Result<Film> film = Film::open(name, {{4, 4}, 30}, artgen::make_palette());
  ASSERT_FALSE(film.ok());
  EXPECT_EQ(film.error().file, name);
  if (!have_program("ffmpeg")) GTEST_SKIP() << "no ffmpeg program";
  const std::string mp4 = (folder.path() / "none" / "x.mp4").string();
  Film with_ffmpeg = Film::open(mp4, {{4, 4}, 30}, artgen::make_palette()).value();
  const base::Status finished = with_ffmpeg.finish();
  ASSERT_FALSE(finished.ok());
  EXPECT_EQ(finished.error().file, mp4);
  EXPECT_NE(finished.error().what.find("No such file"), std::string::npos) << finished.error().what;
}

TEST(ChildProcess, ReportsAMissingProgram) {
  const base::Result<ChildProcess> process = ChildProcess::start({"no-such-program-anywhere"});
  ASSERT_FALSE(process.ok());
  EXPECT_EQ(process.error().code, base::ErrorCode::kNotFound);
  EXPECT_NE(process.error().what.find("no-such-program-anywhere"), std::string::npos);
}

TEST(ChildProcess, FailureContainsTheLastMessage) {
  ChildProcess process =
      ChildProcess::start({"sh", "-c", "echo first >&2; printf 'the \\033 reason\\n' >&2; exit 3"}).value();
  const base::Status finished = process.finish();
  ASSERT_FALSE(finished.ok());
  EXPECT_EQ(finished.error().what, "sh failed: the ? reason");
}

TEST(ChildProcess, SurvivesAProgramThatEndsEarly) {
  ChildProcess process = ChildProcess::start({"sh", "-c", "echo enough >&2; exit 1"}).value();
  const std::vector<std::byte> much(std::size_t{1} << 22);
  const base::Status written = process.write(much);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().what, "sh failed: enough");
  EXPECT_TRUE(process.finish().ok()) << "the failure was already reported";
}

TEST(ChildProcess, ReceivesItsInput) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "copy";
  ChildProcess process = ChildProcess::start({"sh", "-c", "cat > \"$0\"", path.string()}).value();
  std::string text;
  for (int i = 0; i < 100000; ++i) text += std::to_string(i) + "\n";
  ASSERT_TRUE(process.write(base::as_bytes(text)).ok());
  ASSERT_TRUE(process.finish().ok());
  EXPECT_EQ(test::read_text(path), text);
}

}  // namespace
}  // namespace temblor::app
