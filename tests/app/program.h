// Runs the built program: words in, exit status and texts out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace temblor::test {

struct ProgramRun {
  int exit_status = 0;  // -1: ended by a signal
  std::string out, err;
};

// Runs it in `folder`. The words are passed unchanged; the shell does not interpret them.
ProgramRun run_program(const std::filesystem::path& folder, const std::vector<std::string>& words);
// The same with a copy of the program that is not beside the shipped game, by a user without game data.
ProgramRun run_program_alone(const std::filesystem::path& folder, const std::vector<std::string>& words);

// Returns a whole file. CHECKs that it exists.
std::string read_text(const std::filesystem::path& path);

// Returns whether the text is one line that starts with "temblor: ".
bool is_one_error_line(std::string_view text);

// A PNG decoded by libspng, not by our own reader.
struct Png {
  std::uint32_t width = 0, height = 0;
  bool indexed = false;           // it has a palette
  std::vector<std::uint8_t> rgb;  // 3 x width x height
  bool operator==(const Png&) const = default;
};
// CHECKs that the file is a PNG.
Png read_png(const std::filesystem::path& path);

// Returns how many different colors a picture has.
std::size_t count_colors(const Png& png);

}  // namespace temblor::test
