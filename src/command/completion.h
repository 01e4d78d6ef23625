// What could stand at the end of a line that is being typed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace temblor::command {

enum class CandidateKind : std::uint8_t { kCommand, kAlias, kVariable, kArgument };

struct Candidate {
  std::string name;  // as it would be typed
  CandidateKind kind = CandidateKind::kArgument;
  std::string value;  // what a variable is set to, what an alias stands for; else empty
  std::string help;   // one sentence, or empty
};

struct Completion {
  std::size_t begin = 0;              // of the word in the line that a candidate would take the place of
  std::vector<Candidate> candidates;  // those that begin as the word does, sorted by name
  std::string hint;  // one line on the command or variable that the word is for; may be empty
};

}  // namespace temblor::command
