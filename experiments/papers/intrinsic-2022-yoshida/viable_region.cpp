#include "experiments/run/experiment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/random_g2.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/region.hpp"
#include "experiments/study/summaries.hpp"
#include "schemes/intrinsic/viable_region.hpp"

namespace kappabench {

using namespace yoshida;
using namespace intrinsic;

namespace {

constexpr std::string_view about =
    "With theta_e = pi/9 and theta_d = pi/3 every point of a grid of end curvatures is tried with the knots and p of "
    "Fig. 6(a) to (e) and with the automatic family, which moves its knots (schemes/intrinsic/README.md); a point "
    "counts as covered when the curve found has monotone curvature. Eq. (12) is taken as printed and with the factor "
    "kappa_s that its numerator lacks, which makes it the condition that the osculating circles at the ends nest. The "
    "independent check of that: no fixed family may find a monotone curve outside, and the ends of any curve with "
    "rising curvature must lie inside. The automatic family is tried on random data of eight kinds, too.";

constexpr int version = 1;
/// Unless the plan says otherwise.
constexpr long data_of_a_kind = 1000, infeasible_data = 400, random_spirals = 5000;

std::string automatic_title() { return "automatic"; }

/// Eq. (12) without the factor kappa_s of the numerator's second term.
bool satisfies_as_printed(const StandardData& angles, double start, double end) {
  const double room = 2.0 * std::sin(angles.chord_angle) - start;
  return room > 0.0 && end > (2.0 * (1.0 - std::cos(angles.turning)) - 2.0 * std::sin(angles.end_angle())) / room;
}
bool satisfies_corrected(const StandardData& angles, double start, double end) {
  return end > least_end_curvature(angles.chord_angle, angles.turning, start);
}

void measure_spirals(std::uint64_t seed, long n, store::CellRecord& cell) {
  std::array<double, 5> count{};
  for (long i = 0; i < n; ++i) {
    const StandardData data = random_spiral(seed, static_cast<std::uint64_t>(i)).data;
    count[0] += 1.0;
    count[1] += viability(data).viable() ? 1.0 : 0.0;
    // What Eq. (12) is stated for, and a chord of 4: all curvatures are a quarter.
    const bool stated =
        *data.start_curvature >= 0.0 && data.chord_angle > 0.0 && data.end_angle() < 0.5 * std::numbers::pi;
    if (!stated) continue;
    constexpr double chord = 4.0;
    const double start = *data.start_curvature / chord, end = *data.end_curvature / chord;
    count[2] += 1.0;
    count[3] += satisfies_corrected(data, start / chord, end / chord) ? 1.0 : 0.0;
    count[4] += satisfies_corrected(data, start * chord, end * chord) ? 1.0 : 0.0;
  }
  study::put(cell, "spirals", count[0]);
  study::put(cell, "spirals inside", count[1]);
  study::put(cell, "spirals with chord 4", count[2]);
  study::put(cell, "inside by division", count[3]);
  study::put(cell, "inside by multiplication", count[4]);
}

std::vector<CellJob> jobs(const Context& context) {
  // A grid of 0 points is each window's own.
  const std::vector<long> amount = amounts(
      context, "intrinsic-viable-region",
      {{"grid", 0}, {"random-g2", data_of_a_kind}, {"infeasible", infeasible_data}, {"spirals", random_spirals}});
  const long grid = amount[0], data = amount[1], outside = amount[2], spirals = amount[3];
  const SchemePtr scheme = context.registry.create("intrinsic");
  const std::uint64_t seed = context.seed;
  std::vector<CellJob> jobs;
  for (const Window& window : windows()) {
    const auto add = [&](const std::string& title, const Settings& settings, int side) {
      const int points = grid > 0 ? static_cast<int>(grid) : side;
      jobs.push_back(numbers_job(scheme, std::string(window.name), fmt::format("{}, grid of {}", title, points),
                                 version, [window, settings, points](store::CellRecord& cell) {
                                   put_region(covered_region(angles_of_figure_6(), window, points, settings), cell);
                                 }));
      jobs.back().label = title;
    };
    for (const FixedFamily& family : families_of_figure_6())
      add(std::string(family.title), family.settings(), window.side_fixed);
    add(automatic_title(), Settings{}, window.side_automatic);
  }
  constexpr long part = 5000;
  for (const Kind kind : all_kinds)
    for (long from = 0; from < data; from += part) {
      const long to = std::min(from + part, data);
      jobs.push_back(
          numbers_job(scheme, std::string(name(kind)), fmt::format("data {} to {}, seed {}", from, to, seed), version,
                      [kind, seed, from, to](store::CellRecord& cell) { measure_kind(kind, seed, from, to, cell); }));
    }
  jobs.push_back(numbers_job(scheme, "outside the region", fmt::format("{} infeasible data, seed {}", outside, seed),
                             version,
                             [seed, outside](store::CellRecord& cell) { measure_infeasible(seed, outside, cell); }));
  jobs.push_back(numbers_job(scheme, "spirals", fmt::format("{} random spirals, seed {}", spirals, seed), version,
                             [seed, spirals](store::CellRecord& cell) { measure_spirals(seed, spirals, cell); }));
  return jobs;
}

// ---- conclusions

const store::CellRecord* region_cell(const store::ExperimentRecord& record, const Window& window,
                                     std::string_view title) {
  for (const store::CellRecord& cell : record.cells)
    if (cell.dataset == window.name && cell.label == title) return &cell;
  return nullptr;
}

/// What each family covers of a window, and all fixed ones together.
struct Coverage {
  std::vector<std::pair<std::string, Region>> families;
  Region united, without_bezier;  ///< of the fixed ones, and of those but (a)
  Region automatic;
};

Coverage coverage(const store::ExperimentRecord& record, const Window& window) {
  Coverage found;
  for (const FixedFamily& family : families_of_figure_6())
    if (const auto* cell = region_cell(record, window, family.title)) {
      const Region region = region_of(*cell);
      found.united = united(found.united, region);
      if (!found.families.empty()) found.without_bezier = united(found.without_bezier, region);
      found.families.emplace_back(std::string(family.title), region);
    }
  if (const auto* cell = region_cell(record, window, automatic_title())) found.automatic = region_of(*cell);
  return found;
}

store::TableRecord coverage_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "coverage", "What each choice of knots and p covers",
      "theta_e = pi/9, theta_d = pi/3. Viable: grid points inside the corrected Eq. (12); monotone: of "
      "these, those with a monotone solution; outside: monotone solutions at other points; unsolved: "
      "viable points at which the solver does not converge.");
  builder.words("curvatures").words("family").counts("side").counts("viable").counts("monotone").numbers("share");
  builder.counts("unsolved").counts("outside");
  for (const Window& window : windows()) {
    const Coverage found = coverage(record, window);
    const auto row = [&](const std::string& family, const Region& region) {
      if (region.side == 0) return;
      builder.row({std::string(window.name), family, static_cast<double>(region.side), region.viable,
                   region.inside_count(), region.inside_count() / region.viable, region.unsolved,
                   region.outside_count()});
    };
    for (const auto& [family, region] : found.families) row(family, region);
    row("(a) to (e) together", found.united);
    row(automatic_title(), found.automatic);
  }
  return builder.table();
}

