#include "client/console/console_log.h"

#include "client/console/utf8.h"

namespace temblor::client {

namespace {

// Set in the codes of bronze characters.
constexpr std::uint8_t kBronze = 0x80;

// Converts a console character to ASCII. Codes below ' ' are frames, dots and gold digits.
char to_ascii(char c) {
  constexpr std::string_view kBelowSpace = "#####.#######>..[]0123456789.<->";
  const auto shape = static_cast<std::uint8_t>(static_cast<std::uint8_t>(c) & ~kBronze);
  if (shape == 0x7f) return '<';  // an arrow
  return shape < kBelowSpace.size() ? kBelowSpace[shape] : static_cast<char>(shape);
}

}  // namespace

// Bytes 1 and 2 are the protocol's prefixes for bronze text; with 2 stock Quake also plays the chat sound.
void ConsoleLog::print(std::string_view text, double time_s) {
  const bool is_bronze = !text.empty() && (text[0] == 1 || text[0] == 2);
  if (is_bronze) text.remove_prefix(1);
  add(text, is_bronze ? kBronze : std::uint8_t{0}, time_s);
}

void ConsoleLog::print_utf8(std::string_view text, double time_s) {
  add(to_glyphs(text), 0, time_s);
}

void ConsoleLog::clear() {
  begin_line_ = end_line();
  lines_.clear();
  chars_ = 0;
  grows_ = returned_ = false;
}

void ConsoleLog::add(std::string_view text, std::uint8_t color, double time_s) {
  for (const char c : text) {
    if (c == '\n')
      end_line_at(time_s);
    else if (c == '\r')
      returned_ = true;
    else
      add(static_cast<char>(static_cast<std::uint8_t>(c == '\t' ? ' ' : c) | color), time_s);
  }
  forget_old();
}

// A character after '\r' replaces the whole line. The line is emptied only now, so that "\r\n" leaves it
// intact.
void ConsoleLog::add(char c, double time_s) {
  if (!grows_) lines_.emplace_back();
  grows_ = true;
  Line& line = lines_.back();
  if (returned_) {
    chars_ -= line.text.size();
    line.text.clear();
  }
  returned_ = false;
  line.text += c;
  line.time_s = time_s;
  ++chars_;
  if (line.text.size() == kMaxLineChars) end_line_at(time_s);
}

void ConsoleLog::end_line_at(double time_s) {
  if (!grows_) lines_.push_back({"", time_s});
  grows_ = returned_ = false;
  // Drops old lines here too, so that a text of only line ends stays within the limits.
  if (lines_.size() > 2 * kMaxLines) forget_old();
}

// Drops whole lines from the front. Their numbers are never reused, so positions in the log stay valid.
void ConsoleLog::forget_old() {
  while (lines_.size() > kMaxLines || chars_ > kMaxChars) {
    chars_ -= lines_.front().text.size();
    lines_.pop_front();
    ++begin_line_;
  }
}

std::string ConsoleLog::text() const {
  std::string text;
  text.reserve(chars_ + lines_.size());
  for (const Line& line : lines_) {
    for (const char c : line.text) text += to_ascii(c);
    text += '\n';
  }
  return text;
}

}  // namespace temblor::client
