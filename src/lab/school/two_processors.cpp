#include "lab/school/two_processors.h"

#include <chrono>
#include <future>

namespace temblor::lab::school {
namespace {

// Memory that is used for the first time is slow, so that a frame before the clock starts is fairer.
void warm_up(int width, int height) {
  GameState state = begin_game();
  advance_game(state);
  draw_game(state, width, height);
}

class Clock {
 public:
  // Calls `work`, and returns when it ran.
  template <typename Work>
  WorkTime time(bool is_drawing, Work work) const {
    const double begin_ms = now_ms();
    work();
    return {is_drawing, begin_ms, now_ms()};
  }

 private:
  double now_ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

GameState begin_game() {
  GameState state;
  for (int i = 0; i < 200; ++i) {
    const auto n = static_cast<float>(i);
    state.push_back({n / 200, n * n / 40000, 0.3f + n / 500, 0.7f - n / 400});
  }
  return state;
}

void advance_game(GameState& io_state) {
  constexpr int kSteps = 1500;
  constexpr float kStep_s = 1.0f / 60 / kSteps;
  for (int step = 0; step < kSteps; ++step)
    for (Ball& ball : io_state) {
      ball.x += ball.speed_x * kStep_s;
      ball.y += ball.speed_y * kStep_s;
      if ((ball.x < 0 && ball.speed_x < 0) || (ball.x > 1 && ball.speed_x > 0)) ball.speed_x = -ball.speed_x;
      if ((ball.y < 0 && ball.speed_y < 0) || (ball.y > 1 && ball.speed_y > 0)) ball.speed_y = -ball.speed_y;
    }
}

Picture draw_game(const GameState& state, int width, int height) {
  Picture picture(width, height);
  constexpr int kRadius = 8;
  for (const Ball& ball : state) {
    const int center_x = static_cast<int>(ball.x * static_cast<float>(width));
    const int center_y = static_cast<int>(ball.y * static_cast<float>(height));
    for (int y = -kRadius; y <= kRadius; ++y)
      for (int x = -kRadius; x <= kRadius; ++x)
        if (x * x + y * y <= kRadius * kRadius && picture.has(center_x + x, center_y + y))
          picture.color(center_x + x, center_y + y) = {0.9f, ball.x, ball.y};
  }
  return picture;
}

FrameRun run_in_turns(int frames, int width, int height) {
  FrameRun run{{}, Picture(width, height)};
  warm_up(width, height);
  const Clock clock;
  GameState state = begin_game();
  for (int frame = 0; frame < frames; ++frame) {
    run.times.push_back(clock.time(false, [&] { advance_game(state); }));
    run.times.push_back(clock.time(true, [&] { run.last_picture = draw_game(state, width, height); }));
  }
  return run;
}

// The thread that draws has its own copy of the state, so the game can go on. Each frame waits for both.
FrameRun run_overlapped(int frames, int width, int height) {
  FrameRun run{{}, Picture(width, height)};
  warm_up(width, height);
  const Clock clock;
  GameState state = begin_game();
  run.times.push_back(clock.time(false, [&] { advance_game(state); }));
  for (int frame = 0; frame < frames; ++frame) {
    const GameState shown = state;
    std::future<WorkTime> drawing = std::async(std::launch::async, [&] {
      return clock.time(true, [&] { run.last_picture = draw_game(shown, width, height); });
    });
    if (frame + 1 < frames) run.times.push_back(clock.time(false, [&] { advance_game(state); }));
    run.times.push_back(drawing.get());
  }
  return run;
}

}  // namespace temblor::lab::school
