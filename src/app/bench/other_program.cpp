#include "app/bench/other_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>
#include <vector>

#include "app/files/child_process.h"
#include "base/text.h"

namespace temblor::app {
namespace {

using base::ErrorCode;
using namespace std::string_view_literals;

constexpr std::size_t kMaxOutputBytes = std::size_t{16} << 20;

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr bool is_word_character(char c) {
  return is_digit(c) || c == '_' || (base::to_lower(c) >= 'a' && base::to_lower(c) <= 'z');
}

// Removes signs and symbols before a word, such as "~" in "~72.5", except the sign and point of a number.
std::string_view remove_leading_symbols(std::string_view word) {
  const auto first = static_cast<std::size_t>(std::ranges::find_if(word, is_word_character) - word.begin());
  std::size_t begin = first;
  if (first < word.size() && is_digit(word[first])) {
    if (begin > 0 && word[begin - 1] == '.') --begin;
    if (begin > 0 && word[begin - 1] == '-') --begin;
  }
  return word.substr(begin);
}

// Reads the number that a word begins with. Nothing if it has none, such as "fps" or "demo1".
std::optional<base::Result<double>> read_number(std::string_view word) {
  const std::size_t digit = word.find_first_not_of("-.");
  if (digit == std::string_view::npos || !is_digit(word[digit])) return std::nullopt;
  double number = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, number);
  // Digits after the number mean that it is a date, a size, or a number with separators of another country.
  if (failure != std::errc{} || !std::isfinite(number) || std::any_of(stop, end, is_digit))
    return base::malformed("prints \"{}\" as its last number, not a plain number such as 72.5",
                           base::quotable(word));
  return number;
}

// Describes how the command ended, after `problem`.
base::Error describe_failure(const OtherProgram& program, const ChildProcess& process, int exit_status,
                             std::string_view problem) {
  constexpr std::size_t kMaxChars = 200;
  const std::vector<std::string> lines = process.messages();
  const std::string last_line = lines.empty()
                                    ? std::string("no output")
                                    : fmt::format("last line: {}", base::quotable(lines.back(), kMaxChars));
  return base::error(ErrorCode::kIo, "the command `{}` {} (exit status {}; {})",
                     base::quotable(program.command, kMaxChars), problem, exit_status, last_line);
}

base::Error describe_interruption() {
  return base::error(ErrorCode::kIo, "interrupted");
}

// Waits in steps, which leave the processor to the command.
base::Status wait_until_end(ChildProcess& io_process, const OtherProgram& program,
                            const Interrupt& interrupt) {
  while (true) {
    const bool has_ended = io_process.has_ended();
    if (interrupt.was_requested()) return describe_interruption();
    if (io_process.output_size() > kMaxOutputBytes)
      return base::error(ErrorCode::kTooLarge, "the command `{}` prints more than {} MiB",
                         base::quotable(program.command), kMaxOutputBytes >> 20);
    if (has_ended) return base::Ok{};
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

base::Result<double> run_command(const OtherProgram& program, const Interrupt& interrupt) {
  // "--" lets a command begin with a minus sign. The word after the command is its $0.
  const std::vector<std::string> words = {"/bin/sh",
                                          "-c",
                                          "--",
                                          program.command,
                                          "sh",
                                          std::to_string(program.size.width),
                                          std::to_string(program.size.height),
                                          program.name};
  TRY(ChildProcess process, ChildProcess::start(words, ChildSession::kSeparate));
  process.close_input();
  TRY_STATUS(wait_until_end(process, program, interrupt));
  TRY(const int exit_status, process.wait());
  if (exit_status != 0) return describe_failure(program, process, exit_status, "failed");
  const base::Result<double> number = find_last_number(process.output(kMaxOutputBytes));
  if (!number.ok()) return describe_failure(program, process, exit_status, number.error().what);
  if (*number <= 0)
    return describe_failure(program, process, exit_status,
                            fmt::format("prints {} frames per second, which must be more than 0", *number));
  return *number;
}

}  // namespace

// The words are visited from the last one.
base::Result<double> find_last_number(std::string_view output) {
  constexpr std::string_view kSeparators = " \t\r\n\v\f\0()[]{}<>=:;|/\"'`"sv;
  while (true) {
    const std::size_t last = output.find_last_not_of(kSeparators);
    if (last == std::string_view::npos) return base::malformed("prints no number");
    output = output.substr(0, last + 1);
    // Without a separator, npos + 1 is 0.
    const std::size_t begin = output.find_last_of(kSeparators) + 1;
    if (const auto number = read_number(remove_leading_symbols(output.substr(begin)))) return *number;
    output = output.substr(0, begin);
  }
}

// A signal is deferred until the command and everything that it started have ended.
base::Result<double> measure_other_program(const OtherProgram& program, Interrupt& interrupt) {
  interrupt.defer();
  base::Result<double> fps = run_command(program, interrupt);
  interrupt.stop_deferring();
  if (interrupt.was_requested()) return describe_interruption();
  return fps;
}

}  // namespace temblor::app
