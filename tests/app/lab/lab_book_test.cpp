// `temblor lab book`: its texts cover all techniques, its verdicts follow the measurements, and its pages are
// well-formed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/html/plot.h"
#include "app/lab/book/book_content.h"
#include "app/lab/book/book_pages.h"
#include "app/lab/book/space_page.h"
#include "app/lab/book/wire_page.h"
#include "app/lab/book/write_book.h"
#include "app/lab/card/card_pictures.h"
#include "app/lab/model_grid.h"
#include "app/lab/wire/wire_command.h"
#include "app/level/level_loading.h"
#include "app/level/viewpoints.h"
#include "app/program.h"
#include "lab/lessons.h"
#include "lab/registry.h"
#include "support/effort.h"
#include "support/page_markup.h"
#include "support/programs/small_game.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(LabBook, HasAnEntryForEachTechnique) {
  std::set<std::string_view> names;
  for (const lab::Choice& choice : app::list_book_techniques()) names.insert(choice.technique->name);
  for (const lab::Technique& technique : lab::list_techniques())
    EXPECT_TRUE(names.contains(technique.name)) << technique.name;
  for (const app::BookChapter& chapter : app::list_book_chapters())
    for (const app::BookEntry& entry : chapter.entries) {
      EXPECT_EQ(lab::parse_choice(entry.technique).value().label(), entry.technique);
      for (const std::string_view text : {entry.explanation, entry.claim, entry.optimized})
        EXPECT_TRUE(text.ends_with('.')) << entry.technique << ": " << text;
    }
}

// Measurements of one level, in which every technique is as fast as the engine, and right.
app::BookFigures make_figures() {
  app::BookFigures figures;
  figures.choices = app::list_book_techniques();
  app::LevelFigures level{"e1m1", {}, {}, {}};
  for (const lab::Choice& choice : figures.choices) {
    app::TechniqueFigures& technique = level.techniques.emplace_back();
    technique.choice = choice;
    technique.measurement.frame_ms = {2, 3, 4};
    technique.views.pixels_written = 1;
    technique.views.tally.pixels = 1000;
    level.picture_scenes.push_back(0);
    level.different_shares.push_back(0);
  }
  figures.levels.push_back(level);
  figures.views.push_back({100, std::vector<double>(figures.choices.size(), 2)});
  figures.sizes.push_back({{320, 200}, std::vector<double>(figures.choices.size(), 2)});
  return figures;
}

app::TechniqueFigures& find_technique(app::BookFigures& figures, std::string_view label) {
  return figures.levels.front().techniques[app::Evidence(figures, 0).of(label).number()];
}

app::Verdict judge(const app::BookFigures& figures, std::string_view label) {
  for (const app::BookChapter& chapter : app::list_book_chapters())
    for (const app::BookEntry& entry : chapter.entries)
      if (entry.technique == label) return entry.judge(app::Evidence(figures, 0).of(label));
  ADD_FAILURE() << label;
  return {};
}

TEST(LabBook, VerdictsFollowTheMeasurements) {
  app::BookFigures figures = make_figures();
  EXPECT_EQ(judge(figures, "bsp-edges").holds, app::Holds::kYes);
  figures.levels[0].techniques[0].measurement.frame_ms.p99 = 20;
  EXPECT_EQ(judge(figures, "bsp-edges").holds, app::Holds::kNo) << "ten times the median is not level";

  // The background is written once more.
  find_technique(figures, "painter").views.pixels_written = 2.5;
  const app::Verdict painter = judge(figures, "painter");
  EXPECT_EQ(painter.holds, app::Holds::kYes);
  EXPECT_THAT(painter.text, HasSubstr("Overdraw is 50 %."));
  find_technique(figures, "painter").views.pixels_written = 6;
  EXPECT_EQ(judge(figures, "painter").holds, app::Holds::kNo);

  EXPECT_EQ(judge(figures, "z-buffer").holds, app::Holds::kNo) << "as fast as the engine";
  find_technique(figures, "z-buffer").measurement.frame_ms.p50 = 3;
  EXPECT_EQ(judge(figures, "z-buffer").holds, app::Holds::kPartly);
  find_technique(figures, "z-buffer").measurement.frame_ms.p50 = 20;
  EXPECT_EQ(judge(figures, "z-buffer").holds, app::Holds::kYes);
  EXPECT_THAT(judge(figures, "z-buffer").text, HasSubstr("10.00 times the engine's."));

  find_technique(figures, "independent-edges").views.tally.wrong_face = 5;
  find_technique(figures, "independent-edges").measurement.frame_ms.p50 = 1;
  EXPECT_EQ(judge(figures, "independent-edges").holds, app::Holds::kYes);
  EXPECT_THAT(judge(figures, "independent-edges").text, HasSubstr("Wrong faces: 0.500 % of pixels."));
}

