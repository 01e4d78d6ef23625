#include "net/protocol/mark_request.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text.h"
#include "base/words.h"

namespace temblor::net {
namespace {

constexpr std::string_view kMarkPrefix = "//temblor mark ";
constexpr std::string_view kShapes[] = {"*hole", "*scorch", "*blood"};
// Limit for coordinates and angles, so that sums and products stay finite.
constexpr float kMaxMarkNumber = 1e6f;

std::optional<float> parse_mark_number(std::string_view word) {
  const std::optional<float> number = base::parse_number<float>(word);
  if (!number || std::abs(*number) > kMaxMarkNumber) return std::nullopt;
  return number;
}

bool is_picture_name(std::string_view name) {
  if (std::find(std::begin(kShapes), std::end(kShapes), name) != std::end(kShapes)) return true;
  return !name.empty() && name.size() <= MarkRequest::kMaxNameChars &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
         });
}

std::optional<std::uint32_t> parse_model(std::string_view word) {
  if (!word.starts_with('*')) return std::nullopt;
  const std::optional<std::uint32_t> number = base::parse_number<std::uint32_t>(word.substr(1));
  return number && *number > 0 ? number : std::nullopt;
}

}  // namespace

bool is_mark_request(std::string_view line) {
  return line.starts_with(kMarkPrefix);
}

base::Result<MarkRequest> read_mark_request(std::string_view line) {
  // Quotes separate words too: they surround the vectors that QuakeC prints.
  const std::vector<std::string_view> words = base::split_words(line.substr(kMarkPrefix.size()), " '\t\r\n");
  constexpr std::size_t kFewest = 5, kMost = 7;
  if (words.size() < kFewest || words.size() > kMost)
    return base::malformed("{} words, expected PICTURE X Y Z RADIUS [TURN [*N]]", words.size());
  MarkRequest request{.picture = base::to_lower(words[0])};
  if (!is_picture_name(request.picture))
    return base::malformed(
        "bad picture name \"{}\": use up to {} letters, digits, _ and -, or *hole, *scorch, or *blood",
        base::quotable(words[0]), MarkRequest::kMaxNameChars);
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words[static_cast<std::size_t>(axis) + 1];
    const std::optional<float> number = parse_mark_number(word);
    if (!number) return base::malformed("coordinate \"{}\" is not a number", base::quotable(word));
    request.origin[axis] = *number;
  }
  const std::optional<float> radius = parse_mark_number(words[4]);
  if (!radius || *radius < MarkRequest::kMinRadius || *radius > MarkRequest::kMaxRadius)
    return base::malformed("radius \"{}\" is not a number from {} to {}", base::quotable(words[4]),
                           MarkRequest::kMinRadius, MarkRequest::kMaxRadius);
  request.radius = *radius;
  if (words.size() > kFewest) {
    const std::optional<float> turn_deg = parse_mark_number(words[5]);
    if (!turn_deg) return base::malformed("turn \"{}\" is not a number", base::quotable(words[5]));
    request.turn_deg = *turn_deg;
  }
  if (words.size() == kMost) {
    request.model = parse_model(words[6]);
    if (!request.model)
      return base::malformed("\"{}\" is not the name of a brush model, such as *3", base::quotable(words[6]));
  }
  return request;
}

}  // namespace temblor::net
