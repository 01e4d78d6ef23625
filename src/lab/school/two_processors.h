// Game and drawing on two processors: while one draws a frame, the other computes the next state of the game.
#pragma once

#include <vector>

#include "lab/school/picture.h"

namespace temblor::lab::school {

// A ball that bounces in a box from 0 to 1.
struct Ball {
  float x, y, speed_x, speed_y;
};
using GameState = std::vector<Ball>;

GameState begin_game();
// One frame of the game, in many small steps.
void advance_game(GameState& io_state);
Picture draw_game(const GameState& state, int width, int height);

// When a processor worked on something, in milliseconds since the first frame began.
struct WorkTime {
  bool is_drawing;
  double begin_ms, end_ms;
};
struct FrameRun {
  std::vector<WorkTime> times;
  Picture last_picture;
};
FrameRun run_in_turns(int frames, int width, int height);
// The same frames; a second thread draws.
FrameRun run_overlapped(int frames, int width, int height);

}  // namespace temblor::lab::school
