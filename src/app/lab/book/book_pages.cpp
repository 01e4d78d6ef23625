#include "app/lab/book/book_pages.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/bench/measurement_output.h"
#include "app/html/html.h"
#include "app/html/plot.h"
#include "base/text.h"
#include "lab/registry.h"

namespace temblor::app {
namespace {

constexpr const char* kBookStyle = R"(
.no { color: var(--alarm); } .partly { color: #b7791f; }
a { color: var(--bar); }
h3 { margin: 1.2rem 0 .3rem; font-size: 1rem; }
code { font-size: .9em; }
th, th.n { white-space: normal; vertical-align: bottom; }
section table { font-size: .9rem; }
)";

struct HoldsText {
  const char *style, *text;
};
HoldsText describe(Holds holds) {
  switch (holds) {
    case Holds::kYes:
      return {"good", "holds"};
    case Holds::kPartly:
      return {"partly", "holds in part"};
    case Holds::kNo:
      break;
  }
  return {"no", "does not hold"};
}

std::string begin_book_page(std::string_view title) {
  return begin_page(title, std::string(kPlotStyle) + kBookStyle);
}

std::string end_page() {
  return fmt::format(
      "<footer>Made by <code>temblor lab book</code>, version {}.</footer>\n</body>\n</html>\n",
      escape_html(TEMBLOR_VERSION));
}

const lab::Technique& find_technique(const BookEntry& entry) {
  return *lab::parse_choice(entry.technique).value().technique;
}

// A column of a table of figures.
struct Column {
  const char* name;
  std::string (*show)(const TechniqueFigures& figures);
};

double sum_cycles(const TechniqueFigures& figures, std::initializer_list<render::Stage> stages) {
  double sum = 0;
  for (const render::Stage stage : stages)
    sum += figures.measurement.stage_cycles_per_pixel[static_cast<std::size_t>(stage)];
  return sum;
}

std::string show(double value, int decimals) {
  return fmt::format("{:.{}f}", value, decimals);
}

constexpr Column kSurfaceColumns[] = {
    {"faces", [](const TechniqueFigures& f) { return show(f.measurement.faces_drawn.p50, 0); }},
    {"edges", [](const TechniqueFigures& f) { return show(f.measurement.edges.p50, 0); }},
    {"spans", [](const TechniqueFigures& f) { return show(f.measurement.spans.p50, 0); }},
    {"pixels written", [](const TechniqueFigures& f) { return show(f.views.pixels_written, 2); }},
    {"depth tests", [](const TechniqueFigures& f) { return show(f.views.pixels_tested, 2); }},
    {"comparisons", [](const TechniqueFigures& f) { return show(f.views.comparisons, 0); }},
    {"memory, KB", [](const TechniqueFigures& f) { return show(f.views.bytes / 1024, 0); }},
    {"wrong faces", [](const TechniqueFigures& f) {
       const oracle::Tally& tally = f.views.tally;
       const double wrong =
           tally.pixels == 0 ? 0 : static_cast<double>(tally.wrong_face) / static_cast<double>(tally.pixels);
       return show(100 * wrong, 3) + " %";
     }}};
constexpr Column kLightColumns[] = {
    {"cycles per pixel",
     [](const TechniqueFigures& f) {
       return show(sum_cycles(f, {render::Stage::kSurfaces, render::Stage::kSpans}), 1);
     }},
    {"memory, KB", [](const TechniqueFigures& f) { return show(f.views.bytes / 1024, 0); }},
    {"light error, mean", [](const TechniqueFigures& f) { return show(f.views.light.error.mean(), 2); }},
    {"largest", [](const TechniqueFigures& f) { return show(f.views.light.error.largest, 1); }},
    {"seams, mean", [](const TechniqueFigures& f) { return show(f.views.light.seams.mean(), 2); }},
    {"shadow edges, mean",
     [](const TechniqueFigures& f) { return show(f.views.light.shadow_edges.mean(), 2); }},
    {"largest shift: turn", [](const TechniqueFigures& f) { return show(f.views.light.turn.largest, 1); }},
    {"roll", [](const TechniqueFigures& f) { return show(f.views.light.roll.largest, 1); }}};
constexpr Column kTexelColumns[] = {
    {"cycles per pixel",
     [](const TechniqueFigures& f) { return show(sum_cycles(f, {render::Stage::kSpans}), 2); }},
    {"wrong texels", [](const TechniqueFigures& f) { return show(100 * f.views.pixels_off, 2) + " %"; }},
    {"largest error, texels", [](const TechniqueFigures& f) { return show(f.views.max_texel_error, 1); }},
    {"shift, turn: mean", [](const TechniqueFigures& f) { return show(f.views.texels.turn.mean(), 2); }},
    {"roll: mean", [](const TechniqueFigures& f) { return show(f.views.texels.roll.mean(), 2); }}};

constexpr Column kModelColumns[] = {
    {"models: cycles per pixel",
     [](const TechniqueFigures& f) { return show(sum_cycles(f, {render::Stage::kModels}), 2); }},
    {"memory, KB", [](const TechniqueFigures& f) { return show(f.views.bytes / 1024, 0); }},
    {"wrong outline",
     [](const TechniqueFigures& f) { return show(100 * f.views.models.outline_share(), 2) + " %"; }},
    {"texel error, mean", [](const TechniqueFigures& f) { return show(f.views.models.mean_texels(), 2); }},
    {"above 2 texels",
     [](const TechniqueFigures& f) { return show(100 * f.views.models.off_share(), 2) + " %"; }}};

std::span<const Column> list_columns(BookColumns columns) {
  switch (columns) {
    case BookColumns::kModels:
      return kModelColumns;
    case BookColumns::kLight:
      return kLightColumns;
    case BookColumns::kTexels:
      return kTexelColumns;
    case BookColumns::kSurfaces:
      break;
  }
  return kSurfaceColumns;
}

std::string make_figures_table(const Evidence& evidence, std::span<const Column> columns) {
  std::string html =
      "<table>\n<tr><th>level</th><th class=\"n\">median, ms</th><th class=\"n\">times the engine</th><th "
      "class=\"n\">99th / median</th>";
  for (const Column& column : columns) html += fmt::format("<th class=\"n\">{}</th>", column.name);
  for (const LevelFigures& level : evidence.figures().levels) {
    const TechniqueFigures& f = level.techniques[evidence.number()];
    const double engine_ms = level.techniques.front().measurement.frame_ms.p50;
    const Distribution& ms = f.measurement.frame_ms;
    html += fmt::format("</tr>\n<tr><td>{}</td>", escape_html(level.name));
    for (const std::string& value : {show(ms.p50, 2), show(ms.p50 / engine_ms, 2), show(ms.p99 / ms.p50, 1)})
      html += fmt::format("<td class=\"n\">{}</td>", value);
    for (const Column& column : columns) html += fmt::format("<td class=\"n\">{}</td>", column.show(f));
  }
  return html + "</tr>\n</table>\n";
}

// The picture is missing for the engine, which does not differ from itself.
std::string make_picture(const Evidence& evidence, const BookEntry& entry) {
  if (evidence.number() == 0) return "";
  const double most = evidence.different_shares().high;
  const std::string caption =
      most == 0 ? "The technique, the engine, and their difference, which is none in any measured view."
                : fmt::format(
                      "The technique, the engine, and their difference, in the view where they differ "
                      "most ({:.2f} % of pixels).",
                      100 * most);
  return fmt::format(
      "<figure><a href=\"{0}\"><img class=\"wide\" alt=\"{1}\" src=\"{0}\"/></a><figcaption>{2}</figcaption>"
      "</figure>\n",
      picture_file_name(entry.technique), escape_html(entry.technique), caption);
}

std::string make_film(const BookEntry& entry) {
  if (!entry.has_film) return "";
  return fmt::format(
      "<figure><img class=\"wide\" alt=\"film of {1}\" src=\"{0}\"/><figcaption>The light of the technique, "
      "and of the engine, on gray walls, while the camera turns and rolls.</figcaption></figure>\n",
      film_file_name(entry.technique), escape_html(entry.technique));
}

std::string make_entry(const BookInput& input, const BookChapter& chapter, const BookEntry& entry) {
  const Evidence evidence = Evidence(input.choose_figures(chapter.of_models), 0).of(entry.technique);
  const lab::Technique& technique = find_technique(entry);
  const Verdict verdict = entry.judge(evidence);
  const HoldsText holds = describe(verdict.holds);
  const bool has_parameters = entry.technique != technique.name;
  std::string html = fmt::format(
      "<section id=\"{}\">\n<h2>{}{}</h2>\n<p class=\"soft\"><code>temblor lab run "
      "{}</code></p>\n<p>{}</p>\n",
      picture_file_name(entry.technique), escape_html(technique.title),
      has_parameters ? ": " + escape_html(entry.technique.substr(technique.name.size() + 1)) : "",
      escape_html(entry.technique), escape_html(entry.explanation));
  html +=
      fmt::format("<h3>The article's claim</h3>\n<p>{} <span class=\"soft\">({}, \"{}\")</span></p>\n",
                  escape_html(entry.claim), escape_html(technique.article), escape_html(technique.heading));
  html += fmt::format(
      "<h3>Our measurement: the claim <span class=\"{}\">{}</span></h3>\n<p>{}</p>\n<p class=\"soft\">How "
      "far "
      "it is optimized: {}</p>\n",
      holds.style, holds.text, escape_html(verdict.text), escape_html(entry.optimized));
  return html + make_figures_table(evidence, list_columns(chapter.columns)) + make_picture(evidence, entry) +
         make_film(entry) + "</section>\n";
}

// The numbers of a chapter's techniques in the figures, those with default parameters first. More series than
// colors would be hard to tell apart.
std::vector<std::size_t> choose_series(const BookFigures& figures, const BookChapter& chapter) {
  std::vector<std::size_t> chosen{0};
  for (const bool is_default : {true, false})
    for (const BookEntry& entry : chapter.entries) {
      const std::size_t number = Evidence(figures, 0).of(entry.technique).number();
      const bool has_defaults = entry.technique.find(':') == std::string_view::npos;
      if (number == 0 || has_defaults != is_default || chosen.size() == kPlotColors) continue;
      chosen.push_back(number);
    }
  return chosen;
}

std::string make_plots(const BookInput& input, const BookChapter& chapter) {
  const BookFigures& figures = input.choose_figures(chapter.of_models);
  Plot by_faces{.title = fmt::format("Cost against polygons: {} views of all levels at {}.",
                                     figures.views.size(), format_size(input.options.size)),
                .x_label = "faces in the engine's edge list",
                .y_label = "frame, ms",
                .has_lines = false};
  if (chapter.of_models) {
    by_faces.x_label = "triangles of the models in view";
    by_faces.x_axis = by_faces.y_axis = Axis::kLogarithmic;
  }
  Plot by_size{.title = fmt::format("Cost against resolution: median of {}, from {} to {}.",
                                    figures.levels.front().name, format_size(figures.sizes.front().size),
                                    format_size(figures.sizes.back().size)),
               .x_label = "pixels",
               .y_label = "frame, ms",
               .x_axis = Axis::kLogarithmic,
               .y_axis = Axis::kLogarithmic};
  for (const std::size_t number : choose_series(figures, chapter)) {
    PlotSeries views{figures.choices[number].label(), {}}, sizes = views;
    for (const ViewTimes& view : figures.views) views.points.push_back({view.faces, view.ms[number]});
    for (const SizeTimes& size : figures.sizes)
      sizes.points.push_back({double(size.size.width) * size.size.height, size.ms[number]});
    by_faces.series.push_back(std::move(views));
    by_size.series.push_back(std::move(sizes));
  }
  return "<section id=\"plots\">\n<h2>Cost</h2>\n" + draw_plot(by_faces) + draw_plot(by_size) +
         "</section>\n";
}

std::string make_grid(const BookInput& input, const BookChapter& chapter) {
  const BookFigures& figures = input.choose_figures(chapter.of_models);
  return figures.grid.techniques.empty() ? "" : make_grid_section(figures.grid, figures.choices);
}

std::string make_conditions(const BookInput& input, const BookFigures& figures) {
  std::string levels;
  for (const LevelFigures& level : figures.levels)
    levels += (levels.empty() ? "" : ", ") + escape_html(level.name);
  const render::Settings& settings = input.options.settings;
  return fmt::format(
      "<p>Levels: {}. Measured at {} in <code>{}</code> on {}, {}, in {:.0f} s. Times are medians of full "
      "circles at all viewpoints, with warm caches. An oracle, which follows a ray through each pixel, "
      "judges "
      "faces.</p>\n",
      levels, format_size(input.options.size), pixel_format_name(input.options.format),
      escape_html(input.processor), base::counted(static_cast<std::size_t>(settings.threads), "thread"),
      figures.seconds);
}

std::string make_verdicts(const BookInput& input) {
  std::string html;
  for (const BookChapter& chapter : list_book_chapters()) {
    html += fmt::format(
        "<section>\n<h2><a href=\"{0}.html\">{1}</a></h2>\n<p>{2}</p>\n<table>\n<tr><th>technique</th><th "
        "class=\"n\">times the engine</th><th class=\"n\">wrong faces</th><th>its article's "
        "claim</th></tr>\n",
        chapter.file, escape_html(chapter.title), escape_html(chapter.introduction));
    for (const BookEntry& entry : chapter.entries) {
      const Evidence evidence = Evidence(input.choose_figures(chapter.of_models), 0).of(entry.technique);
      const HoldsText holds = describe(entry.judge(evidence).holds);
      const Range wrong = evidence.wrong_shares();
      html += fmt::format(
          "<tr><td><a href=\"{}.html#{}\">{}</a></td><td class=\"n\">{}</td><td class=\"n\">{} %</td><td "
          "class=\"{}\">{}</td></tr>\n",
          chapter.file, picture_file_name(entry.technique), escape_html(entry.technique),
          evidence.time_ratios().text(2), Range{100 * wrong.low, 100 * wrong.high}.text(2), holds.style,
          holds.text);
    }
    html += "</table>\n</section>\n";
  }
  return html;
}

std::string make_numbers(const BookInput& input) {
  std::string html =
      "<section id=\"numbers\">\n<h2>The articles' numbers, and ours</h2>\n<p>Theirs are of 1996, mostly of "
      "a "
      "Pentium.</p>\n<table>\n<tr><th>number</th><th>article</th><th class=\"n\">theirs</th><th "
      "class=\"n\">ours</th></tr>\n";
  for (const ArticleNumber& number : list_article_numbers())
    html += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
                        escape_html(number.claim), escape_html(number.article), escape_html(number.theirs),
                        escape_html(number.ours(input.choose_figures(number.of_models))));
  return html + "</table>\n</section>\n";
}

}  // namespace

