// Runs the built program as a person does: words in, exit status and text out.
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

// Runs it in `folder`. The words reach it as they are; no shell rule applies to them.
ProgramRun run_program(const std::filesystem::path& folder, const std::vector<std::string>& words);
// The same, of a copy that lies where the shipped game does not.
ProgramRun run_program_alone(const std::filesystem::path& folder, const std::vector<std::string>& words);

// A whole file, as it is. CHECKs that it is there.
std::string read_text(const std::filesystem::path& path);

// Whether the text is one line that starts with "temblor: ".
bool is_one_error_line(std::string_view text);

// A PNG decoded by libspng itself.
struct Png {
  std::uint32_t width = 0, height = 0;
  bool indexed = false;           // it has a palette
  std::vector<std::uint8_t> rgb;  // 3 x width x height
  bool operator==(const Png&) const = default;
};
// CHECKs that the file is a PNG.
Png read_png(const std::filesystem::path& path);

// How many different colors a picture has.
std::size_t count_colors(const Png& png);

}  // namespace temblor::test
