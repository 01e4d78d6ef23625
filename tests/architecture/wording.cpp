#include "architecture/wording.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

#include "architecture/source_tree.h"

namespace temblor::test {

namespace {

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool is_upper(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
}

std::string to_lower(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// Calls `visit(word)` for each run of letters inside `name`, split where a capital letter starts a new word.
template <typename Visit>
void for_each_part(std::string_view name, const Visit& visit) {
  std::size_t begin = 0;
  while (begin < name.size()) {
    if (!is_letter(name[begin])) {
      ++begin;
      continue;
    }
    // A capital starts a word after a small letter ("fogColor") and before one ("ANewGame").
    const auto starts_word = [&](std::size_t at) {
      const bool is_before_small = at + 1 < name.size() && is_letter(name[at + 1]) && !is_upper(name[at + 1]);
      return is_upper(name[at]) && (!is_upper(name[at - 1]) || is_before_small);
    };
    std::size_t end = begin + 1;
    while (end < name.size() && is_letter(name[end]) && !starts_word(end)) ++end;
    visit(name.substr(begin, end - begin));
    begin = end;
  }
}

// Prose with one space between words, comment marks removed, in lower case, and the line of each character.
struct FlatText {
  std::string text;
  std::vector<int> lines;
};
FlatText flatten(std::string_view text) {
  FlatText flat;
  int line = 1;
  bool at_line_start = true;
  const auto append = [&](char c) {
    if (c == ' ' && (flat.text.empty() || flat.text.back() == ' ')) return;
    flat.text += c;
    flat.lines.push_back(line);
  };
  for (const char c : text) {
    const bool is_mark = at_line_start && (c == '/' || c == '#' || c == '*');
    if (c == '\n') {
      append(' ');
      ++line;
      at_line_start = true;
    } else if (c == ' ' || c == '\t' || is_mark) {
      append(' ');
    } else {
      at_line_start = false;
      append(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    }
  }
  return flat;
}

// Blanks the lines that end in the mark of kOldSpellingMark; line numbers stay.
std::string remove_marked_lines(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (!line.ends_with(kOldSpellingMark)) kept += line;
    if (line.size() < text.size()) kept += '\n';
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return kept;
}

std::string describe(const std::string& path, int line, std::string_view found, const RetiredWord& word) {
  return path + ":" + std::to_string(line) + ": '" + std::string(found) + "' is retired; use '" +
         word.replacement + "'";
}

}  // namespace

base::Result<std::vector<RetiredWord>> parse_retired_words(std::string_view text) {
  static const std::map<std::string_view, RetiredWord::Kind> kinds = {
      {"part", RetiredWord::Kind::kPart},
      {"name", RetiredWord::Kind::kName},
      {"phrase", RetiredWord::Kind::kPhrase},
      {"pattern", RetiredWord::Kind::kPattern}};
  std::vector<RetiredWord> words;
  for (int line = 1; !text.empty(); ++line) {
    const std::string_view row = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(row.size() + 1, text.size()));
    if (row.empty() || row.front() == '#') continue;
    const std::size_t colon = row.find(": "), arrow = row.find(" -> ");
    const auto kind = kinds.find(row.substr(0, colon == std::string_view::npos ? 0 : colon));
    if (kind == kinds.end() || arrow == std::string_view::npos || arrow < colon + 2)
      return base::Error{base::ErrorCode::kMalformed,
                         "expected 'part|name|phrase|pattern: TEXT -> REPLACEMENT'",
                         "retired_words.txt:" + std::to_string(line)};
    words.push_back({kind->second, std::string(row.substr(colon + 2, arrow - colon - 2)),
                     std::string(row.substr(arrow + 4))});
  }
  return words;
}

RetiredWordFinder::RetiredWordFinder(std::vector<RetiredWord> words) : words_(std::move(words)) {
  for (const RetiredWord& word : words_)
    if (word.kind == RetiredWord::Kind::kPattern) patterns_.emplace_back(word.text, &word);
}

const RetiredWordFinder::Verdict& RetiredWordFinder::judge(std::string_view use) {
  if (const auto known = verdicts_.find(use); known != verdicts_.end()) return known->second;
  Verdict& verdict = verdicts_[std::string(use)];
  const std::string_view name = use.substr(0, use.find('('));
  const auto search = [&](RetiredWord::Kind kind, std::string_view text) {
    for (const RetiredWord& word : words_)
      if (word.kind == kind && word.text == text) verdict.names_and_parts.push_back(&word);
  };
  search(RetiredWord::Kind::kName, name);
  for_each_part(name, [&](std::string_view part) { search(RetiredWord::Kind::kPart, to_lower(part)); });
  for (const auto& [pattern, word] : patterns_)
    if (std::regex_search(use.begin(), use.end(), pattern)) verdict.patterns.push_back(word);
  return verdict;
}

std::vector<std::string> RetiredWordFinder::find(const std::string& path, std::string_view whole_text) {
  const std::string text = remove_marked_lines(whole_text);
  std::set<std::string_view> reported;  // names that match patterns
  std::vector<std::string> violations;
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_name_character(text[i])) {
      line += text[i++] == '\n';
      continue;
    }
    const std::size_t begin = i;
    while (i < text.size() && is_name_character(text[i])) ++i;
    const std::string_view name = std::string_view(text).substr(begin, i - begin);
    const std::string_view use(name.data(), name.size() + (i < text.size() && text[i] == '(' ? 1 : 0));
    const Verdict& verdict = judge(use);
    for (const RetiredWord* word : verdict.names_and_parts)
      violations.push_back(describe(path, line, name, *word));
    if (!verdict.patterns.empty() && reported.insert(use).second)
      for (const RetiredWord* word : verdict.patterns) violations.push_back(describe(path, line, use, *word));
  }
  const FlatText flat = flatten(text);
  for (const RetiredWord& word : words_) {
    if (word.kind != RetiredWord::Kind::kPhrase) continue;
    for (std::size_t at = flat.text.find(word.text); at != std::string::npos;
         at = flat.text.find(word.text, at + 1)) {
      const std::size_t end = at + word.text.size();
      const bool is_whole = (at == 0 || !is_name_character(flat.text[at - 1])) &&
                            (end == flat.text.size() || !is_name_character(flat.text[end]));
      if (is_whole) violations.push_back(describe(path, flat.lines[at], word.text, word));
    }
  }
  return violations;
}