std::string picture_file_name(std::string_view technique) {
  std::string name(technique);
  std::ranges::replace_if(
      name, [](char c) { return c == ':' || c == '=' || c == ','; }, '-');
  return name + ".png";
}

std::string film_file_name(std::string_view technique) {
  return "film-" + picture_file_name(technique);
}

std::string make_index_page(const BookInput& input) {
  return begin_book_page("The laboratory's book") + "<h1>The laboratory's book</h1>\n" +
         "<p>Michael Abrash's articles explain how Quake draws its world by what else was tried. Here, the "
         "alternatives draw the same views as Temblor's renderer, under the same clock.</p>\n" +
         "<p><a href=\"school.html\">The school</a> is for beginners: a small renderer, from a line to a "
         "scene. <a href=\"space.html\">The space battle</a> is the article's program for edges sorted by "
         "1/z, without a level. <a href=\"wire.html\">The wire</a> compares ways to send a game to its "
         "players, and <a href=\"card.html\">Graphics cards</a> ways to draw with OpenGL.</p>\n" +
         make_conditions(input, input.figures) + make_verdicts(input) + make_numbers(input) + end_page();
}

std::string make_chapter_page(const BookInput& input, const BookChapter& chapter) {
  std::string html =
      begin_book_page(chapter.title) + "<p><a href=\"index.html\">The laboratory's book</a></p>\n" +
      fmt::format("<h1>{}</h1>\n<p>{}</p>\n", escape_html(chapter.title), escape_html(chapter.introduction)) +
      make_conditions(input, input.choose_figures(chapter.of_models)) + make_plots(input, chapter) +
      make_grid(input, chapter);
  for (const BookEntry& entry : chapter.entries) html += make_entry(input, chapter, entry);
  return html + end_page();
}

}  // namespace temblor::app