TEST(LabBook, RangesOfLevelsShowBothEnds) {
  app::BookFigures figures = make_figures();
  figures.levels.push_back(figures.levels.front());
  const std::size_t number = app::Evidence(figures, 0).of("painter").number();
  figures.levels[1].techniques[number].measurement.frame_ms.p50 = 5;
  EXPECT_EQ(app::Evidence(figures, number).time_ratios().text(1), "1.0 to 2.5");
  EXPECT_EQ(app::Evidence(figures, 0).time_ratios().text(1), "1.0");
}

TEST(LabBook, PagesAreWellFormedWhateverTheNumbers) {
  app::BookFigures figures = make_figures();
  figures.levels.front().name = "<b>&\"";
  figures.levels.front().techniques[0].measurement.frame_ms.p50 = 0;  // ratios are infinite
  const app::BookOptions options;
  const app::BookInput input{figures, options, "A <fast> processor"};
  EXPECT_EQ(find_markup_fault(app::make_index_page(input)), "");
  for (const app::BookChapter& chapter : app::list_book_chapters())
    EXPECT_EQ(find_markup_fault(app::make_chapter_page(input, chapter)), "") << chapter.file;
}

// All places of the built-in level, or the first one with sanitizers.
app::LabCamera choose_camera() {
  if (!kQuick) return {};
  const app::Viewpoint place = app::list_viewpoints(*app::load_map({}, "").value().level).front();
  return {.position_world = place.eye_world, .angles_deg = place.angles_deg};
}

TEST(LabBook, WritesPagesAndPictures) {
  const TemporaryFolder folder;
  std::vector<app::LabScenes> levels;
  levels.push_back(app::LabScenes::load_level({}, "", choose_camera()).value());
  std::vector<app::LabScenes> model_scenes;
  app::CrowdOptions crowd;
  crowd.count = 3;
  crowd.distance = 200;
  model_scenes.push_back(app::LabScenes::load_level({}, "", {}, crowd).value());
  app::BookOptions options;
  options.size = {64, 48};
  options.step_deg = 360;
  options.settings.threads = 1;
  options.sizes = {{32, 24}, {64, 48}};
  options.grid.distances = {30};
  options.grid.counts = {1, 3};
  options.card = {.sizes = {{32, 24}}, .megabytes = {2}, .step_deg = 360, .seconds = 0.01};
  const std::filesystem::path book = folder.path() / "new" / "book";
  const app::WireResults wire =
      app::measure_wire({.latency_ms = {200, 200}, .seconds = 5, .map = {}}, {}).value();
  ASSERT_TRUE(app::write_book(book, levels, model_scenes, wire, options));
  const std::string index = read_text(book / "index.html");
  EXPECT_EQ(find_markup_fault(index), "");
  EXPECT_THAT(index, HasSubstr("href=\"space.html\""));
  EXPECT_TRUE(std::filesystem::exists(book / "space.html"));
  EXPECT_THAT(index, HasSubstr("href=\"wire.html\""));
  EXPECT_TRUE(std::filesystem::exists(book / "wire.html"));
  EXPECT_THAT(index, HasSubstr("href=\"card.html\""));
  const std::string cards = read_text(book / "card.html");
  EXPECT_EQ(find_markup_fault(cards), "");
  const bool has_gl = cards.find("Not measured: ") == std::string::npos;
  for (const app::CardMethod& method : app::list_card_methods()) {
    if (!has_gl) continue;
    EXPECT_THAT(cards, HasSubstr("src=\"" + app::card_picture_name(method)));
    EXPECT_EQ(read_png(book / app::card_picture_name(method)).width, 3u * 640) << method.name;
  }
  EXPECT_THAT(index, HasSubstr("14 ms, 56 ms at 18 ticks per second, 97 ms at 10 ticks per second"));
  EXPECT_THAT(index, HasSubstr("several hundred milliseconds</td><td class=\"n\">403 ms"));
  for (const app::BookChapter& chapter : app::list_book_chapters()) {
    const std::string file = std::string(chapter.file) + ".html";
    EXPECT_THAT(index, HasSubstr("href=\"" + file));
    const std::string page = read_text(book / file);
    EXPECT_EQ(find_markup_fault(page), "") << file;
    EXPECT_THAT(page, Not(HasSubstr("nan"))) << file;
    for (const app::BookEntry& entry : chapter.entries) {
      if (entry.technique == "bsp-edges") continue;
      const std::string picture = app::picture_file_name(entry.technique);
      EXPECT_THAT(page, HasSubstr("src=\"" + picture));
      EXPECT_EQ(read_png(book / picture).width, 3u * 640) << picture;
      const std::string film = app::film_file_name(entry.technique);
      EXPECT_EQ(page.find("src=\"" + film) != std::string::npos, entry.has_film) << film;
      if (entry.has_film) {
        EXPECT_EQ(read_png(book / film).width, 2u * 320) << film;
      }
    }
  }
}

