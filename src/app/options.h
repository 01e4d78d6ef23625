// What the commands' options have in common: their types, and reading them from text.
#pragma once

#include <CLI/App.hpp>
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

void add_common_options(CLI::App& program, CommonOptions& io_options);
// The initial values of `io_options` are the defaults.
void add_frame_options(CLI::App& command, FrameOptions& io_options);

// Sets the variables that --set, --show and --threads name; errors are kUsage.
base::Status apply_options(const CommonOptions& options, std::optional<int> threads,
                           command::Variables& io_variables);

// Adds an option that `parse` reads; its error becomes CLI11's. `value` may also be a std::optional<T>.
template <typename T, typename Value>
CLI::Option* add_parsed_option(CLI::App& command, const std::string& name, Value& value,
                               base::Result<T> (*parse)(std::string_view), const std::string& help) {
  return command.add_option_function<std::string>(
      name,
      [name, &value, parse](const std::string& text) {
        const base::Result<T> parsed = parse(text);
        if (!parsed.ok()) throw CLI::ValidationError(name, parsed.error().what);
        value = parsed.value();
      },
      help);
}

}  // namespace temblor::app
