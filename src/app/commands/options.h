// What the commands' options have in common: their types, and reading them from text. They become options of
// the command line in command_line.h.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "command/variables.h"
#include "math/vec.h"
#include "render/frame.h"

namespace temblor::app {

// Where game data is: --basedir and --game.
struct GameFolders {
  std::string base_folder;         // empty: the current folder, where it holds id1
  std::vector<std::string> games;  // folders in it besides id1, the last one wins
};

// The options in front of every command.
struct CommonOptions {
  GameFolders folders;
  std::vector<std::string> assignments;  // NAME=VALUE
  std::string show;                      // a value of r_show; empty: as r_show says
};

struct FrameSize {
  int width = 0, height = 0;  // pixels, 1 to 8192
};

// How big and in what format frames are drawn: --size, --color, --fov, --threads.
struct FrameOptions {
  FrameSize size;
  render::PixelFormat format = render::PixelFormat::kRgb;
  float fov_deg = 90;
  std::optional<int> threads{};  // nothing: as r_threads says
};

// Frames of a sequence, counted from 0: first up to but not including end.
struct FrameRange {
  std::size_t first = 0, end = 0;
};

// "N": the first N frames; "A:B", "A:" (to the last), ":B". At least one frame, and at most kMaxFrames.
constexpr std::size_t kMaxFrames = 10'000'000;
base::Result<FrameRange> parse_frame_range(std::string_view text);
// "640x480".
base::Result<FrameSize> parse_size(std::string_view text);
// "1,-2.5,3": finite numbers.
base::Result<math::Vec3> parse_vec3(std::string_view text);
// "indexed" or "rgb".
base::Result<render::PixelFormat> parse_color(std::string_view text);
const char* name_of(render::PixelFormat format);

// Sets the variables that --set, --show and --threads name; errors are kUsage.
base::Status apply_options(const CommonOptions& options, std::optional<int> threads,
                           command::Variables& io_variables);

}  // namespace temblor::app