// With a limit of nothing, only the first number of models is drawn.
TEST(LabBook, GridLeavesOutLongFrames) {
  app::CrowdOptions crowd;
  crowd.count = 1;
  const app::LabScenes scenes = app::LabScenes::load_level({}, "", {}, crowd).value();
  const std::vector<lab::Choice> choices{lab::parse_choice("affine-models").value(),
                                         lab::parse_choice("models-in-edges:triangles=1000").value()};
  app::GridOptions options;
  options.size = {64, 48};
  options.settings.threads = 1;
  options.distances = {30, 100};
  options.counts = {1, 2, 5};
  using State = app::GridCell::State;
  const auto states = [&](std::size_t technique) {
    std::vector<State> found;
    const app::ModelGrid grid = app::measure_model_grid(scenes, choices, options);
    for (const app::GridCell& cell : grid.techniques[technique]) found.push_back(cell.state);
    return found;
  };
  EXPECT_EQ(states(1), (std::vector{State::kMeasured, State::kMeasured, State::kRefused, State::kMeasured,
                                    State::kMeasured, State::kRefused}));
  options.frame_limit_s = 0;
  EXPECT_EQ(states(0), (std::vector{State::kMeasured, State::kTooLong, State::kTooLong, State::kMeasured,
                                    State::kTooLong, State::kTooLong}));
  options.frame_limit_s = 10;
  options.technique_limit_s = 0;
  EXPECT_EQ(states(0)[1], State::kNoTimeLeft);
}

