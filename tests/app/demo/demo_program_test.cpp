// `render --demo`, `bench --demo`, and `inspect` of demos.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

// Returns the offset of the first message of the first packet after `offset`. A demo is a line of text, then
// packets; each packet starts with its length and three angles.
std::size_t first_message_after(const std::string& demo, std::size_t offset) {
  std::size_t packet = demo.find('\n') + 1;
  while (packet <= offset) {
    std::int32_t length = 0;
    std::memcpy(&length, demo.data() + packet, sizeof length);
    packet += 16 + static_cast<std::size_t>(length);
  }
  return packet + 16;
}

class DemoProgram : public ::testing::Test {
 protected:
  void SetUp() override {
    DATA_FOLDER_OR_SKIP(data);
    data_ = data;
  }
  ProgramRun run(std::vector<std::string> words) const {
    words.insert(words.begin(), {"--basedir", data_.string()});
    return run_program(folder_.path(), words);
  }
  // The first `bytes` bytes of a stock demo; all of them for 0.
  std::string stock_demo(const std::string& name, std::size_t bytes = 0) const {
    const std::string whole = read_text(data_ / "id1" / (name + ".dem"));
    return bytes == 0 ? whole : whole.substr(0, bytes);
  }

  std::filesystem::path data_;
  TemporaryFolder folder_;
};

TEST_F(DemoProgram, RendersTheRequestedFrames) {
  const ProgramRun ran =
      run({"render", "--demo", "demo1_lite", "--frames", "30:33", "--size", "160x100", "-o", "x-%03d.png"});
  ASSERT_EQ(ran.exit_status, 0) << ran.err;
  for (const char* name : {"x-030.png", "x-031.png", "x-032.png"}) {
    const Png png = read_png(folder_.path() / name);
    EXPECT_EQ(png.width, 160u);
    EXPECT_GT(count_colors(png), 50u) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "x-033.png"));
}

TEST_F(DemoProgram, FramesDoNotDependOnTheStartOfTheFilm) {
  const std::vector<std::string> common = {"render", "--demo", "demo1_lite", "--size", "160x100", "-o"};
  const auto film = [&](const std::string& frames, const std::string& name) {
    std::vector<std::string> words = common;
    words.insert(words.end(), {name, "--frames", frames});
    ASSERT_EQ(run(words).exit_status, 0);
  };
  film("58:61", "a-%d.png");
  film("60:61", "b-%d.png");
  EXPECT_EQ(read_text(folder_.path() / "a-60.png"), read_text(folder_.path() / "b-60.png"));
}

TEST_F(DemoProgram, TruncatedDemoOnDiskGivesAShorterFilm) {
  folder_.write("cut.dem", stock_demo("demo1_lite", 60000));
  const ProgramRun ran = run({"render", "--demo", "cut.dem", "--size", "64x48", "--fps", "5", "-o", "x.y4m"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("truncated"));
  const std::size_t size = std::filesystem::file_size(folder_.path() / "x.y4m");
  const std::size_t header = std::string("YUV4MPEG2 W64 H48 F5:1 Ip A1:1 C444\n").size(),
                    frame = 6 + 64 * 48 * 3;
  EXPECT_GT(size, header + 2 * frame);
  EXPECT_EQ((size - header) % frame, 0u);
}

TEST_F(DemoProgram, DamageIsAnErrorAndKeepsTheFramesBeforeIt) {
  std::string bytes = stock_demo("demo1_lite");
  bytes.replace(first_message_after(bytes, 100000), 3, "\x05\xff\xff");  // the view of entity 65535
  folder_.write("bad.dem", bytes);
  const ProgramRun ran = run({"render", "--demo", "bad.dem", "--size", "64x48", "--fps", "5", "-o", "x.y4m"});
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_THAT(ran.err, HasSubstr("bad.dem: offset "));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "x.y4m"));
}

TEST_F(DemoProgram, UnknownMessagesAreNotedAndSkipped) {
  std::string bytes = stock_demo("demo1_lite");
  bytes[first_message_after(bytes, 100000)] = '\x7e';  // no message has that number
  folder_.write("odd.dem", bytes);
  const ProgramRun ran = run({"render", "--demo", "odd.dem", "--size", "64x48", "--fps", "5", "-o", "x.y4m"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("unknown message"));
}

TEST_F(DemoProgram, UnknownDemoListsSimilarNames) {
  const ProgramRun ran = run({"render", "--demo", "demo9", "-o", "x.y4m"});
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(ran.err)) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("demo9.dem"));
  EXPECT_THAT(ran.err, HasSubstr("demo1_lite"));
}

TEST_F(DemoProgram, NamesAMissingLevel) {
  std::string bytes = stock_demo("demo1_lite");
  const std::size_t name = bytes.find("maps/");
  ASSERT_NE(name, std::string::npos);
  bytes.replace(name, 7, "maps/zz");
  folder_.write("lost.dem", bytes);
  const ProgramRun ran = run({"render", "--demo", "lost.dem", "-o", "x.y4m"});
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(ran.err)) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("maps/zz"));
}

TEST_F(DemoProgram, FramesPastTheEndAreAUsageError) {
  const ProgramRun ran = run({"render", "--demo", "demo1_lite", "--frames", "900000:900001", "-o", "x.png"});
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_THAT(ran.err, HasSubstr("has frames 0 to"));
}

TEST_F(DemoProgram, BenchDrawsEveryPacket) {
  const ProgramRun ran = run({"bench", "--demo", "demo3_lite", "--size", "160x100", "--threads", "1",
                              "--json", "--runs", std::to_string(effort(2, 1))});
  ASSERT_EQ(ran.exit_status, 0) << ran.err;
  const nlohmann::json result = nlohmann::json::parse(ran.out);
  EXPECT_EQ(result.at("demo"), "demo3_lite");
  EXPECT_GT(result.at("frames"), 100);
  EXPECT_GT(result.at("fps"), 0);
  EXPECT_LT(result.at("slowest_frame"), result.at("frames"));
  for (const char* key : {"frame_ms", "render_ms"}) {
    EXPECT_GT(result.at(key).at("p50"), 0);
    EXPECT_GE(result.at(key).at("p99"), result.at(key).at("p50"));
  }
  EXPECT_GT(result.at("stages").at("models"), 0);
  EXPECT_GT(result.at("stages").at("client"), 0);
  EXPECT_GT(result.at("stages").at("overlay"), 0);
  EXPECT_LT(result.at("allocating_frames"), result.at("frames").get<int>() / 20);
}

}  // namespace
}  // namespace temblor::test
