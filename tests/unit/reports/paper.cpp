#include <cmath>
#include <string>

#include "reports/paper.hpp"
#include "tests/catch.hpp"

using namespace kappabench;

namespace {

std::string error_for(const std::string& text) {
  try {
    (void)parse_paper(text, "p.toml");
  } catch (const PaperError& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string head = "[paper]\ntitle = \"T\"\ncitation = \"C\"\n";

}  // namespace

TEST_CASE("Every paper of the house can be read and says where each claim stands") {
  const std::vector<Paper>& papers = printed_papers();
  REQUIRE_FALSE(papers.empty());
  for (const auto& paper : papers) {
    INFO(paper.id);
    CHECK_FALSE(paper.claims.empty());
    for (const auto& claim : paper.claims) {
      INFO(claim.id);
      CHECK(claim.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos);
      CHECK_FALSE(claim.place.empty());
    }
  }
}

TEST_CASE("A paper is read as it is written") {
  const std::string text =
      head +
      "[[claim]]\nid = \"a\"\nplace = \"Fig. 1\"\ntext = \"It holds.\"\nprinted = \"3\"\nkind = \"number\"\n"
      "at_most = 4\n"
      "[[table]]\nid = \"t\"\nplace = \"Table 1\"\ntitle = \"N\"\ncolumns = [\"x\", \"y\"]\nrows = [[\"1\", "
      "\"0.50\"]]\n";
  const Paper paper = parse_paper(text, "reports/paper/some-paper.toml");
  CHECK(paper.id == "some-paper");
  CHECK(paper.title == "T");
  REQUIRE(paper.claims.size() == 1);
  CHECK(paper.claims[0].printed == "3");
  CHECK(paper.claims[0].kind == StatementKind::number);
  CHECK(paper.claims[0].at_most == 4.0);
  CHECK(std::isinf(paper.claims[0].at_least));
  REQUIRE(paper.tables.size() == 1);
  CHECK(paper.tables[0].rows[0][1] == "0.50");
}

TEST_CASE("A paper that is not there is named with its file") {
  CHECK(printed_paper("fpc-2019-chen").id == "fpc-2019-chen");
  CHECK_THROWS_WITH(printed_paper("nobody-1900"), "reports/paper/nobody-1900.toml: there is no such file");
}

TEST_CASE("What is wrong in a file of claims is told with its line") {
  CHECK(has(error_for("x = \n"), "p.toml:1: "));
  CHECK(has(error_for(""), "[paper] is missing"));
  CHECK(has(error_for(head + "year = 2022\n"), "p.toml:4: unknown key 'year'"));
  CHECK(has(error_for(head + "[[claim]]\nid = \"a\"\nplace = \"p\"\n"), "'text' is missing"));
  CHECK(has(error_for(head + "[[claim]]\nid = 3\nplace = \"p\"\ntext = \"t\"\n"), "p.toml:5: 'id' must be a text"));
  const std::string stated = "[[claim]]\nid = \"a\"\nplace = \"p\"\ntext = \"t\"\n";
  CHECK(has(error_for(head + stated), "'kind' is missing"));
  CHECK(has(error_for(head + stated + "kind = \"ever\"\n"), "kind 'ever' is none of always, in general"));
  CHECK(has(error_for(head + stated + "kind = \"may\"\nat_most = 1\n"), "p.toml:9: 'at_most' is for the kinds"));
  CHECK(has(error_for(head + stated + "kind = \"number\"\nat_most = \"1\"\n"), "'at_most' must be a number"));
  const std::string claim = stated + "kind = \"always\"\n";
  CHECK(has(error_for(head + claim + claim), "p.toml:9: id used twice: a"));
  const std::string table = "[[table]]\nid = \"t\"\nplace = \"p\"\ntitle = \"t\"\ncolumns = [\"x\"]\n";
  CHECK(has(error_for(head + table + "rows = [[0.5]]\n"), "quote it"));
  CHECK(has(error_for(head + table + "rows = [[\"1\", \"2\"]]\n"), "2 entries for 1 columns"));
  CHECK(error_for(head + claim).empty());
}
