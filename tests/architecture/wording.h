// The rule about words: retired terms and spellings do not come back. See retired_words.txt.
#pragma once

#include <functional>
#include <regex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/result.h"

namespace temblor::test {

struct RetiredWord {
  enum class Kind {
    kPart,     // a part of a name or a word of prose: "colour" also rejects `ColourTable` and `fog_colours`
    kName,     // a whole identifier
    kPhrase,   // words of prose, whatever their case, also across one line break of a comment
    kPattern,  // a regular expression (ECMAScript) that is searched in each name, with the "(" of a call
  };
  Kind kind;
  std::string text;         // lower case except for kName and kPattern
  std::string replacement;  // shown to the person who uses the retired word
};

// Reads lines "part|name|phrase|pattern: TEXT -> REPLACEMENT"; '#' starts a comment line. An error names the
// line.
base::Result<std::vector<RetiredWord>> parse_retired_words(std::string_view text);

// A line that ends in this may use old spellings: names that files of players still contain.
constexpr std::string_view kOldSpellingMark = "// old spelling";

// Searches texts for retired words. It remembers its verdict on each name: files share most of their names,
// and regular expressions are slow.
class RetiredWordFinder {
 public:
  explicit RetiredWordFinder(std::vector<RetiredWord> words);
  RetiredWordFinder(const RetiredWordFinder&) = delete;  // verdicts_ points into words_
  RetiredWordFinder& operator=(const RetiredWordFinder&) = delete;

  // Returns "PATH:LINE: 'WORD' is retired; use 'REPLACEMENT'" for each use; of patterns, for the first use of
  // a name.
  std::vector<std::string> find(const std::string& path, std::string_view text);

 private:
  struct Verdict {
    std::vector<const RetiredWord*> names_and_parts, patterns;
  };
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };

  // `use` is a name, with the "(" of a call.
  const Verdict& judge(std::string_view use);

  const std::vector<RetiredWord> words_;
  std::vector<std::pair<std::regex, const RetiredWord*>> patterns_;
  std::unordered_map<std::string, Verdict, Hash, std::equal_to<>> verdicts_;
};

// Returns "PATH:LINE: ..." for each sentence of a `//` comment that starts with What, Who, Whose, Of, or As:
// its subject is a clause, or missing.
std::vector<std::string> find_sentences_without_subject(const std::string& path, std::string_view text);

}  // namespace temblor::test
