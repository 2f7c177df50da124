#include "reports/figures/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "reports/outcome_words.hpp"

namespace kappabench::figures {
namespace {

/// Okabe and Ito's palette (2008) without yellow, which is faint on white, then darker tones for many schemes.
constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9",
                             "#882255", "#332288", "#999933", "#661100", "#44AA99", "#777777"};
constexpr std::array markers{7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14};

bool wild(const store::CellRecord& cell) {
  return std::any_of(cell.curves.begin(), cell.curves.end(), [](const auto& c) { return !c.warnings.empty(); });
}

bool has_curve(const store::CellRecord& cell) {
  return std::any_of(cell.curves.begin(), cell.curves.end(), [](const auto& c) { return !c.sample_x.empty(); });
}

}  // namespace

void Rows::add(std::initializer_list<double> numbers) {
  if (gap_ && !text_.empty()) text_ += "\n";
  gap_ = false;
  const char* separator = "";
  for (const double number : numbers) {
    text_ += fmt::format("{}{:.9g}", separator, number);
    separator = " ";
  }
  text_ += "\n";
}

void Rows::gap() { gap_ = true; }

std::string DataFile::add(std::string_view comment, const Rows& rows) {
  text_ += fmt::format("{}# {}\n{}", blocks_ > 0 ? "\n\n" : "", comment, rows.text());
  return fmt::format("{} index {}", text_in_gnuplot(name_), blocks_++);
}

void plot(Panel& drawn, DataFile& data, std::string_view comment, const Rows& rows, std::string_view how) {
  if (!rows.text().empty()) drawn.plots.push_back(fmt::format("{} {}", data.add(comment, rows), how));
}

void remark(Panel& drawn, const std::string& text) { drawn.note += (drawn.note.empty() ? "" : "; ") + text; }

std::size_t Key::place(const std::string& label) {
  const auto found = std::find(labels_.begin(), labels_.end(), label);
  const auto index = static_cast<std::size_t>(found - labels_.begin());
  if (found == labels_.end()) labels_.push_back(label);
  return index;
}

std::string Key::colour(const std::string& label) { return palette[place(label) % palette.size()]; }
int Key::marker(const std::string& label) { return markers[place(label) % markers.size()]; }

void Key::add(LegendEntry entry) {
  if (std::find(entries_.begin(), entries_.end(), entry) == entries_.end()) entries_.push_back(std::move(entry));
}

std::vector<const store::CellRecord*> cells_of(const store::PanelRecord& panel, const Context& context) {
  std::vector<const store::CellRecord*> cells;
  for (const int index : panel.cells) {
    if (index < 0 || static_cast<std::size_t>(index) >= context.experiment.cells.size()) {
      throw std::invalid_argument(fmt::format("figure '{}', panel '{}': there is no cell {} among the {} of '{}'",
                                              context.figure.id, panel.title, index, context.experiment.cells.size(),
                                              context.experiment.id));
    }
    cells.push_back(&context.experiment.cells[static_cast<std::size_t>(index)]);
  }
  return cells;
}

std::string label_of(const store::CellRecord& cell) { return cell.label.empty() ? cell.scheme : cell.label; }

std::vector<const store::CurveRecord*> curves_of(const store::PanelRecord& panel, const store::CellRecord& cell) {
  std::vector<const store::CurveRecord*> curves;
  for (std::size_t i = 0; i < cell.curves.size(); ++i) {
    if (panel.curve < 0 || static_cast<std::size_t>(panel.curve) == i) curves.push_back(&cell.curves[i]);
  }
  return curves;
}

std::vector<std::string> enter_cells(const std::vector<const store::CellRecord*>& cells, const Context& context,
                                     Panel& drawn) {
  std::vector<std::string> lines;
  for (const auto* cell : cells) {
    const bool converged = cell->outcome == "converged", curve = has_curve(*cell);
    const bool plain = converged && !wild(*cell);
    const std::string label = label_of(*cell);
    lines.push_back(fmt::format("lw 2.2 lc rgb '{}'{}", context.key.colour(label), converged ? "" : " dt (8,5)"));
    const std::string outcome = plain ? "" : fmt::format(" ({}{})", outcome_words(*cell), curve ? "" : ", no curve");
    if (cells.size() == 1 && drawn.title.empty()) drawn.title = label;
    // Short under a panel; the legend says which one, and the warnings.
    if (cells.size() == 1 && !converged) remark(drawn, curve ? spaced(cell->outcome) : label + outcome);
    const bool told = cells.size() == 1 && (!curve || (plain && drawn.title.find(label) != std::string::npos));
    if (!told) context.key.add({label + outcome, lines.back(), ""});
  }
  return lines;
}

std::string text_in_gnuplot(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += c == '\n' || c == '\r' ? ' ' : c;
  }
  return result + "'";
}

std::string lighter(const std::string& colour, double part_white) {
  std::string result = "#";
  for (const std::size_t place : {1U, 3U, 5U}) {
    const double part = std::stoi(colour.substr(place, 2), nullptr, 16);
    result += fmt::format("{:02X}", static_cast<int>(std::lround(part + (255.0 - part) * part_white)));
  }
  return result;
}

Interval padded(Interval range, double part) {
  const double size = range.size() > 0.0 ? range.size() : std::max(std::abs(range.from), 1.0);
  return {range.from - part * size, range.to + part * size};
}

std::optional<Interval> extent(const std::vector<double>& values) {
  std::optional<Interval> range;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (!range) range = Interval{value, value};
    range = Interval{std::min(range->from, value), std::max(range->to, value)};
  }
  return range;
}

CurvatureLimit curvature_limit(const std::vector<const store::CurveRecord*>& curves, double always_shown) {
  std::vector<std::pair<double, double>> sizes;  // |curvature| and the arc length that has it
  double length = 0.0;
  for (const auto* curve : curves) {
    for (std::size_t i = 0; i < curve->sample_s.size(); ++i) {
      if (!std::isfinite(curve->sample_kappa[i])) continue;
      const double before = curve->sample_s[i == 0 ? 0 : i - 1];
      const double after = curve->sample_s[std::min(i + 1, curve->sample_s.size() - 1)];
      sizes.emplace_back(std::abs(curve->sample_kappa[i]), 0.5 * (after - before));
      length += sizes.back().second;
    }
  }
  if (sizes.empty()) return {};
  std::sort(sizes.begin(), sizes.end());
  double passed = 0.0;
  const auto usual = std::find_if(sizes.begin(), sizes.end(), [&](const auto& size) {
    passed += size.second;
    return passed >= 0.95 * length;
  });
  const double largest = sizes.back().first, quantile = usual == sizes.end() ? largest : usual->first;
  return {std::min(largest, std::max(3.0 * quantile, always_shown)), largest};
}

}  // namespace kappabench::figures
