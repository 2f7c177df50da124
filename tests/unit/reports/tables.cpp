#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "reports/tables.hpp"
#include "tests/catch.hpp"

using namespace kappabench;

namespace {

store::TableRecord awkward() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  return {"odd",
          "Title with 50% & more",
          "see x_1",
          {{"scheme_id", "", "", std::vector<std::string>{"a|b", "say \"hi\", you", "c\\d{e}", "two\nlines"}, false},
           {"energy", "1/length", "", std::vector<double>{0.1, nan, -1.23456e-7, inf}, false},
           {"count", "1", "", std::vector<double>{12345678, 0, -3, nan}, true}}};
}

}  // namespace

TEST_CASE("CSV follows RFC 4180 and keeps every bit") {
  const std::string expected =
      "scheme_id,energy (1/length),count\r\n"
      "a|b,0.10000000000000001,12345678\r\n"
      "\"say \"\"hi\"\", you\",,0\r\n"
      "c\\d{e},-1.2345599999999999e-07,-3\r\n"
      "\"two\nlines\",inf,\r\n";
  CHECK(to_csv(awkward()) == expected);
  store::TableRecord table = awkward();
  table.columns = {{"v", "", "", std::vector<double>{0.1 + 0.2, 5e-324, 1.0 / 3.0}, false}};
  const std::string csv = to_csv(table);
  CHECK(std::stod(csv.substr(3)) == 0.1 + 0.2);
}

TEST_CASE("Markdown escapes and aligns") {
  const std::string text = to_markdown(awkward());
  CHECK(text.find("### Title with 50% &amp; more\n\n| scheme\\_id | energy (1/length) | count |\n") == 0);
  CHECK(text.find("| :--- | ---: | ---: |\n") != std::string::npos);
  CHECK(text.find("| a\\|b | 0.1 | 12345678 |\n") != std::string::npos);
  CHECK(text.find("| say \"hi\", you | – | 0 |\n") != std::string::npos);
  CHECK(text.find("| c\\\\d{e} | -1.235e-07 | -3 |\n") != std::string::npos);
  CHECK(text.find("| two lines | inf | – |\n") != std::string::npos);
  CHECK(text.find("\nsee x\\_1\n") != std::string::npos);
}

TEST_CASE("LaTeX uses booktabs and escapes every special character") {
  const std::string text = to_latex(awkward());
  CHECK(text.find("\\begin{tabular}{lrr}") != std::string::npos);
  CHECK(text.find("\\toprule\n    scheme\\_id & energy (1/length) & count \\\\\n    \\midrule") != std::string::npos);
  CHECK(text.find("c\\textbackslash{}d\\{e\\} & $-1.235\\times10^{-7}$ & $-3$ \\\\") != std::string::npos);
  CHECK(text.find("you & -- & $0$") != std::string::npos);
  CHECK(text.find("$\\infty$ & --") != std::string::npos);
  CHECK(text.find("\\caption{Title with 50\\% \\& more. see x\\_1}") != std::string::npos);
  CHECK(text.find("\\label{tab:odd}") != std::string::npos);
  store::TableRecord greek = awkward();
  greek.title = "εκ² – ~^$";
  CHECK(to_latex(greek).find("\\caption{$\\varepsilon$$\\kappa$$^2$ -- \\textasciitilde{}\\textasciicircum{}\\$.") !=
        std::string::npos);
}

TEST_CASE("Plain text is aligned by characters, not bytes") {
  const store::TableRecord table{"t",
                                 "",
                                 "",
                                 {{"name", "", "", std::vector<std::string>{"é", "long name"}, false},
                                  {"n", "1", "", std::vector<double>{1, std::nan("")}, true}}};
  CHECK(to_text(table) ==
        "name       n\n"
        "---------  -\n"
        "é          1\n"
        "long name  -\n");
}

TEST_CASE("Columns of unequal length are refused by name") {
  store::TableRecord table = awkward();
  std::get<std::vector<double>>(table.columns[1].cells).pop_back();
  for (const auto format : {to_markdown, to_csv, to_latex, to_text}) {
    CHECK_THROWS_AS(format(table), std::invalid_argument);
  }
  std::string message;
  try {
    (void)to_csv(table);
  } catch (const std::invalid_argument& error) {
    message = error.what();
  }
  CHECK(message == "table 'odd': column 'energy' has 3 rows, column 'scheme_id' has 4");
}

TEST_CASE("A table without columns or rows is still a table") {
  store::TableRecord table{"t", "T", "", {}};
  for (const auto format : {to_markdown, to_csv, to_latex, to_text}) CHECK_NOTHROW(format(table));
  table.columns = {{"a", "", "", std::vector<double>{}, false}};
  CHECK(to_csv(table) == "a\r\n");
}