TEST(LabBook, GridShowsTimesAndReasons) {
  const std::vector<lab::Choice> choices{lab::parse_choice("affine-models").value()};
  const app::ModelGrid grid{{30},
                            {1, 10, 100, 1000},
                            {{{app::GridCell::State::kMeasured, 1.25},
                              {app::GridCell::State::kTooLong, 12'345},
                              {app::GridCell::State::kNoTimeLeft, 5},
                              {app::GridCell::State::kRefused, 0}}},
                            3};
  const std::string section = app::make_grid_section(grid, choices);
  for (const char* const cell : {">1.2<", ">– (12 s)<", ">– (time)<", ">– (refused)<", ">affine-models<"})
    EXPECT_THAT(section, HasSubstr(cell));
}

TEST(LabBook, ShowsTheSpaceBattle) {
  const TemporaryFolder folder;
  ASSERT_TRUE(app::write_space_page(folder.path(), {64, 48}));
  const std::string page = read_text(folder.path() / "space.html");
  EXPECT_EQ(find_markup_fault(page), "");
  EXPECT_THAT(page, Not(HasSubstr("nan")));
  EXPECT_THAT(page, HasSubstr("<span class=\"good\">holds</span>"));
  EXPECT_THAT(page, HasSubstr("never touch, convex and concave, 0.00 % of pixels"));
  EXPECT_THAT(page, Not(HasSubstr("that intersect, 0.00 %")));
  for (const char* const picture : {"convex", "concave", "10000", "crowded", "intersecting"}) {
    const std::string file = std::string("space-") + picture + ".png";
    EXPECT_THAT(page, HasSubstr("src=\"" + file));
    EXPECT_EQ(read_png(folder.path() / file).width, 640u) << picture;
  }
  EXPECT_NE(read_png(folder.path() / "space-crowded.png"),
            read_png(folder.path() / "space-intersecting.png"));
}

TEST(LabSchool, ListsLessonsAndWritesThem) {
  const TemporaryFolder folder;
  const ProgramRun list = run_program(folder.path(), {"lab", "school"});
  EXPECT_EQ(list.exit_status, 0);
  EXPECT_THAT(list.out, HasSubstr("spans: Scan conversion\n"));
  const ProgramRun run = run_program(folder.path(), {"lab", "school", "-o", "pages"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(find_markup_fault(read_text(folder.path() / "pages" / "school.html")), "");
  EXPECT_EQ(read_png(folder.path() / "pages" / "school-depth.png").width, 640u);
  folder.write("file", "a file");
  EXPECT_EQ(run_program(folder.path(), {"lab", "school", "-o", "file"}).exit_status, 1);
}

TEST(LabBook, ShowsTheWire) {
  const TemporaryFolder folder;
  app::WireOptions options;
  options.seconds = 5;
  if (kQuick) options.latency_ms = {200, 200};
  const app::WireResults results = app::measure_wire(options, {}).value();
  ASSERT_TRUE(app::write_wire_page(folder.path(), results));
  const std::string page = read_text(folder.path() / "wire.html");
  EXPECT_EQ(find_markup_fault(page), "");
  EXPECT_THAT(page, Not(HasSubstr("nan")));
  EXPECT_THAT(page, HasSubstr("<span class=\"good\">holds</span>"));
  EXPECT_THAT(page, HasSubstr("freezes the world for 403 ms if everything is reliable, and for 14 ms"));
  for (const lab::wire::MethodInfo& info : lab::wire::list_methods())
    EXPECT_THAT(page, HasSubstr("<h3>" + std::string(info.title)));
}

// The book and its readers know where to find each lesson.
TEST(LabSchool, LessonsNameFunctionsThatExist) {
  for (const lab::school::Lesson& lesson : lab::school::list_lessons())
    EXPECT_THAT(read_text(std::filesystem::path(TEMBLOR_SOURCE_DIR) / "src/lab/school" / lesson.file),
                HasSubstr(std::string(lesson.function) + "("))
        << lesson.name;
}

TEST(LabBook, SaysWhyItCannotBeWritten) {
  const TemporaryFolder folder;
  folder.write("book", "a file");
  const auto book = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"lab", "book"});
    return run_program(folder.path(), words);
  };
  const ProgramRun file = book({"-o", "book"});
  EXPECT_EQ(file.exit_status, 1);
  EXPECT_THAT(file.err, HasSubstr("temblor: book: "));
  EXPECT_EQ(std::ranges::count(file.err, '\n'), 1);
  const ProgramRun nowhere = book({});
  EXPECT_EQ(nowhere.exit_status, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("--output"));
  const ProgramRun level = book({"-o", "pages", "--map", "./missing.bsp"});
  EXPECT_EQ(level.exit_status, 1);
  EXPECT_THAT(level.err, HasSubstr("missing.bsp"));
}

TEST(Plots, TicksCoverTheirRange) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const double low = std::pow(10, random.uniform(-4, 6));
    const double factor = std::pow(10, random.uniform(0.01, 6));
    const double high = low * factor;
    for (const app::Axis axis : {app::Axis::kLinear, app::Axis::kLogarithmic}) {
      const std::vector<double> ticks = app::choose_ticks(low, high, axis);
      ASSERT_LE(ticks.front(), low * (1 + 1e-9)) << low << " to " << high;
      ASSERT_GE(ticks.back(), high * (1 - 1e-9)) << low << " to " << high;
      ASSERT_TRUE(std::ranges::is_sorted(ticks));
      ASSERT_GE(ticks.size(), 2u);
      ASSERT_LE(ticks.size(), 12u) << low << " to " << high;
    }
  }
}

TEST(Plots, LeaveOutWhatAnAxisCannotShow) {
  app::Plot plot;
  plot.y_axis = app::Axis::kLogarithmic;
  plot.series = {{"a", {{1, 1}, {2, 0}, {3, -1}, {4, NAN}, {5, 10}}}};
  const std::string svg = app::draw_plot(plot);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_EQ(find_markup_fault("<!DOCTYPE html>\n" + svg), "");
  EXPECT_EQ(find_markup_fault("<!DOCTYPE html>\n" + app::draw_plot({})), "") << "no series at all";
}

}  // namespace
}  // namespace temblor::test
