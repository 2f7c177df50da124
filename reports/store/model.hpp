#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kappabench::store {

/// What the store holds, as plain values: the HDF5 file is exactly this tree (reports/README.md), and every table
/// and figure is drawn from it alone.

struct MeasurementRecord {
  std::string column;
  double value;
  std::string method;  ///< exact | enclosed | sampled
  std::string unit;
  bool operator==(const MeasurementRecord&) const = default;
};

/// One fitted curve of a drawing.
struct CurveRecord {
  // the input
  bool closed = false;
  std::vector<double> point_x, point_y;
  // the report
  std::string outcome;
  std::string message;
  int iterations = 0;
  double residual = 0.0;
  double seconds = 0.0;
  std::vector<double> trace;
  std::map<std::string, long> counters;
  std::map<std::string, long> warnings;  ///< what is legal but wild: names, and how many spans
  // the curve, if there is one
  std::string exact_json;  ///< an object of kappabench-curve, version 2; empty without a curve
  std::vector<double> sample_x, sample_y, sample_kappa, sample_s;  ///< segment-major, s = arc length from the start
  std::vector<double> sample_normal_x, sample_normal_y;            ///< unit left normals
  int samples_per_segment = 0;
  std::vector<int> node_point, node_segment;
  std::vector<double> node_t, node_x, node_y, node_s, node_kappa;
  std::vector<std::string> node_marks;  ///< words that the scheme named, with blanks between
  std::vector<int> joint_segment;
  std::vector<std::string> joint_claimed;
  std::vector<double> joint_x, joint_y, joint_s;
  std::vector<MeasurementRecord> measurements;
  bool operator==(const CurveRecord&) const = default;
};

/// The names of the curve's warnings with blanks between.
[[nodiscard]] inline std::string warning_words(const CurveRecord& curve) {
  std::string words;
  for (const auto& entry : curve.warnings) words += (words.empty() ? "" : " ") + entry.first;
  return words;
}

/// A table of results: columns of equal length, each of numbers or of words.
struct TableColumn {
  std::string name;
  std::string unit{};
  std::string method{};  ///< exact | enclosed | sampled; empty for words, keys and what was worked out from others
  std::variant<std::vector<double>, std::vector<std::string>> cells{};
  bool whole_numbers = false;
  bool operator==(const TableColumn&) const = default;
};
struct TableRecord {
  std::string id;
  std::string title;
  std::string caption;
  std::vector<TableColumn> columns;
  bool operator==(const TableRecord&) const = default;
};

/// One cell: a drawing fitted by a scheme with parameters, in one experiment.
struct CellRecord {
  std::string dataset;
  std::string scheme;      ///< id
  std::string parameters;  ///< canonical text
  std::string label;       ///< for legends: "ekappa a=0.8"
  std::string key;         ///< hash of scheme version, parameters, dataset content, metric versions
  std::string outcome;     ///< the worst of its curves
  std::string message;
  std::vector<CurveRecord> curves;
  std::vector<TableRecord> rows;  ///< what a study measured: key columns (no method), then numbers; no id, no title
  std::map<std::string, std::vector<double>> timings;  ///< raw repetitions, seconds
  bool operator==(const CellRecord&) const = default;
};

/// A panel of a figure: what to draw, by reference into the same experiment.
struct PanelRecord {
  /// "curve": cells drawn over one another in the plane (equal axes).
  /// "curvature": kappa against arc length. "convergence": traces, residual against iteration, log scale.
  /// "graph": columns of a table against one another.
  std::string kind;
  std::string title;
  std::vector<int> cells;  ///< indices into ExperimentRecord::cells (not for "graph")
  int curve = -1;          ///< which curve of the drawing; -1 all
  // "curve" options
  bool comb = false;  ///< curvature comb
  bool points = true;
  bool joints = true;
  double comb_scale = 0.0;     ///< length of the longest tooth over the drawing's size; 0: chosen by the renderer
  std::vector<double> window;  ///< xmin, xmax, ymin, ymax for a close-up (also of "curvature"); empty: everything
  // "graph" options
  std::string table;
  std::string x;
  std::vector<std::string> y;
  std::string series;  ///< column whose words split the rows into series; may be empty
  bool log_x = false, log_y = false;
  bool lines = true;   ///< points joined by lines
  bool slope = false;  ///< a least-squares line through each series (in logarithms on log axes), slope in the legend
  std::string x_label, y_label;
  bool operator==(const PanelRecord&) const = default;
};
struct FigureRecord {
  std::string id;
  std::string title;
  std::string caption;
  int columns = 0;  ///< panels in a row; 0: chosen by the renderer
  std::vector<PanelRecord> panels;
  bool operator==(const FigureRecord&) const = default;
};

/// All words that ClaimRecord::verdict may be. `undecided`: the sample is too small to tell. `undecidable`: something
/// that the paper does not print decides. `by construction`: our check could not have failed; it is in no total.
inline constexpr std::array<std::string_view, 7> verdicts{"reproduced",  "not reproduced", "contradicted",   "misprint",
                                                          "undecidable", "undecided",      "by construction"};

/// The verdict on one claim of reports/paper/<paper>.toml.
struct ClaimRecord {
  std::string paper;     ///< "ekappa-2022-miura"
  std::string claim;     ///< id in the toml file
  std::string verdict;   ///< one of verdicts
  std::string ours;      ///< our number or words
  std::string evidence;  ///< one or two sentences, with counts
  std::string method;    ///< whose method was judged, where there are two: "as printed"; may be empty
  // How the verdict came about: experiments/study/verdicts.hpp.
  std::string kind;      ///< of the statement: "in general"
  std::string sample;    ///< "1234 of 1240 agree"
  std::string interval;  ///< what the sample says of all, at 95 % confidence: "98.9 % to 99.8 %"; may be empty
  std::string rule;      ///< what the interval was held against: "reproduced from 95 %, contradicted below 50 %"
  bool operator==(const ClaimRecord&) const = default;
};

struct ExperimentRecord {
  std::string id;
  std::string title;
  std::string about;  ///< a paragraph for the reader
  std::vector<CellRecord> cells;
  std::vector<TableRecord> tables;
  std::vector<FigureRecord> figures;
  std::vector<ClaimRecord> claims;
  bool operator==(const ExperimentRecord&) const = default;
};

/// A whole results file. `provenance` is the root attributes: schema version, commit, dirty flag, compiler, flags,
/// dependency versions, CPU, threads, seed, plan text.
struct Results {
  std::map<std::string, std::string> provenance;
  std::vector<ExperimentRecord> experiments;
  bool operator==(const Results&) const = default;
};

}  // namespace kappabench::store
