// The rule about words: retired terms and spellings do not come back. See retired_words.txt.
#pragma once

#include <string>
#include <string_view>
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

// Returns "PATH:LINE: 'WORD' is retired; use 'REPLACEMENT'" for each use; of patterns, for the first use of a
// name.
std::vector<std::string> find_retired_words(const std::string& path, std::string_view text,
                                            const std::vector<RetiredWord>& words);

// Returns "PATH:LINE: ..." for each sentence of a `//` comment that starts with What, Who, Whose, Of, or As:
// its subject is a clause, or missing.
std::vector<std::string> find_sentences_without_subject(const std::string& path, std::string_view text);

}  // namespace temblor::test
