#include "app/html/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "app/html/page_style.h"
#include "base/text.h"

namespace temblor::app {
namespace {

// Base64 with padding (RFC 4648, section 4).
std::string encode_base64(base::Bytes bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace

std::string begin_page(std::string_view title, std::string_view more_style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
      "charset=\"utf-8\"/>\n<meta name=\"viewport\" "
      "content=\"width=device-width\"/>\n<title>{}</title>\n<style>{}{}</style>\n</head>\n<body>\n",
      escape_html(title), kPageStyle, more_style);
}

std::string escape_html(std::string_view text) {
  std::string safe;
  for (const char c : base::printable(text)) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  return safe;
}

std::string make_png_uri(base::Bytes png) {
  return "data:image/png;base64," + encode_base64(png);
}

std::string make_bar(double share, bool is_alarm) {
  return fmt::format("<span class=\"bar{}\"><i style=\"width:{:.1f}%\"></i></span>", is_alarm ? " alarm" : "",
                     std::clamp(share, 0.0, 1.0) * 100);
}

}  // namespace temblor::app