std::vector<std::string> find_sentences_without_subject(const std::string& path, std::string_view text) {
  static const std::regex start_of_sentence(R"((^|[.:!?] )(What|Who|Whose|Of|As) )");
  // Few comments contain these words, and a regular expression is slow.
  const auto may_match = [](std::string_view comment) {
    constexpr std::array<std::string_view, 5> kWords = {"What ", "Who ", "Whose ", "Of ", "As "};
    return std::ranges::any_of(
        kWords, [&](std::string_view word) { return comment.find(word) != std::string_view::npos; });
  };
  std::vector<std::string> violations;
  bool starts_sentence = true;  // the next comment line does
  for (int line = 1; !text.empty(); ++line) {
    const std::string_view row = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(row.size() + 1, text.size()));
    const std::size_t mark = row.find("// ");
    if (mark == std::string_view::npos) {
      starts_sentence = true;
      continue;
    }
    std::string comment(row.substr(mark + 3));
    if (!starts_sentence) comment.insert(0, "...");  // the line continues a sentence
    if (may_match(comment) && std::regex_search(comment, start_of_sentence))
      violations.push_back(path + ":" + std::to_string(line) +
                           ": start this sentence with its subject: " + comment);
    starts_sentence = row.ends_with('.') || row.ends_with(':');
  }
  return violations;
}

}  // namespace temblor::test
