#include "client/console/format_candidates.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "client/console/utf8.h"

namespace temblor::client {

namespace {

constexpr std::size_t kMaxListed = 100;

std::string describe(const command::Candidate& candidate) {
  std::string line = "  " + to_bronze_glyphs(candidate.name);
  if (candidate.kind == command::CandidateKind::kVariable)
    line += fmt::format(" \"{}\"", to_glyphs(candidate.value));
  if (candidate.kind == command::CandidateKind::kAlias)
    line += fmt::format("  alias for {}", to_glyphs(candidate.value));
  if (!candidate.help.empty()) line += fmt::format("  {}", to_glyphs(candidate.help));
  return line + '\n';
}

}  // namespace

// Shortens the first name until it is a prefix of every other one.
std::string find_common_prefix(std::span<const command::Candidate> candidates) {
  if (candidates.empty()) return "";
  std::string common = candidates[0].name;
  for (const command::Candidate& candidate : candidates) {
    const auto same = [](char a, char b) { return base::to_lower(a) == base::to_lower(b); };
    const auto differ =
        std::mismatch(common.begin(), common.end(), candidate.name.begin(), candidate.name.end(), same);
    common.erase(differ.first, common.end());
  }
  return common;
}

std::string format_candidates(std::span<const command::Candidate> candidates) {
  std::string text;
  for (const command::Candidate& candidate : candidates.first(std::min(candidates.size(), kMaxListed)))
    text += describe(candidate);
  if (candidates.size() > kMaxListed)
    text += fmt::format("  ... and {} more\n", candidates.size() - kMaxListed);
  return text;
}

}  // namespace temblor::client