/// Fig. 5: the border of Eq. (12) for start curvatures from 0 to where it leaves the picture.
store::TableRecord border_table() {
  constexpr int steps = 40;
  constexpr double highest = 6.0;
  const StandardData angles = angles_of_figure_5();
  const double limit = 2.0 * std::sin(angles.chord_angle);
  TableBuilder builder("border", "The border of the viable region",
                       "theta_e = 7 pi/36, theta_d = 4 pi/9: least end curvature for a start curvature, by Eq. (12) as "
                       "printed and with the missing factor.");
  builder.words("equation").numbers("start curvature").numbers("least end curvature");
  for (const bool printed : {false, true})
    for (int i = 0; i < steps; ++i) {
      // Closer together where the border rises.
      const double left = 1.0 - static_cast<double>(i) / steps, start = limit * (1.0 - left * left);
      const double least =
          printed ? (2.0 * (1.0 - std::cos(angles.turning)) - 2.0 * std::sin(angles.end_angle())) / (limit - start)
                  : least_end_curvature(angles.chord_angle, angles.turning, start);
      if (least <= highest) builder.row({std::string(printed ? "as printed" : "corrected"), start, least});
    }
  return builder.table();
}

std::string region_table_id(std::size_t i) { return fmt::format("region-{}", static_cast<char>('a' + i)); }

