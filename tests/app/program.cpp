#include "app/program.h"

#include <fmt/format.h>
#include <spng.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <set>

#include "base/check.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

// Quotes a word for the shell.
std::string quoted(const std::string& word) {
  std::string text(1, '\'');
  for (const char c : word) {
    if (c == '\'') text.append("'\\'");
    text.push_back(c);
  }
  text.push_back('\'');
  return text;
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  return std::string(base::as_text(read_file(path)));
}

namespace {

// `before`: words of the shell before the program's.
ProgramRun run(const std::filesystem::path& program, const std::filesystem::path& folder,
               const std::vector<std::string>& words, const std::string& before = "") {
  const TemporaryFolder outputs;
  const std::filesystem::path out = outputs.path() / "out", err = outputs.path() / "err";
  std::string command =
      fmt::format("cd {} && {}{}", quoted(folder.string()), before, quoted(program.string()));
  for (const std::string& word : words) command.append(fmt::format(" {}", quoted(word)));
  command.append(fmt::format(" >{} 2>{} </dev/null", quoted(out.string()), quoted(err.string())));
  const int status = std::system(command.c_str());
  ProgramRun run;
  // A shell reports a signal as an exit status above 128.
  run.exit_status = WIFEXITED(status) && WEXITSTATUS(status) < 128 ? WEXITSTATUS(status) : -1;
  run.out = read_text(out);
  run.err = read_text(err);
  return run;
}

}  // namespace

ProgramRun run_program(const std::filesystem::path& folder, const std::vector<std::string>& words) {
  return run(TEMBLOR_PROGRAM, folder, words);
}

ProgramRun run_program_alone(const std::filesystem::path& folder, const std::vector<std::string>& words) {
  const TemporaryFolder elsewhere;
  const std::filesystem::path program = elsewhere.path() / "temblor";
  std::filesystem::copy_file(TEMBLOR_PROGRAM, program);
  return run(program, folder, words,
             fmt::format("env -u TEMBLOR_DATA -u XDG_CONFIG_HOME -u XDG_DATA_HOME HOME={} ",
                         quoted(elsewhere.path().string())));
}

bool is_one_error_line(std::string_view text) {
  return text.starts_with("temblor: ") && std::count(text.begin(), text.end(), '\n') == 1 &&
         text.ends_with('\n');
}

Png read_png(const std::filesystem::path& path) {
  const base::ByteVector bytes = read_file(path);
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> context(spng_ctx_new(0), spng_ctx_free);
  CHECK(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()) == 0);
  spng_ihdr header{};
  CHECK(spng_get_ihdr(context.get(), &header) == 0, "{} is no PNG", path.string());
  std::size_t size = 0;
  CHECK(spng_decoded_image_size(context.get(), SPNG_FMT_RGB8, &size) == 0);
  Png png{header.width, header.height, header.color_type == SPNG_COLOR_TYPE_INDEXED,
          std::vector<std::uint8_t>(size)};
  CHECK(spng_decode_image(context.get(), png.rgb.data(), size, SPNG_FMT_RGB8, 0) == 0);
  return png;
}

std::size_t count_colors(const Png& png) {
  std::set<std::array<std::uint8_t, 3>> colors;
  for (std::size_t i = 0; i < png.rgb.size(); i += 3)
    colors.insert({png.rgb[i], png.rgb[i + 1], png.rgb[i + 2]});
  return colors.size();
}

}  // namespace temblor::test
