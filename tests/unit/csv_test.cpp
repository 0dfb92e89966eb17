// Rows of comma-separated values come back as they went in.
#include "base/csv.h"

#include <gtest/gtest.h>

#include <random>

#include "study/stability/experiment.h"
#include "support/read_csv.h"
#include "support/seeded_random.h"

namespace ps::csv_test {
namespace {

TEST(Csv, FieldsComeBackAsTheyWentIn) {
  test::SeededRandom random;
  const std::string letters = "ab,\"\r\n ;'";
  std::uniform_int_distribution<std::size_t> letter(0, letters.size() - 1), length(0, 8);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<std::string> fields(3);
    for (std::string& field : fields)
      for (std::size_t i = length(random); i > 0; --i) field += letters[letter(random)];
    const std::string line = csv_row(fields);
    EXPECT_EQ(test::read_csv(line), (std::vector<std::vector<std::string>>{fields})) << line;
  }
}

TEST(Csv, QuotesOnlyWhereTheyAreNeeded) {
  EXPECT_EQ(csv_row({"plain words; 1.5", "", "a,b"}), "plain words; 1.5,,\"a,b\"\n");
  EXPECT_EQ(csv_row({"say \"so\""}), "\"say \"\"so\"\"\"\n");
  EXPECT_EQ(csv_row({"a\rb"}), "\"a\rb\"\n");
}

TEST(Csv, ColumnsComeBehindThoseOfEachRow) {
  const auto fields_of = [](std::size_t row) { return std::vector<std::string>{"row " + std::to_string(row), "a,b"}; };
  EXPECT_EQ(csv_with_columns("k\n1\n2\n", {"name", "more"}, fields_of),
            "k,name,more\n1,row 0,\"a,b\"\n2,row 1,\"a,b\"\n");
  EXPECT_EQ(csv_with_columns("k\n1", {"name", "more"}, fields_of), "k,name,more\n1,row 0,\"a,b\"\n")
      << "a table without its last line end";
}

TEST(Csv, SeriesOfAnExperimentMayHaveQuotes) {
  const std::vector<StabilityRow> rows{{1, "the \"easy\" one, alone", 2, 3, "px"}};
  const auto table = test::read_csv(stability_csv(rows));
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table[1], (std::vector<std::string>{"1", "the \"easy\" one, alone", "2", "3", "px"}));
}

}  // namespace
}  // namespace ps::csv_test
