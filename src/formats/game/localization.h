// Texts of a game in one language: the files localization/loc_LANGUAGE.txt of the 2021 release. Game code and
// levels name a text by its key, "$map_start", and the file gives the text in each language. UTF-8 text:
//
//   // a comment
//   map_start = "The Entrance"
//   qc_died = "{0} was killed by {1}\n"    places are filled with arguments, counted from 0
//   alias = "$map_start"                   a whole text may refer to another key
//
// In quotes, \n is a new line, \t a tab, \" a quote, and \\ a backslash. The last of several lines with one
// key counts. A line that cannot be read costs only itself.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace temblor::formats {

constexpr std::size_t kMaxLocalizationBytes = std::size_t{8} << 20;  // of a file
constexpr std::size_t kMaxLocalizationEntries = std::size_t{1} << 16;
// Limit for a text in the file, and for one with its places filled, which is truncated.
constexpr std::size_t kMaxLocalizedBytes = 8192;

// The texts of one language, by key without '$', in the game's character set: Latin letters without their
// accents, Russian ones in Latin letters, and '?' for everything else that is not ASCII.
class Localization {
 public:
  using Texts = std::map<std::string, std::string, std::less<>>;

  Localization() = default;
  explicit Localization(Texts texts) : texts_(std::move(texts)) {}

  // Replaces the key at the start of "$key and more", if it is known. Returns other texts unchanged. The
  // result is not translated again.
  std::string localize(std::string_view text) const;
  // The same for a text in which a server has joined a key and its arguments: "$qc_got_item$item_health\n",
  // "$qc_suicidePlayer\n". Places of the key's text are filled; a '$' begins the next argument.
  std::string localize_joined(std::string_view text) const;
  // Whether localize() would replace a key.
  bool has_text_for(std::string_view text) const;
  // Takes the texts of `other` for all its keys.
  void add(Localization other);

  const Texts& texts() const { return texts_; }

 private:
  Texts texts_;
};

struct LocalizationProblem {
  std::size_t line = 0;  // counted from 1
  std::string what;
  bool operator==(const LocalizationProblem&) const = default;
};

struct ReadLocalization {
  Localization localization;
  // Lines that were left out, at most the first kMaxProblems.
  static constexpr std::size_t kMaxProblems = 20;
  std::vector<LocalizationProblem> problems;
  std::size_t problem_count = 0;
  // How many texts have letters that the game's characters cannot write.
  std::size_t unknown_letters = 0;
};

// Returns kTooLarge for more than kMaxLocalizationBytes, kMalformed for text with zero bytes. All other
// problems belong to one line: no key, no quoted text, a text that refers to itself, too many or too long
// texts.
base::Result<ReadLocalization> read_localization(std::string_view text);

// Replaces {0} in the text by the first argument, {1} by the second, and so on. Other braces stay.
std::string fill_places(std::string_view text, std::span<const std::string> arguments);

}  // namespace temblor::formats
