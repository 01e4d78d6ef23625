// The film of the generated demo, as `temblor render --demo` draws it (support/generated_demo.h lists what is
// visible at which time).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "app/program.h"
#include "artgen/palette.h"
#include "assets/pictures.h"
#include "base/check.h"
#include "support/generated_demo.h"

namespace temblor::test {
namespace {

using namespace made_recording;

constexpr int kFramesPerSecond = 4, kWidth = 320, kHeight = 200;

struct Part {
  int x, y, width, height;
};
constexpr Part kView = {0, 0, kWidth, kHeight - 48};  // above the status bar

// Without the film no test can run: a failed assertion here would count as skipped tests.
class MadeFilm : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    film_ = std::make_unique<Film>();
    film_->game.folder().write("id1/made.dem", make_recording({}).bytes);
    const ProgramRun ran =
        run_program(film_->frames.path(), {"--basedir", film_->game.path().string(), "render", "--demo",
                                           "made", "--fps", std::to_string(kFramesPerSecond), "--size",
                                           fmt::format("{}x{}", kWidth, kHeight), "-o", "x-%03d.png"});
    CHECK(ran.exit_status == 0 && ran.err.empty(), "{}", ran.err);
    std::vector<std::string> notes;
    film_->pictures = assets::Pictures::load(vfs::FileSystem::open(film_->game.path()).value(), notes);
  }
  static void TearDownTestSuite() { film_.reset(); }

  static Png frame_at(double second) {
    const int number = static_cast<int>(second * kFramesPerSecond);
    return read_png(film_->frames.path() / fmt::format("x-{:03}.png", number));
  }
  static const assets::Pictures& pictures() { return film_->pictures; }

 private:
  struct Film {
    MadeGame game;
    TemporaryFolder frames;
    assets::Pictures pictures;
  };
  static std::unique_ptr<Film> film_;
};
std::unique_ptr<MadeFilm::Film> MadeFilm::film_;

// Mean of all channels, 0 to 255.
double brightness(const Png& frame, const Part& part) {
  double sum = 0;
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = 3 * part.x; x < 3 * (part.x + part.width); ++x)
      sum += frame.rgb[static_cast<std::size_t>(y * 3 * kWidth + x)];
  return sum / (3.0 * part.width * part.height);
}

// Returns whether the frame shows every opaque pixel of that part of a picture, with its corner at (x, y).
bool shows(const Png& frame, const formats::Picture& picture, const Part& part, int x, int y) {
  const formats::Palette palette = artgen::make_palette();
  for (int row = 0; row < part.height; ++row)
    for (int column = 0; column < part.width; ++column) {
      const std::uint8_t index = picture.pixels[static_cast<std::size_t>(part.y + row) * picture.width +
                                                static_cast<std::size_t>(part.x + column)];
      if (index == artgen::kTransparent) continue;
      const std::uint8_t* rgb = &frame.rgb[static_cast<std::size_t>(3 * ((y + row) * kWidth + x + column))];
      if (formats::Rgb{rgb[0], rgb[1], rgb[2]} != palette[index]) return false;
    }
  return true;
}

// Returns whether the frame shows a number of up to three digits, right-aligned in 72 pixels from `x` on, at
// the bottom of the frame.
bool shows_number(const Png& frame, const assets::Pictures& pictures, const std::string& digits, int x) {
  constexpr int kDigit = 24;
  int at = x + kDigit * (3 - static_cast<int>(digits.size()));
  for (const char digit : digits) {
    const formats::Picture& picture = *pictures.find(std::string("num_") + digit);
    if (!shows(frame, picture, {0, 0, kDigit, kDigit}, at, kHeight - kDigit)) return false;
    at += kDigit;
  }
  return true;
}

bool shows_text(const Png& frame, const assets::Pictures& pictures, const std::string& text, int x, int y) {
  constexpr int kCell = 8;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int code = static_cast<unsigned char>(text[i]);
    if (!shows(frame, pictures.characters(), {code % 16 * kCell, code / 16 * kCell, kCell, kCell},
               x + kCell * static_cast<int>(i), y))
      return false;
  }
  return true;
}

// Positions of the original on a screen of 320 x 200: armor 24 from the left, health 136, ammunition 248;
// texts are centered, a third of the way down.
constexpr int kArmorX = 24, kHealthX = 136, kAmmoX = 248;

TEST_F(MadeFilm, ShowsTheNumbersOfTheStatusBar) {
  const Png healthy = frame_at(0.5), shot = frame_at(2), hurt = frame_at(13.75), armored = frame_at(14.25);
  EXPECT_TRUE(shows_number(healthy, pictures(), "100", kHealthX));
  EXPECT_TRUE(shows_number(healthy, pictures(), "25", kAmmoX));
  EXPECT_TRUE(shows_number(shot, pictures(), "24", kAmmoX));
  EXPECT_FALSE(shows_number(shot, pictures(), "25", kAmmoX));
  EXPECT_TRUE(shows_number(hurt, pictures(), "42", kHealthX));
  EXPECT_FALSE(shows_number(hurt, pictures(), "150", kArmorX));
  EXPECT_TRUE(shows_number(armored, pictures(), "150", kArmorX));
}

TEST_F(MadeFilm, ShowsCenterTextForTwoSeconds) {
  constexpr int kX = (kWidth - 12 * 8) / 2, kY = kHeight * 35 / 100;
  EXPECT_TRUE(shows_text(frame_at(0), pictures(), "Made in code", kX, kY));
  EXPECT_TRUE(shows_text(frame_at(1.75), pictures(), "Made in code", kX, kY));
  EXPECT_FALSE(shows_text(frame_at(2.25), pictures(), "Made in code", kX, kY));
}

TEST_F(MadeFilm, IsBrightNearExplosionsAndLights) {
  const double calm = brightness(frame_at(4.75), kView);
  EXPECT_GT(brightness(frame_at(3), kView), 1.1 * calm) << "a rocket";
  EXPECT_GT(brightness(frame_at(3), {160, 70, 60, 60}), 1.3 * brightness(frame_at(4), {160, 70, 60, 60}));
  EXPECT_GT(brightness(frame_at(6), kView), 1.1 * calm) << "an explosion in blue";
  EXPECT_GT(brightness(frame_at(10.75), kView), 1.2 * calm) << "a bright light";
  EXPECT_LT(brightness(frame_at(14.75), kView), 0.2 * calm) << "the light is out";
}

TEST_F(MadeFilm, IsRedInPainAndBlueWithQuadDamage) {
  const auto channel_share = [](const Png& frame, std::size_t channel) {
    double one = 0, all = 0;
    for (std::size_t i = 0; i < 3u * kWidth * 150; ++i) {
      all += frame.rgb[i];
      if (i % 3 == channel) one += frame.rgb[i];
    }
    return one / all;
  };
  const Png calm = frame_at(13.25);
  EXPECT_GT(channel_share(frame_at(13.5), 0), channel_share(calm, 0) + 0.1);
  EXPECT_GT(channel_share(frame_at(14.25), 2), channel_share(calm, 2) + 0.03);
}

}  // namespace
}  // namespace temblor::test