/// The covered points of the paper's window, thinned, with the border.
store::TableRecord region_table(const std::string& id, const std::string& family, const Region& region) {
  const Window& window = windows().front();
  const StandardData angles = angles_of_figure_6();
  TableBuilder builder(id, fmt::format("Region of {}", family),
                       "Points of the grid with a monotone solution, every second one, and the border of Eq. (12).");
  builder.words("what").numbers("start curvature").numbers("end curvature");
  for (int i = 0; i < region.side; i += 2)
    for (int j = 0; j < region.side; j += 2)
      if (region.at(i, j)) {
        const auto [start, end] = window.point(i, j, region.side);
        builder.row({"monotone curvature", start, end});
      }
  constexpr int steps = 100;
  for (int i = 0; i < steps; ++i) {
    const double left = 1.0 - static_cast<double>(i) / steps;
    const double start = window.start_to - (window.start_to - window.start_from) * left * left;
    const double least = least_end_curvature(angles.chord_angle, angles.turning, start);
    if (least <= window.end_to) builder.row({"border, Eq. (12) corrected", start, least});
  }
  return builder.table();
}

store::FigureRecord border_figure() {
  store::PanelRecord panel{.kind = "graph", .title = "theta_e = 7 pi/36, theta_d = 4 pi/9"};
  panel.table = "border";
  panel.x = "start curvature";
  panel.y = {"least end curvature"};
  panel.series = "equation";
  return {.id = "border",
          .title = "The border of the viable region",
          .caption =
              "Curvature can rise from start to end above the hyperbola. As printed, Eq. (12) lets in end "
              "curvatures for which there is no such curve.",
          .columns = 1,
          .panels = {panel}};
}

