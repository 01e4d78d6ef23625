// Demos: playing, benchmarks, attract mode (demos behind the menu), and recording.
//
// A demo is a file of the packets that a client received. It plays through the same presentation as a game;
// at most one of the two runs at a time:
//
//   play_demo, time_demo, attract -> DemoPlayback::session -> advance_demo() per frame -> next demo, menu
//
//   record_demo -> our own server or the connection records -> stop_recording, disconnect -> NAME.dem
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::host {

struct GameData;
struct Host;

// Plays a demo, "NAME" or "NAME.dem". The running game ends, unless there is no such file.
base::Status play_demo(Host& io_host, std::string_view name);
// The same with a demo from memory. `file`: its name, for messages.
base::Status play_demo_bytes(Host& io_host, base::ByteVector bytes, std::string file);
// Plays a demo one packet per frame, as fast as possible, and prints the frame rate.
base::Status time_demo(Host& io_host, std::string_view name);
// Stops the demo, a benchmark and the attract mode. Does nothing if no demo is playing.
void stop_demo(Host& io_host);
// Moves the current demo to a time on its own clock (DemoSession::begin_s() to end_s(), clamped). Fails if no
// demo is playing.
base::Status seek_demo(Host& io_host, double time_s);
// Advances the demo by this frame's time, or by one packet if it is timed. At the end it shows the next demo
// of the attract loop or opens the menu.
base::Status advance_demo(Host& io_host);

// Plays demos behind the menu in an endless loop until something else starts. Any key opens the menu. Leaves
// out demos that do not exist: many scripts name demo1 to demo3 from habit.
void attract(Host& io_host, std::vector<std::string> demos);

// Starts to record the game as NAME.dem. In a single-player game the demo starts at once. In other games it
// starts with the next level, because the server does not send the start of the current one again. Fails if
// there is no game, or if a demo is being recorded already.
base::Status record_demo(Host& io_host, std::string_view name);
// Stops recording and writes the demo. Fails if no demo is being recorded.
base::Status stop_recording(Host& io_host);
// Like stop_recording(), but does nothing if no demo is being recorded. Call it whenever a game ends.
base::Status finish_recording(Host& io_host);
// A recording has been started, but no level has begun since. It goes on in the next game.
bool waits_to_record(const Host& host);

}  // namespace temblor::host
