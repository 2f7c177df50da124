#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <vector>

#include "reports/store/model.hpp"

/// The layout of the results file, stated once: every function describes one record to a TreeWriter (the record is
/// const) or to a TreeReader (which fills it). reports/README.md is the same in prose.
namespace kappabench::store {

inline constexpr auto by_number = [](std::size_t index, const auto&) { return fmt::format("{:03}", index); };
inline constexpr auto by_id = [](std::size_t, const auto& record) { return record.id; };
inline constexpr auto by_cell = [](std::size_t index, const CellRecord& cell) {
  return fmt::format("{:04} {} {}", index, cell.dataset, cell.scheme);
};

template <class Tree, class Measurements>
void describe_measurements(Tree& tree, Measurements& measurements) {
  // An array of records on one side, columns on the other: the copies are small.
  std::vector<std::string> column, method, unit;
  std::vector<double> value;
  for (const auto& m : measurements) {
    column.push_back(m.column);
    value.push_back(m.value);
    method.push_back(m.method);
    unit.push_back(m.unit);
  }
  tree.table("metrics",
             [&](auto& put) { put("column", column), put("value", value), put("method", method), put("unit", unit); });
  if constexpr (!std::is_const_v<Measurements>) {
    measurements.clear();
    for (std::size_t i = 0; i < column.size(); ++i) measurements.push_back({column[i], value[i], method[i], unit[i]});
  }
}

template <class Tree, class Curve>
void describe_curve(Tree& tree, Curve& c) {
  tree.value("closed", c.closed);
  tree.value("samples_per_segment", c.samples_per_segment);
  tree.table("points", [&](auto& put) { put("x", c.point_x), put("y", c.point_y); });
  tree.group("report", [&](auto& report) {
    report.value("outcome", c.outcome);
    report.value("message", c.message);
    report.value("iterations", c.iterations);
    report.value("residual", c.residual);
    report.value("seconds", c.seconds);
  });
  tree.table("trace", [&](auto& put) { put("residual", c.trace); });
  tree.numbers("counters", c.counters);
  tree.numbers("warnings", c.warnings);
  tree.text("exact", c.exact_json);
  tree.table("samples", [&](auto& put) {
    put("x", c.sample_x), put("y", c.sample_y), put("kappa", c.sample_kappa), put("s", c.sample_s);
    put("normal_x", c.sample_normal_x), put("normal_y", c.sample_normal_y);
  });
  tree.table("nodes", [&](auto& put) {
    put("point", c.node_point), put("segment", c.node_segment), put("t", c.node_t);
    put("x", c.node_x), put("y", c.node_y), put("s", c.node_s), put("kappa", c.node_kappa);
    put("marks", c.node_marks);
  });
  tree.table("joints", [&](auto& put) {
    put("segment", c.joint_segment), put("claimed", c.joint_claimed);
    put("x", c.joint_x), put("y", c.joint_y), put("s", c.joint_s);
  });
  describe_measurements(tree, c.measurements);
}

template <class Tree, class Table>
void describe_table(Tree& tree, Table& table) {
  tree.value("id", table.id);
  tree.value("title", table.title);
  tree.value("caption", table.caption);
  tree.table_columns(table.columns);
}

template <class Tree, class Cell>
void describe_cell(Tree& tree, Cell& cell) {
  tree.value("dataset", cell.dataset);
  tree.value("scheme", cell.scheme);
  tree.value("parameters", cell.parameters);
  tree.value("label", cell.label);
  tree.value("key", cell.key);
  tree.value("outcome", cell.outcome);
  tree.value("message", cell.message);
  tree.list("curves", cell.curves, by_number, [](auto& child, auto& curve) { describe_curve(child, curve); });
  tree.list("rows", cell.rows, by_number, [](auto& child, auto& table) { child.table_columns(table.columns); });
  tree.series("timings", cell.timings);
}

template <class Tree, class Panel>
void describe_panel(Tree& tree, Panel& p) {
  tree.value("kind", p.kind);
  tree.value("title", p.title);
  tree.column("cells", p.cells);
  tree.value("curve", p.curve);
  tree.value("comb", p.comb);
  tree.value("points", p.points);
  tree.value("joints", p.joints);
  tree.value("comb_scale", p.comb_scale);
  tree.column("window", p.window);
  tree.value("table", p.table);
  tree.value("x", p.x);
  tree.column("y", p.y);
  tree.value("series", p.series);
  tree.value("log_x", p.log_x);
  tree.value("log_y", p.log_y);
  tree.value("lines", p.lines);
  tree.value("slope", p.slope);
  tree.value("x_label", p.x_label);
  tree.value("y_label", p.y_label);
}

template <class Tree, class Figure>
void describe_figure(Tree& tree, Figure& figure) {
  tree.value("id", figure.id);
  tree.value("title", figure.title);
  tree.value("caption", figure.caption);
  tree.value("columns", figure.columns);
  tree.list("panels", figure.panels, by_number, [](auto& child, auto& panel) { describe_panel(child, panel); });
}

template <class Tree, class Claim>
void describe_claim(Tree& tree, Claim& claim) {
  tree.value("paper", claim.paper);
  tree.value("claim", claim.claim);
  tree.value("verdict", claim.verdict);
  tree.value("ours", claim.ours);
  tree.value("evidence", claim.evidence);
  tree.value("method", claim.method);
  tree.value("kind", claim.kind);
  tree.value("sample", claim.sample);
  tree.value("interval", claim.interval);
  tree.value("rule", claim.rule);
}

template <class Tree, class Experiment>
void describe_experiment(Tree& tree, Experiment& e) {
  tree.value("id", e.id);
  tree.value("title", e.title);
  tree.value("about", e.about);
  tree.list("cells", e.cells, by_cell, [](auto& child, auto& cell) { describe_cell(child, cell); });
  tree.list("tables", e.tables, by_id, [](auto& child, auto& table) { describe_table(child, table); });
  tree.list("figures", e.figures, by_id, [](auto& child, auto& figure) { describe_figure(child, figure); });
  tree.list("claims", e.claims, by_number, [](auto& child, auto& claim) { describe_claim(child, claim); });
}

}  // namespace kappabench::store
