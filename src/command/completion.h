// The completion of a console line that is being typed: candidates and a hint, for the console to display.
// Console::complete_line() computes it; nothing is executed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace temblor::command {

enum class CandidateKind : std::uint8_t { kCommand, kAlias, kVariable, kArgument };

struct Candidate {
  std::string name;  // as the player would type it
  CandidateKind kind = CandidateKind::kArgument;
  std::string value;  // value of a variable, text of an alias; otherwise empty
  std::string help;   // one sentence, or empty
};

struct Completion {
  // Where the word starts in the line that a candidate replaces: characters from `begin` to the end of the
  // line.
  std::size_t begin = 0;
  // All candidates that begin with that word, sorted by name, ignoring case.
  std::vector<Candidate> candidates;
  // One line of help about the command or variable of the line; may be empty.
  std::string hint;
};

}  // namespace temblor::command
