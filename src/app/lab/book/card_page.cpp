#include "app/lab/book/card_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "app/bench/measurement_output.h"
#include "app/files/atomic_write.h"
#include "app/html/html.h"
#include "app/html/plot.h"
#include "app/lab/card/card_methods.h"
#include "app/lab/card/card_pictures.h"

namespace temblor::app {
namespace {

using render_gl::WorldMethod;

constexpr FrameSize kCardPictureSize{640, 400};

constexpr const char* kCardExplanation =
    "<p class=\"soft\"><code>temblor lab card</code></p>\n"
    "<p>The articles end with graphics cards, and with the question of what they should do. Here, OpenGL "
    "draws "
    "the same frames by each answer: the level's lit faces get their texels in another way, and everything "
    "else is drawn as in the game with <code>vid_renderer gl</code>. Start with "
    "<code>src/render_gl/draw_options.h</code>.</p>\n";

std::string make_conditions(const CardResults& results) {
  return fmt::format(
      "<p class=\"soft\">{}; {}. Times are those of whole frames, with the picture read back; the card's "
      "part is the median of its own timer, if it has one. "
      "Equal pixels are within 2 of 255 of the CPU's; in 256 colors (8 bits), they have the same "
      "index.</p>\n",
      escape_html(results.name), escape_html(results.driver));
}

std::string describe_card_run(const CardFigures& f) {
  if (f.method != WorldMethod::kBlocks) return find_card_method(f.method).title;
  return fmt::format("Blocks of {} bits in {} MB", count_bits(f.cache.format), f.cache.bytes >> 20);
}

std::string make_card_row(const CardFigures& f) {
  if (!f.problem.empty())
    return fmt::format("<tr><td>{}</td><td colspan=\"9\">{}</td></tr>\n", escape_html(describe_card_run(f)),
                       escape_html(f.problem));
  std::string html = fmt::format("<tr><td>{}</td>", escape_html(describe_card_run(f)));
  const auto add = [&](const std::string& cell) { html += fmt::format("<td class=\"n\">{}</td>", cell); };
  add(fmt::format("{:.2f}", f.frame_ms.p50));
  add(fmt::format("{:.2f}", f.frame_ms.p99));
  add(f.card_ms ? fmt::format("{:.2f}", f.card_ms->p50) : "");
  add(fmt::format("{:.1f}", f.hits));
  add(fmt::format("{:.1f}", f.uploads));
  add(fmt::format("{:.0f}", f.bytes_uploaded / 1000));
  add(fmt::format("{:.0f}", f.max_bytes_uploaded / 1000));
  add(fmt::format("{:.1f}", static_cast<double>(f.cache_bytes) / (1 << 20)));
  add(fmt::format("{:.2f} %", 100 * f.equal_share));
  return html + "</tr>\n";
}

std::string make_card_tables(const CardResults& results) {
  std::string html;
  const CardFigures* previous = nullptr;
  for (const CardFigures& f : results.runs) {
    if (previous == nullptr || format_size(previous->size) != format_size(f.size))
      html += fmt::format(
          "{}<h3>{}, {} frames</h3>\n<table>\n<tr><th>method</th><th class=\"n\">median, ms</th><th "
          "class=\"n\">99%, ms</th><th class=\"n\">card, ms</th><th class=\"n\">hits</th><th "
          "class=\"n\">uploads</th><th class=\"n\">KB "
          "uploaded</th><th class=\"n\">at most</th><th class=\"n\">MB on the card</th><th class=\"n\">equal "
          "pixels</th></tr>\n",
          previous == nullptr ? "" : "</table>\n", format_size(f.size), f.frames);
    html += make_card_row(f);
    previous = &f;
  }
  return html + "</table>\n";
}

// `shown`: those with a picture.
std::string make_card_methods(std::span<const WorldMethod> shown) {
  std::string html;
  for (const CardMethod& method : list_card_methods()) {
    html += fmt::format(
        "<section><h2>{}</h2>\n<p>{}</p>\n<h3>The article</h3>\n<p>{}</p>\n<h3>Here</h3>\n<p>{}</p>\n",
        escape_html(method.title), escape_html(method.summary), escape_html(method.claim),
        escape_html(method.explanation));
    if (std::ranges::find(shown, method.method) != shown.end())
      html += fmt::format(
          "<p><img class=\"wide\" src=\"{}\" alt=\"{}, the CPU's picture, and their difference\"/></p>\n",
          card_picture_name(method), escape_html(method.title));
    html += "</section>\n";
  }
  return html;
}

std::string make_card_page(const base::Result<CardResults>& results, std::span<const WorldMethod> shown) {
  std::string html = begin_page("Graphics cards", std::string(kPlotStyle) + "a { color: var(--bar); }") +
                     "<p><a href=\"index.html\">The laboratory's book</a></p>\n<h1>Graphics cards</h1>\n" +
                     kCardExplanation;
  if (results.ok())
    html += make_conditions(*results) + make_card_tables(*results) + make_card_methods(shown);
  else
    html += fmt::format("<p>Not measured: {}.</p>\n", escape_html(results.error().message()));
  return html + "</body>\n</html>\n";
}

}  // namespace

base::Status write_card_page(const std::filesystem::path& folder, const LabScenes& scenes,
                             const CardGrid& grid, const render::Settings& settings) {
  const render::Settings adapted = scenes.adapt(settings);
  const base::Result<CardResults> results = measure_card(scenes, grid, adapted);
  std::vector<WorldMethod> shown;
  if (results.ok()) {
    TRY(shown, write_card_pictures(folder, scenes, kCardPictureSize, adapted));
  }
  return replace_file(folder / "card.html", base::as_bytes(make_card_page(results, shown)));
}

}  // namespace temblor::app
