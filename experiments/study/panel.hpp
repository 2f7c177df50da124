#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/store/model.hpp"

namespace kappabench::study {

/// A panel of a figure, said in one sentence: Panel::curves({cell}, "bird").comb().
class Panel {
 public:
  /// Cells in the plane, over one another.
  [[nodiscard]] static Panel curves(std::vector<int> cells, std::string title) {
    return Panel({.kind = "curve", .title = std::move(title), .cells = std::move(cells)});
  }
  /// Curvature of cells against arc length.
  [[nodiscard]] static Panel curvature(std::vector<int> cells, std::string title) {
    return Panel({.kind = "curvature", .title = std::move(title), .cells = std::move(cells)});
  }
  /// Residuals of cells against iterations.
  [[nodiscard]] static Panel convergence(std::vector<int> cells, std::string title) {
    return Panel({.kind = "convergence", .title = std::move(title), .cells = std::move(cells)});
  }
  /// Columns of a table against one of them; the axes are named like the columns.
  [[nodiscard]] static Panel graph(std::string table, std::string x, std::vector<std::string> y, std::string title) {
    store::PanelRecord record{.kind = "graph", .title = std::move(title)};
    record.table = std::move(table);
    record.x_label = record.x = std::move(x);
    record.y = std::move(y);
    if (record.y.size() == 1) record.y_label = record.y.front();
    return Panel(std::move(record));
  }

  /// With a curvature comb; `scale`: its longest tooth over the drawing's size, 0: chosen by the renderer.
  Panel comb(double scale = 0.0) && {
    record_.comb = true;
    record_.comb_scale = scale;
    return std::move(*this);
  }
  Panel window(std::vector<double> limits) && { return record_.window = std::move(limits), std::move(*this); }
  Panel of_curve(int curve) && { return record_.curve = curve, std::move(*this); }
  Panel without_points() && { return record_.points = false, std::move(*this); }
  Panel without_joints() && { return record_.joints = false, std::move(*this); }
  /// The column whose words split the rows into series.
  Panel series(std::string column) && { return record_.series = std::move(column), std::move(*this); }
  Panel labels(std::string x, std::string y) && {
    record_.x_label = std::move(x);
    record_.y_label = std::move(y);
    return std::move(*this);
  }
  Panel log_x(bool on = true) && { return record_.log_x = on, std::move(*this); }
  Panel log_y(bool on = true) && { return record_.log_y = on, std::move(*this); }
  /// Points that are not joined.
  Panel dots() && { return record_.lines = false, std::move(*this); }
  /// With a least-squares line through each series.
  Panel slope() && { return record_.slope = true, std::move(*this); }

  operator store::PanelRecord() && { return std::move(record_); }  // NOLINT(google-explicit-constructor)
  operator store::PanelRecord() const& { return record_; }         // NOLINT(google-explicit-constructor)

 private:
  explicit Panel(store::PanelRecord record) : record_(std::move(record)) {}
  store::PanelRecord record_;
};

}  // namespace kappabench::study
