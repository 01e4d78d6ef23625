// Option types that several commands share, and their parsers. command_line.h adds them to a command.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "command/variables.h"
#include "math/vec.h"
#include "render/frame_buffer.h"

namespace temblor::app {

// Location of the game data: --basedir and --game.
struct GameFolders {
  // The directory that contains id1; empty: the current directory or the shipped game (find_base_folder()).
  std::string base_folder;
  // Game directories in it, in order of increasing priority; id1 is implied.
  std::vector<std::string> games;
};

// Options that every command accepts.
struct CommonOptions {
  GameFolders folders;
  // --set: NAME=VALUE, in order.
  std::vector<std::string> assignments;
  // --show: a value for r_show; empty: leave r_show alone.
  std::string show;
};

// In pixels, 1 to 8192 each.
struct FrameSize {
  int width = 0, height = 0;
};

// On the CPU, or through OpenGL without a window.
enum class RendererKind { kCpu, kGl };

// Size and format of rendered frames: --size, --color, --fov, --threads, --renderer.
struct FrameOptions {
  FrameSize size;
  render::PixelFormat format = render::PixelFormat::kRgb;
  // Horizontal field of view of a 4:3 picture.
  float fov_deg = 90;
  // 0: one per core; nothing: leave r_threads alone.
  std::optional<int> threads{};
  RendererKind renderer = RendererKind::kCpu;
};

// A half-open range of frames, counted from 0: first, ..., end - 1.
struct FrameRange {
  std::size_t first = 0, end = 0;
};

// Parses "N" (the first N frames), "A:B", "A:" (to the last), or ":B". The range has at least one frame and
// ends at kMaxFrames or before. All parsers here return kUsage with the text quoted for anything else.
constexpr std::size_t kMaxFrames = 10'000'000;
base::Result<FrameRange> parse_frame_range(std::string_view text);
// Parses "640x480".
base::Result<FrameSize> parse_size(std::string_view text);
// Parses three finite numbers, "1,-2.5,3".
base::Result<math::Vec3> parse_vec3(std::string_view text);
// Parses "indexed" or "rgb".
base::Result<render::PixelFormat> parse_color(std::string_view text);
// Parses "cpu" or "gl".
base::Result<RendererKind> parse_renderer(std::string_view text);
const char* pixel_format_name(render::PixelFormat format);

// Applies --set, --show, and --threads to the console variables. Errors are kUsage.
base::Status apply_options(const CommonOptions& options, std::optional<int> threads,
                           command::Variables& io_variables);

}  // namespace temblor::app
