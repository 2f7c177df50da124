// Yoshida 2022, Figs. 5 and 6: which pairs of end curvatures have a curve of monotone curvature, and who finds it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/random_g2.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/region.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "schemes/intrinsic/viable_region.hpp"

namespace kappabench {
namespace {

using namespace yoshida;
using namespace intrinsic;
using study::count_of, study::Findings, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table,
    study::Tally;

constexpr std::string_view about =
    "With theta_e = pi/9 and theta_d = pi/3 every point of a grid of end curvatures is tried with the knots and p of "
    "Fig. 6(a) to (e) and with the automatic family, which moves its knots (schemes/intrinsic/README.md); a point "
    "counts as covered when the curve found has monotone curvature. Eq. (12) is taken as printed and with the factor "
    "kappa_s that its numerator lacks, which makes it the condition that the osculating circles at the ends nest. The "
    "independent check of that: no fixed family may find a monotone curve outside, and the ends of any curve with "
    "rising curvature must lie inside. The automatic family is tried on random data of eight kinds, too.";

// ---- what is measured

/// Unless the plan says otherwise.
constexpr long data_of_a_kind = 1000, infeasible_data = 400, random_spirals = 5000;

const Quantity spirals = count_of("spirals"), spirals_inside = count_of("spirals inside");
const Quantity spirals_with_chord_4 = count_of("spirals with chord 4"), by_division = count_of("inside by division"),
               by_multiplication = count_of("inside by multiplication");

/// Eq. (12) without the factor kappa_s of the numerator's second term.
double least_as_printed(const StandardData& angles, double start) {
  const double room = 2.0 * std::sin(angles.chord_angle) - start;
  return (2.0 * (1.0 - std::cos(angles.turning)) - 2.0 * std::sin(angles.end_angle())) / room;
}
bool satisfies_as_printed(const StandardData& angles, double start, double end) {
  return 2.0 * std::sin(angles.chord_angle) - start > 0.0 && end > least_as_printed(angles, start);
}
bool satisfies_corrected(const StandardData& angles, double start, double end) {
  return end > least_end_curvature(angles.chord_angle, angles.turning, start);
}

void measure_region(const Uses& uses, Notes& notes) {
  const Window& window = *std::ranges::find(windows(), uses.words.at("window"), &Window::name);
  put_region(covered_region(angles_of_figure_6(), window, static_cast<int>(uses.numbers.at("side")),
                            settings_of(uses.words.at("family"))),
             notes);
}

void measure_spirals(const Uses& uses, Notes& notes) {
  Tally inside, divided, multiplied;
  const auto n = static_cast<std::uint64_t>(uses.numbers.at("spirals"));
  for (std::uint64_t i = 0; i < n; ++i) {
    const StandardData data = random_spiral(uses.seed, i).data;
    inside.add(viability(data).viable());
    // What Eq. (12) is stated for, and a chord of 4: all curvatures are a quarter.
    const bool stated =
        *data.start_curvature >= 0.0 && data.chord_angle > 0.0 && data.end_angle() < 0.5 * std::numbers::pi;
    if (!stated) continue;
    constexpr double chord = 4.0;
    const double start = *data.start_curvature / chord, end = *data.end_curvature / chord;
    divided.add(satisfies_corrected(data, start / chord, end / chord));
    multiplied.add(satisfies_corrected(data, start * chord, end * chord));
  }
  notes.row({}, {spirals(inside.cases), spirals_inside(inside.agree), spirals_with_chord_4(divided.cases),
                 by_division(divided.agree), by_multiplication(multiplied.agree)});
}

std::vector<CellJob> jobs(const Context& context) {
  // A grid of 0 points is each window's own.
  const std::vector<long> amount = amounts(
      context, "intrinsic-viable-region",
      {{"grid", 0}, {"random-g2", data_of_a_kind}, {"infeasible", infeasible_data}, {"spirals", random_spirals}});
  const auto grid = static_cast<int>(amount[0]);
  const SchemePtr scheme = context.registry.create("intrinsic");
  std::vector<CellJob> jobs;
  for (const Window& window : windows()) {
    const auto add = [&](std::string_view family, int side) {
      jobs.push_back(study::numbers_job<measure_region>(
          {.work = "region",
           .schemes = {scheme},
           .numbers = {{"side", grid > 0 ? grid : side}},
           .words = {{"window", std::string(window.name)}, {"family", std::string(family)}}},
          std::string(window.name), std::string(family)));
    };
    for (const FixedFamily& family : families_of_figure_6()) add(family.title, window.side_fixed);
    add(automatic, window.side_automatic);
  }
  const auto uses = [&](std::string work, std::map<std::string, double> numbers) {
    return Uses{.work = std::move(work), .schemes = {scheme}, .seed = context.seed, .numbers = std::move(numbers)};
  };
  for (const Kind kind : all_kinds)
    for (const auto& [from, to] : parts_of(amount[1])) {
      Uses data = uses("viable data", {{"from", static_cast<double>(from)}, {"to", static_cast<double>(to)}});
      data.words["kind"] = name(kind);
      jobs.push_back(study::numbers_job<measure_kind>(std::move(data), std::string(name(kind)),
                                                      fmt::format("data {} to {}, seed {}", from, to, context.seed)));
    }
  jobs.push_back(study::numbers_job<measure_infeasible>(
      uses("infeasible data", {{"data", static_cast<double>(amount[2])}}), "outside the region"));
  jobs.push_back(study::numbers_job<measure_spirals>(
      uses("random spirals", {{"spirals", static_cast<double>(amount[3])}}), "spirals"));
  return jobs;
}

// ---- what follows

/// What each family covers of a window, and all fixed ones together.
struct Coverage {
  std::vector<std::pair<std::string, Region>> families;
  Region united, without_bezier;  ///< of the fixed ones, and of those but (a)
  Region automatic;
};

Coverage coverage(const Findings& found, const Window& window) {
  const Rows here = found.rows().where({study::key::dataset(window.name)});
  const auto by = [&here](std::string_view family) { return region_of(here.where({study::key::label(family)})); };
  Coverage covered;
  for (const FixedFamily& family : families_of_figure_6()) {
    const Region region = by(family.title);
    if (region.side == 0) continue;
    covered.united = united(covered.united, region);
    if (!covered.families.empty()) covered.without_bezier = united(covered.without_bezier, region);
    covered.families.emplace_back(std::string(family.title), region);
  }
  covered.automatic = by(automatic);
  return covered;
}

Table coverage_table(const Findings& found) {
  Table table("coverage", "What each choice of knots and p covers",
              "theta_e = pi/9, theta_d = pi/3. Viable: grid points inside the corrected Eq. (12); monotone: of "
              "these, those with a monotone solution; outside: monotone solutions at other points; unsolved: "
              "viable points at which the solver does not converge.");
  table.words("curvatures").words("family").counts("side").counts("viable").counts("monotone").numbers("share");
  table.counts("unsolved").counts("outside");
  for (const Window& window : windows()) {
    const Coverage covered = coverage(found, window);
    const auto row = [&](std::string_view family, const Region& region) {
      if (region.side == 0) return;
      table.row({window.name, family, region.side, region.viable, region.inside_count(),
                 region.inside_count() / region.viable, region.unsolved, region.outside_count()});
    };
    for (const auto& [family, region] : covered.families) row(family, region);
    row("(a) to (e) together", covered.united);
    row(automatic, covered.automatic);
  }
  return table;
}

/// Fig. 5: the border of Eq. (12) for start curvatures from 0 to where it leaves the picture.
Table border_table() {
  constexpr int steps = 40;
  constexpr double highest = 6.0;
  const StandardData angles = angles_of_figure_5();
  const double limit = 2.0 * std::sin(angles.chord_angle);
  Table table("border", "The border of the viable region",
              "theta_e = 7 pi/36, theta_d = 4 pi/9: least end curvature for a start curvature, by Eq. (12) as "
              "printed and with the missing factor.");
  table.words("equation").numbers("start curvature").numbers("least end curvature");
  for (const bool printed : {false, true})
    for (int i = 0; i < steps; ++i) {
      // Closer together where the border rises.
      const double left = 1.0 - static_cast<double>(i) / steps, start = limit * (1.0 - left * left);
      const double least =
          printed ? least_as_printed(angles, start) : least_end_curvature(angles.chord_angle, angles.turning, start);
      if (least <= highest) table.row({printed ? "as printed" : "corrected", start, least});
    }
  return table;
}

/// The covered points of the paper's window, thinned, with the border.
Table region_table(const std::string& id, const std::string& family, const Region& region) {
  const Window& window = windows().front();
  const StandardData angles = angles_of_figure_6();
  Table table(id, fmt::format("Region of {}", family),
              "Points of the grid with a monotone solution, every second one, and the border of Eq. (12).");
  table.words("what").numbers("start curvature").numbers("end curvature");
  for (int i = 0; i < region.side; i += 2)
    for (int j = 0; j < region.side; j += 2)
      if (region.at(i, j)) {
        const auto [start, end] = window.point(i, j, region.side);
        table.row({"monotone curvature", start, end});
      }
  constexpr int steps = 100;
  for (int i = 0; i < steps; ++i) {
    const double left = 1.0 - static_cast<double>(i) / steps;
    const double start = window.start_to - (window.start_to - window.start_from) * left * left;
    const double least = least_end_curvature(angles.chord_angle, angles.turning, start);
    if (least <= window.end_to) table.row({"border, Eq. (12) corrected", start, least});
  }
  return table;
}

store::FigureRecord border_figure() {
  return {.id = "border",
          .title = "The border of the viable region",
          .caption =
              "Curvature can rise from start to end above the hyperbola. As printed, Eq. (12) lets in end "
              "curvatures for which there is no such curve.",
          .columns = 1,
          .panels = {
              Panel::graph("border", "start curvature", {"least end curvature"}, "theta_e = 7 pi/36, theta_d = 4 pi/9")
                  .labels("", "")
                  .series("equation")}};
}

/// The figure, and a table for each of its panels.
void add_regions(Findings& found) {
  store::FigureRecord figure{.id = "regions",
                             .title = "Where a monotone curve is found",
                             .caption =
                                 "Points of a grid of end curvatures with a monotone solution, for the fixed "
                                 "knots and p of Fig. 6 and for the automatic family; theta_e = pi/9, theta_d = "
                                 "pi/3. Shares of the viable points.",
                             .columns = 3,
                             .panels = {}};
  char letter = 'a';
  const auto show = [&](std::string_view family, const Region& region) {
    if (region.side == 0) return;
    const std::string id = fmt::format("region-{}", letter++);
    found.add(region_table(id, std::string(family), region));
    // The figure has letters of its own, the same ones.
    if (family.starts_with('(')) family.remove_prefix(4);
    figure.panels.push_back(
        Panel::graph(id, "start curvature", {"end curvature"},
                     fmt::format("{}: {:.3g} %", family, 100.0 * region.inside_count() / region.viable))
            .labels("", "")
            .series("what")
            .dots());
  };
  const Coverage covered = coverage(found, windows().front());
  for (const auto& [family, region] : covered.families) show(family, region);
  show(automatic, covered.automatic);
  found.add(std::move(figure));
}

void claim_region(Findings& found) {
  const Window& window = windows().front();
  const StandardData angles = angles_of_figure_6();
  const Coverage covered = coverage(found, window);
  const auto curve = [&](int i, int j) {
    const Region &own = covered.automatic, &fixed = covered.united;
    const auto has = [&](const Region& region) { return region.at(i, j) || region.outside[region.index(i, j)] != 0; };
    return has(own) || (fixed.side == own.side && has(fixed));
  };
  Tally as_printed, corrected;  // admitted, and with a monotone curve
  for (int i = 0; i < covered.automatic.side; ++i)
    for (int j = 0; j < covered.automatic.side; ++j) {
      const auto [start, end] = window.point(i, j, covered.automatic.side);
      if (satisfies_as_printed(angles, start, end)) as_printed.add(curve(i, j));
      if (satisfies_corrected(angles, start, end)) corrected.add(curve(i, j));
    }
  const Rows& rows = found.rows();
  const Tally inside{rows.total(spirals_inside), rows.total(spirals)};
  found.judge_formula(
      "monotone-region", as_printed, corrected,
      {fmt::format("a monotone curve at {} points of the grid that Eq. (12) admits", as_printed.words()),
       fmt::format(
           "Corrected, with the factor kappa_s in the numerator: {}. Ends of random curves with rising curvature "
           "inside that region: {}. Random data outside it: a monotone curve by any fixed family for {:.0f} of "
           "{:.0f}, refused by the automatic one: {:.0f}.",
           corrected.words(), inside.words(), rows.total(infeasible_monotone), rows.total(infeasible),
           rows.total(infeasible_refused))});
}

void claim_chord(Findings& found) {
  const Rows& rows = found.rows();
  const double cases = rows.total(spirals_with_chord_4);
  const Tally divided{rows.total(by_division), cases}, multiplied{rows.total(by_multiplication), cases};
  found.judge_formula(
      "curvature-over-chord", divided, multiplied,
      {fmt::format("{} satisfy Eq. (12) with curvatures divided by the chord", divided.words()),
       fmt::format("Curves of rising curvature with a chord of 4, by the corrected equation; with curvatures times the "
                   "chord it holds for {}.",
                   multiplied.words())});
}

void claim_variety(Findings& found) {
  std::vector<std::string> lines;
  Tally more;  // of the viable points that (a) does not reach
  for (const Window& window : windows()) {
    const Coverage covered = coverage(found, window);
    if (covered.families.size() < 2) continue;
    const Region& bezier = covered.families.front().second;
    const double own = bezier.inside_count(), others = covered.without_bezier.inside_count();
    for (std::size_t i = 0; i < bezier.inside.size(); ++i)
      if (bezier.inside[i] == 0 && covered.without_bezier.inside[i] != 0) more.agree += 1.0;
    more.cases += bezier.viable - own;
    lines.push_back(fmt::format("{}: {:.3g} % by (a), {:.3g} % by (b) to (e)", window.name, 100.0 * own / bezier.viable,
                                100.0 * others / bezier.viable));
  }
  found.judge("more-with-b-splines", more,
              {fmt::format("{}", fmt::join(lines, "; ")),
               fmt::format("Shares of the viable points of the grids with a monotone solution; (b) to (e) reach {} of "
                           "those that (a) does not.",
                           more.words())});
}

void claim_any(Findings& found) {
  const double random = found.rows().total(kind_data);
  Tally solved{found.rows().total(kind_monotone), random};
  for (const Window& window : windows()) {
    const Region region = coverage(found, window).automatic;
    solved += {region.inside_count(), region.viable};
  }
  found.judge(
      "any-g2-data", solved,
      {fmt::format("{} viable data by the automatic family", solved.words()),
       fmt::format("{:.0f} random data of eight kinds and the viable points of {} grids; data without a solution "
                   "are misses. With the knots and p of Fig. 6 it is not so; on the border itself, where only a "
                   "step of curvature is left, there is no cubic B-spline.",
                   random, windows().size()),
       "knots moved automatically (ours) instead of by hand"});
}

void conclude(Findings& found) {
  found.add(coverage_table(found));
  found.add(kind_table(found));
  found.add(kind_seconds_table(found));
  found.add(kind_failure_table(found));
  found.add(border_table());
  found.add(border_figure());
  add_regions(found);
  claim_region(found);
  claim_chord(found);
  claim_variety(found);
  claim_any(found);
}

}  // namespace

Experiment intrinsic_viable_region_experiment() {
  return study::experiment({.id = "intrinsic-viable-region",
                            .title = "The viable region of G2 data (Yoshida 2022, Figs. 5 and 6)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"monotone-region", "curvature-over-chord", "more-with-b-splines", "any-g2-data"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