store::FigureRecord region_figure(const std::vector<std::string>& families) {
  store::FigureRecord figure{.id = "regions",
                             .title = "Where a monotone curve is found",
                             .caption =
                                 "Points of a grid of end curvatures with a monotone solution, for the fixed "
                                 "knots and p of Fig. 6 and for the automatic family; theta_e = pi/9, theta_d = "
                                 "pi/3. Shares of the viable points.",
                             .columns = 3,
                             .panels = {}};
  for (std::size_t i = 0; i < families.size(); ++i) {
    store::PanelRecord panel{.kind = "graph", .title = families[i]};
    // The figure has letters of its own, the same ones.
    if (panel.title.starts_with('(')) panel.title.erase(0, 4);
    panel.table = region_table_id(i);
    panel.x = "start curvature";
    panel.y = {"end curvature"};
    panel.series = "what";
    panel.lines = false;
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

store::ClaimRecord region_claim(const store::ExperimentRecord& record) {
  const Window& window = windows().front();
  const StandardData angles = angles_of_figure_6();
  const Coverage found = coverage(record, window);
  double printed = 0.0, without = 0.0, corrected = 0.0, corrected_without = 0.0;
  for (int i = 0; i < found.automatic.side; ++i)
    for (int j = 0; j < found.automatic.side; ++j) {
      const auto [start, end] = window.point(i, j, found.automatic.side);
      const bool curve =
          found.automatic.at(i, j) || (found.united.side == found.automatic.side && found.united.at(i, j));
      if (satisfies_as_printed(angles, start, end)) {
        printed += 1.0;
        without += curve ? 0.0 : 1.0;
      }
      if (satisfies_corrected(angles, start, end)) {
        corrected += 1.0;
        corrected_without += curve ? 0.0 : 1.0;
      }
    }
  const double outside = study::total(record, "infeasible"),
               found_outside = study::total(record, "infeasible with a monotone curve");
  return claim(
      "monotone-region", study::verdict_for_all(without, printed),
      fmt::format("no monotone curve at {} points of the grid that Eq. (12) admits", study::share(without, printed)),
      fmt::format(
          "With the factor kappa_s in the numerator: {}. Ends of random curves with rising curvature inside that "
          "region: {}. Random data outside it: a monotone curve by any fixed family for {:.0f} of {:.0f}, "
          "refused by the automatic one: {:.0f}.",
          study::share(corrected_without, corrected),
          study::share(study::total(record, "spirals inside"), study::total(record, "spirals")), found_outside, outside,
          study::total(record, "infeasible refused")));
}

store::ClaimRecord chord_claim(const store::ExperimentRecord& record) {
  const double cases = study::total(record, "spirals with chord 4"),
               divided = study::total(record, "inside by division");
  return claim("curvature-over-chord", study::verdict_for_all(cases - divided, cases),
               fmt::format("{} satisfy Eq. (12) with curvatures divided by the chord", study::share(divided, cases)),
               fmt::format("Curves of rising curvature with a chord of 4, by the corrected equation; with curvatures "
                           "times the chord it holds for {}.",
                           study::share(study::total(record, "inside by multiplication"), cases)));
}

store::ClaimRecord variety_claim(const store::ExperimentRecord& record) {
  std::vector<std::string> lines;
  double more = 0.0, cases = 0.0;
  for (const Window& window : windows()) {
    const Coverage found = coverage(record, window);
    if (found.families.size() < 2) continue;
    const Region& bezier = found.families.front().second;
    const double own = bezier.inside_count(), others = found.without_bezier.inside_count();
    cases += 1.0;
    more += others > own ? 1.0 : 0.0;
    lines.push_back(fmt::format("{}: {:.3g} % by (a), {:.3g} % by (b) to (e)", window.name, 100.0 * own / bezier.viable,
                                100.0 * others / bezier.viable));
  }
  return claim("more-with-b-splines", study::verdict_for_all(cases - more, cases),
               fmt::format("{}", fmt::join(lines, "; ")),
               "Shares of the viable points of the grids with a monotone solution.");
}

store::ClaimRecord any_claim(const store::ExperimentRecord& record) {
  double cases = study::total(record, "data"), solved = study::total(record, "monotone");
  const double random = cases;
  for (const Window& window : windows()) {
    const Region region = coverage(record, window).automatic;
    cases += region.viable;
    solved += region.inside_count();
  }
  return claim(
      "any-g2-data", study::verdict_for_all(cases - solved, cases),
      fmt::format("{} viable data by the automatic family", study::share(solved, cases)),
      fmt::format("{:.0f} random data of eight kinds and the viable points of {} grids. With the knots and p of "
                  "Fig. 6 it is not so; on the border itself, where only a step of curvature is left, there is "
                  "no cubic B-spline.",
                  random, windows().size()));
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {coverage_table(record), kind_table(record), kind_seconds_table(record), kind_failure_table(record),
                   border_table()};
  const Coverage found = coverage(record, windows().front());
  std::vector<std::string> shown;
  const auto show = [&](const std::string& family, const Region& region) {
    if (region.side == 0) return;
    record.tables.push_back(region_table(region_table_id(shown.size()), family, region));
    shown.push_back(fmt::format("{}: {:.3g} %", family, 100.0 * region.inside_count() / region.viable));
  };
  for (const auto& [family, region] : found.families) show(family, region);
  show(automatic_title(), found.automatic);
  record.figures = {border_figure()};
  if (!shown.empty()) record.figures.push_back(region_figure(shown));
  record.claims = {region_claim(record), chord_claim(record), variety_claim(record), any_claim(record)};
}

}  // namespace

Experiment intrinsic_viable_region_experiment() {
  return {.id = "intrinsic-viable-region",
          .title = "The viable region of G2 data (Yoshida 2022, Figs. 5 and 6)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
