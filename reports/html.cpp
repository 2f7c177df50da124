#include "reports/html.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "reports/outcome_words.hpp"
#include "reports/report.hpp"
#include "reports/tables.hpp"

namespace kappabench {
namespace {

using store::ClaimRecord;
using store::ExperimentRecord;
using store::Results;

constexpr std::string_view style = R"(
:root{--ink:#1b1f24;--soft:#57606a;--line:#d0d7de;--back:#f6f8fa}
*{box-sizing:border-box}
body{margin:0 auto;max-width:72rem;padding:1.5rem 1.25rem 4rem;color:var(--ink);background:#fff;
 font:16px/1.5 system-ui,-apple-system,"Segoe UI","DejaVu Sans",sans-serif}
h1{font-size:1.7rem;margin:.2em 0}h2{font-size:1.35rem;margin:2.5em 0 .4em;border-bottom:1px solid var(--line)}
h3{font-size:1.05rem;margin:1.6em 0 .3em}a{color:#0550ae}p{max-width:50rem}
nav ul{columns:22rem;padding-left:1.2rem;margin:.3em 0}code,pre{font:.88em ui-monospace,"DejaVu Sans Mono",monospace}
.scroll{overflow:auto;max-height:34rem;border:1px solid var(--line);border-radius:4px;width:fit-content;max-width:100%}
table{border-collapse:collapse;font-size:.88rem}th,td{padding:.28rem .7rem;text-align:left;vertical-align:top;
 border-bottom:1px solid var(--line)}th{position:sticky;top:0;background:var(--back);white-space:nowrap}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}tr:last-child td{border-bottom:0}
figure{margin:1.2em 0;border:1px solid var(--line);border-radius:4px;padding:.8rem}
figure img{display:block;max-width:100%;height:auto;margin:0 auto}figcaption{margin-top:.6em;font-size:.92rem}
.files{font-size:.85rem;color:var(--soft);margin:.25em 0}.soft{color:var(--soft)}
.v{white-space:nowrap;font-weight:600}.reproduced{color:#116329}.not-reproduced{color:#8a5300}
.contradicted{color:#b3141c}.misprint{color:#6639ba}
.not-tested,.undecided,.undecidable,.by-construction{color:var(--soft);font-weight:400}.grounds{min-width:14rem}
pre{background:var(--back);padding:.7rem;overflow:auto;max-height:24rem}
@media print{.scroll{max-height:none;overflow:visible}}
)";

std::string anchor(std::string_view text) {
  std::string result;
  for (const char c : text) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
  return result;
}

std::string cell(std::string_view text, std::string_view attributes = "") {
  return fmt::format("<td{}>{}</td>", attributes, html_escaped(text));
}

std::string row_of_heads(const std::vector<std::string>& heads) {
  std::string text = "<tr>";
  for (const auto& head : heads) text += fmt::format("<th>{}</th>", html_escaped(head));
  return text + "</tr>\n";
}

std::string paragraph(std::string_view text) {
  return text.empty() ? "" : fmt::format("<p>{}</p>\n", html_escaped(text));
}

// ---- tables and figures

std::string table_section(const store::TableRecord& table, const std::string& stem) {
  const WordTable words = to_words(table, "–");
  std::string text = fmt::format("<h3 id=\"table-{}\">{}</h3>\n{}<div class=\"scroll\"><table>\n<tr>", stem,
                                 html_escaped(table.title.empty() ? table.id : table.title), paragraph(table.caption));
  for (const auto& column : words.columns) {
    text += fmt::format("<th{}>{}</th>", column.numbers ? " class=\"n\"" : "", html_escaped(column.head));
  }
  text += "</tr>\n";
  for (std::size_t row = 0; row < words.rows; ++row) {
    text += "<tr>";
    for (const auto& column : words.columns) text += cell(column.cells[row], column.numbers ? " class=\"n\"" : "");
    text += "</tr>\n";
  }
  text += "</table></div>\n<p class=\"files\">";
  for (const char* kind : {"csv", "tex", "md"}) text += fmt::format("<a href=\"tables/{0}.{1}\">{1}</a> ", stem, kind);
  return text + "</p>\n";
}

std::string extension_of(const std::string& name) { return name.substr(name.rfind('.') + 1); }

std::string figure_section(const store::FigureRecord& figure, const std::string& stem, const FigureState& state) {
  std::string text = fmt::format("<figure id=\"figure-{}\">\n", stem);
  if (state.problem.empty()) {
    text += fmt::format("<a href=\"figures/{0}.svg\"><img src=\"figures/{0}.svg\" alt=\"{1}\" loading=\"lazy\"></a>\n",
                        stem, html_escaped(figure.title));
  } else {
    text += fmt::format("<p class=\"contradicted\">No picture: {}</p>\n", html_escaped(state.problem));
  }
  text += fmt::format("<figcaption><b>{}.</b> {}", html_escaped(figure.title.empty() ? figure.id : figure.title),
                      html_escaped(figure.caption));
  text += "<p class=\"files\">";
  const auto data_files = std::count_if(state.files.begin(), state.files.end(),
                                        [](const auto& name) { return extension_of(name) == "dat"; });
  for (const auto& name : state.files) {
    const bool numbered = extension_of(name) == "dat" && data_files > 1;
    text += fmt::format("<a href=\"figures/{}\">{}</a> ", name,
                        numbered ? name.substr(stem.size() + 1) : extension_of(name));
  }
  return text + "</p></figcaption>\n</figure>\n";
}

// ---- claims

std::string verdict_cell(std::string_view verdict) {
  const std::string_view sign = verdict == "reproduced" ? "✓ " : verdict == "contradicted" ? "✗ " : "";
  return fmt::format("<td class=\"v {}\">{}{}</td>", anchor(verdict), sign, html_escaped(verdict));
}

const PrintedClaim* find_claim(const std::vector<Paper>& papers, const ClaimRecord& record) {
  for (const auto& paper : papers) {
    if (paper.id != record.paper) continue;
    for (const auto& claim : paper.claims) {
      if (claim.id == record.claim) return &claim;
    }
  }
  return nullptr;
}

/// What turned counts into the verdict: "in general: 1234 of 1240 (99.5 %); 98.9 % to 99.8 % of all; reproduced from
/// ...".
std::string grounds_cell(const ClaimRecord& record) {
  std::string text = html_escaped(record.kind);
  for (const std::string& part : {record.sample, record.interval, record.rule})
    if (!part.empty()) text += fmt::format("<br>{}", html_escaped(part));
  return fmt::format("<td class=\"grounds\">{}</td>", text);
}

std::string ours_cell(const ClaimRecord& record) {
  return cell(record.method.empty() ? record.ours : fmt::format("{}: {}", record.method, record.ours));
}

std::string claim_row(const PrintedClaim* claim, const ClaimRecord& record) {
  return fmt::format("<tr>{}<td>{}<br><code>{}</code></td>{}{}{}{}{}</tr>\n", verdict_cell(record.verdict),
                     html_escaped(claim != nullptr ? claim->text : "(no such claim in the paper's file)"),
                     html_escaped(record.claim), cell(claim != nullptr ? claim->place : ""),
                     cell(claim != nullptr ? claim->printed : ""), ours_cell(record), grounds_cell(record),
                     cell(record.evidence));
}

std::string claims_section(const ExperimentRecord& experiment, const std::vector<Paper>& papers) {
  if (experiment.claims.empty()) return "";
  std::string text = "<h3>Claims</h3>\n<div class=\"scroll\"><table>\n" +
                     row_of_heads({"verdict", "claim", "place", "printed", "ours", "by what rule", "evidence"});
  for (const auto& record : experiment.claims) text += claim_row(find_claim(papers, record), record);
  return text + "</table></div>\n";
}

/// Verdicts on one claim, from whichever experiments tested it.
std::vector<std::pair<const ExperimentRecord*, const ClaimRecord*>> verdicts_on(const Results& results,
                                                                                const std::string& paper,
                                                                                const std::string& claim) {
  std::vector<std::pair<const ExperimentRecord*, const ClaimRecord*>> found;
  for (const auto& experiment : results.experiments) {
    for (const auto& record : experiment.claims) {
      if (record.paper == paper && record.claim == claim) found.emplace_back(&experiment, &record);
    }
  }
  return found;
}

bool mentions(const Results& results, const std::string& paper) {
  return std::any_of(results.experiments.begin(), results.experiments.end(), [&](const auto& experiment) {
    return std::any_of(experiment.claims.begin(), experiment.claims.end(),
                       [&](const auto& record) { return record.paper == paper; });
  });
}

std::string printed_table(const PrintedTable& table) {
  std::string text = fmt::format("<details><summary>Printed: {} ({})</summary><div class=\"scroll\"><table>\n{}",
                                 html_escaped(table.title), html_escaped(table.place), row_of_heads(table.columns));
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (const auto& word : row) text += cell(word);
    text += "</tr>\n";
  }
  return text + "</table></div></details>\n";
}

/// "12 reproduced, 3 contradicted; not counted: 2 by construction".
std::string totals(std::map<std::string, int> counts) {
  const int apart = std::exchange(counts["by construction"], 0);
  std::vector<std::string> words;
  for (const auto& [verdict, count] : counts)
    if (count > 0) words.push_back(fmt::format("{} {}", count, verdict));
  return fmt::format("{}{}", fmt::join(words, ", "),
                     apart > 0 ? fmt::format("; not counted: {} by construction", apart) : "");
}

/// What a reader must know before quoting a verdict.
constexpr std::string_view limits =
    "Limits of these verdicts: the statements are in our words, from the papers' texts as scanned, which misreads "
    "symbols; "
    "the papers print no coordinates, so that drawings are stand-ins of our own and agree in kind, not in digits; "
    "where a "
    "paper leaves a unit, a weight or a rule of stopping open, ours is one reading of it, named in the scheme's "
    "README.";

/// Every claim of a paper, also those that nothing here tested, so that none is left out of the count.
std::string paper_section(const Results& results, const Paper& paper) {
  std::map<std::string, int> counts;
  std::string rows;
  for (const auto& claim : paper.claims) {
    const auto verdicts = verdicts_on(results, paper.id, claim.id);
    if (verdicts.empty()) {
      ++counts["not tested"];
      rows += fmt::format("<tr>{}<td>{}<br><code>{}</code></td>{}{}<td></td><td></td><td></td></tr>\n",
                          verdict_cell("not tested"), html_escaped(claim.text), html_escaped(claim.id),
                          cell(claim.place), cell(claim.printed));
    }
    for (const auto& [experiment, record] : verdicts) {
      ++counts[record->verdict];
      rows += fmt::format("<tr>{}<td>{}<br><code>{}</code></td>{}{}{}{}<td><a href=\"#{}\">{}</a></td></tr>\n",
                          verdict_cell(record->verdict), html_escaped(claim.text), html_escaped(claim.id),
                          cell(claim.place), cell(claim.printed), ours_cell(*record), grounds_cell(*record),
                          anchor(experiment->id), html_escaped(experiment->id));
    }
  }
  std::string text =
      fmt::format("<h2 id=\"paper-{}\">Claims: {}</h2>\n<p class=\"soft\">{}</p>\n<p>{}.</p>\n", anchor(paper.id),
                  html_escaped(paper.title), html_escaped(paper.citation), html_escaped(totals(counts)));
  text += fmt::format("<p class=\"soft\">{}</p>\n", limits);
  text += "<div class=\"scroll\"><table>\n" +
          row_of_heads({"verdict", "claim", "place", "printed", "ours", "by what rule", "experiment"}) + rows +
          "</table></div>\n";
  for (const auto& table : paper.tables) text += printed_table(table);
  return text;
}

// ---- outcomes

std::string outcome_summary(const ExperimentRecord& experiment) {
  std::map<std::string, int> counts;
  for (const auto& made : experiment.cells) ++counts[made.outcome];
  std::string text = fmt::format("{} cells", experiment.cells.size());
  const char* separator = ": ";
  for (const auto& [outcome, count] : counts) {
    text += fmt::format("{}{} {}", separator, count, spaced(outcome));
    separator = ", ";
  }
  return text;
}

std::string failures_section(const ExperimentRecord& experiment) {
  std::string rows;
  for (const auto& made : experiment.cells) {
    const std::string outcome = outcome_words(made);
    if (outcome == "converged") continue;
    std::string message = made.message;
    for (std::size_t i = 0; message.empty() && i < made.curves.size(); ++i) message = made.curves[i].message;
    rows += fmt::format("<tr>{}{}{}{}</tr>\n", cell(made.dataset),
                        cell(made.label.empty() ? made.scheme + " " + made.parameters : made.label), cell(outcome),
                        cell(message));
  }
  if (rows.empty()) return "";
  return "<h3>Cells that did not converge, or are wild</h3>\n<div class=\"scroll\"><table>\n" +
         row_of_heads({"drawing", "scheme", "outcome", "message"}) + rows + "</table></div>\n";
}

// ---- the page

std::string experiment_section(const ExperimentRecord& experiment, const std::vector<Paper>& papers,
                               const std::map<std::string, FigureState>& figures) {
  std::string text =
      fmt::format("<h2 id=\"{}\">{}</h2>\n<p class=\"soft\"><code>{}</code> · {}</p>\n", anchor(experiment.id),
                  html_escaped(experiment.title.empty() ? experiment.id : experiment.title),
                  html_escaped(experiment.id), html_escaped(outcome_summary(experiment)));
  text += paragraph(experiment.about) + claims_section(experiment, papers);
  for (const auto& figure : experiment.figures) {
    const std::string stem = file_stem(experiment.id, figure.id);
    const auto state = figures.find(stem);
    text += figure_section(figure, stem, state == figures.end() ? FigureState{{}, "it was not drawn"} : state->second);
  }
  for (const auto& table : experiment.tables) text += table_section(table, file_stem(experiment.id, table.id));
  return text + failures_section(experiment);
}

std::string contents(const Results& results, const std::vector<Paper>& papers) {
  std::string text = "<nav><h2>Contents</h2><ul>\n";
  for (const auto& paper : papers) {
    if (!mentions(results, paper.id)) continue;
    text += fmt::format("<li><a href=\"#paper-{}\">Claims: {}</a></li>\n", anchor(paper.id), html_escaped(paper.title));
  }
  for (const auto& experiment : results.experiments) {
    text += fmt::format("<li><a href=\"#{}\">{}</a> <code class=\"soft\">{}</code></li>\n", anchor(experiment.id),
                        html_escaped(experiment.title.empty() ? experiment.id : experiment.title),
                        html_escaped(experiment.id));
  }
  return text + "<li><a href=\"#provenance\">Provenance</a></li>\n</ul></nav>\n";
}

std::string provenance_section(const Results& results, std::string_view gnuplot) {
  std::string rows, longer;
  for (const auto& [key, value] : results.provenance) {
    if (value.size() > 200 || value.find('\n') != std::string::npos) {
      longer += fmt::format("<details><summary>{}</summary><pre>{}</pre></details>\n", html_escaped(key),
                            html_escaped(value));
    } else {
      rows += fmt::format("<tr>{}{}</tr>\n", cell(key), cell(value));
    }
  }
  if (!gnuplot.empty()) rows += fmt::format("<tr>{}{}</tr>\n", cell("gnuplot, of the figures"), cell(gnuplot));
  std::string text = "<footer><h2 id=\"provenance\">Provenance</h2>\n";
  if (!rows.empty()) text += "<div class=\"scroll\"><table>\n" + rows + "</table></div>\n";
  return text + longer + "</footer>\n";
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string to_html(const Results& results, const std::vector<Paper>& papers,
                    const std::map<std::string, FigureState>& figures, std::string_view gnuplot) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>kappabench report</title>\n"
      "<style>{}</style>\n</head>\n<body>\n<h1>kappabench report</h1>\n",
      style);
  text += contents(results, papers);
  for (const auto& paper : papers) {
    if (mentions(results, paper.id)) text += paper_section(results, paper);
  }
  for (const auto& experiment : results.experiments) text += experiment_section(experiment, papers, figures);
  return text + provenance_section(results, gnuplot) + "</body>\n</html>\n";
}

}  // namespace kappabench
