#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/store/model.hpp"

/// The parts a figure is put together from; used by the sources of this folder only.
namespace kappabench::figures {

/// Rows of numbers, with gaps between polylines.
class Rows {
 public:
  void add(std::initializer_list<double> numbers);
  void gap();  ///< the next row starts another polyline
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  bool gap_ = false;
};

/// The numbers of one panel, in blocks that gnuplot addresses by index.
class DataFile {
 public:
  explicit DataFile(std::string name) : name_(std::move(name)) {}
  /// Adds a block; returns what a plot command calls it: "'name' index 2". The rows may not be empty.
  std::string add(std::string_view comment, const Rows& rows);
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string name_, text_;
  int blocks_ = 0;
};

/// One line of the legend under the figure.
struct LegendEntry {
  std::string text;
  std::string line;   ///< gnuplot line properties, or empty
  std::string point;  ///< gnuplot point properties, or empty
  bool operator==(const LegendEntry&) const = default;
};

/// Colours by label and the legend, shared by all panels of a figure.
class Key {
 public:
  /// "#0072B2", ...; the same for the same label. More labels than colours start over.
  std::string colour(const std::string& label);
  /// The marker of the label (gnuplot point type), so that colour is not the only difference.
  int marker(const std::string& label);
  void add(LegendEntry entry);  ///< once, however often it is added
  [[nodiscard]] const std::vector<LegendEntry>& entries() const { return entries_; }

 private:
  std::size_t place(const std::string& label);
  std::vector<std::string> labels_;
  std::vector<LegendEntry> entries_;
};

struct Interval {
  double from = 0.0, to = 1.0;
  [[nodiscard]] double size() const { return to - from; }
};
struct Box {
  Interval x, y;
};

/// A drawn panel before it has its place.
struct Panel {
  std::string title;
  std::string note;                ///< small print under the panel
  std::vector<std::string> setup;  ///< gnuplot commands
  std::vector<std::string> plots;  ///< elements of the plot command
  Box range;
  bool plane = false;     ///< equal units on both axes and no axes
  bool windowed = false;  ///< a close-up: the range is kept exactly, with a thin frame
  double aspect = 0.72;   ///< height over width that suits it
};

/// Adds rows to the data and an element to the plot command; nothing for no rows.
void plot(Panel& drawn, DataFile& data, std::string_view comment, const Rows& rows, std::string_view how);
/// Joins a remark to the small print.
void remark(Panel& drawn, const std::string& text);

/// What a panel is drawn from.
struct Context {
  const store::ExperimentRecord& experiment;
  const store::FigureRecord& figure;
  Key& key;
};

[[nodiscard]] Panel draw_plane(const store::PanelRecord& panel, const Context& context, DataFile& data);
[[nodiscard]] Panel draw_curvature(const store::PanelRecord& panel, const Context& context, DataFile& data);
[[nodiscard]] Panel draw_convergence(const store::PanelRecord& panel, const Context& context, DataFile& data);
[[nodiscard]] Panel draw_graph(const store::PanelRecord& panel, const Context& context, DataFile& data);

// ---- helpers

/// The cells a panel shows; throws std::invalid_argument for an index that is not there.
[[nodiscard]] std::vector<const store::CellRecord*> cells_of(const store::PanelRecord& panel, const Context& context);
[[nodiscard]] std::string label_of(const store::CellRecord& cell);
/// The curves of a cell that a panel shows.
[[nodiscard]] std::vector<const store::CurveRecord*> curves_of(const store::PanelRecord& panel,
                                                               const store::CellRecord& cell);
/// Enters the cells into the legend with their outcomes, and sets title and note. Returns for each its line
/// properties: solid when converged, dashed when not.
std::vector<std::string> enter_cells(const std::vector<const store::CellRecord*>& cells, const Context& context,
                                     Panel& drawn);

/// Single-quoted for gnuplot, on one line.
[[nodiscard]] std::string text_in_gnuplot(std::string_view text);
[[nodiscard]] std::string lighter(const std::string& colour, double part_white);
[[nodiscard]] Interval padded(Interval range, double part);
/// Smallest interval around the finite values, or nothing.
[[nodiscard]] std::optional<Interval> extent(const std::vector<double>& values);

/// The |curvature| up to which teeth and graphs are drawn; beyond it they are cut off. It is the largest value, unless
/// that exceeds both three times the 95 % quantile and `always_shown`, a curvature that is not huge for the drawing.
struct CurvatureLimit {
  double limit = 0.0, largest = 0.0;
  [[nodiscard]] bool clips() const { return largest > limit * (1.0 + 1e-12); }
};
[[nodiscard]] CurvatureLimit curvature_limit(const std::vector<const store::CurveRecord*>& curves, double always_shown);

inline constexpr int font_size = 16;
inline constexpr std::string_view grey = "#808080";

}  // namespace kappabench::figures
