// SPDX-License-Identifier: MIT
#include "replay/csv.h"

#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <limits>

namespace bedmix::test {
namespace {

std::string problemOf(const std::string& text) {
  const TemporaryFolder folder;
  writeText(folder / "t.csv", text);
  const auto table = readCsv(folder / "t.csv");
  if (table) return "";
  EXPECT_EQ(table.problems.front().trouble, Trouble::file);
  const std::string message = toString(table.problems.front());
  return message.substr(message.find("t.csv"));
}

TEST(Csv, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  const std::vector<double> values{0.1, 1.0 / 3, -0.0, 5e-324, std::numeric_limits<double>::max(), 1e22, 21};
  {
    auto csv = CsvWriter::create(folder / "t.csv", "a,b,c");
    ASSERT_TRUE(csv);
    for (double v : values) ASSERT_FALSE(csv->row({std::nullopt, v, std::nullopt}));
  }
  const auto table = readCsv(folder / "t.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->names, (std::vector<std::string>{"a", "b", "c"}));
  ASSERT_EQ(table->rows(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(table->find("b")->at(i), values[i]);
    EXPECT_FALSE(table->find("a")->at(i));
    EXPECT_FALSE(table->find("c")->at(i));
  }
  EXPECT_FALSE(table->find("d"));
}

TEST(Csv, TextIsExact) {
  const TemporaryFolder folder;
  auto csv = CsvWriter::create(folder / "t.csv", "time,value");
  ASSERT_TRUE(csv);
  ASSERT_FALSE(csv->row({0.07, 3.0}));
  EXPECT_EQ(fileText(folder / "t.csv"), "time,value\n0.07,3\n");  // there before the writer is gone
  ASSERT_FALSE(csv->row({std::nullopt, 0.1 + 0.2}));
  EXPECT_EQ(fileText(folder / "t.csv"), "time,value\n0.07,3\n,0.30000000000000004\n");
}

TEST(Csv, AHalfWrittenLastLineIsNotCounted) {
  const TemporaryFolder folder;
  writeText(folder / "t.csv", "a,b\n1,2\n3,4");
  const auto table = readCsv(folder / "t.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->rows(), 1u);
}

TEST(Csv, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(problemOf("a,b\n1,2\n3,x4\n"), "t.csv:3:3: 'x4' is not a number");
  EXPECT_EQ(problemOf("a,b\n1,inf\n"), "t.csv:2:3: 'inf' is not a number");
  EXPECT_EQ(problemOf("a,b\n1 ,2\n"), "t.csv:2:1: '1 ' is not a number");
  EXPECT_EQ(problemOf("a,b\n1,2\n3\n").rfind("t.csv:3:1: 1 fields where the header has 2", 0), 0u);
  EXPECT_EQ(problemOf("a,b\n1,2,3\n").rfind("t.csv:2:1: 3 fields where the header has 2", 0), 0u);
  EXPECT_NE(problemOf("").find("no header"), std::string::npos);
  EXPECT_NE(problemOf("a,b").find("no header"), std::string::npos);
  EXPECT_FALSE(readCsv("/nowhere/t.csv"));
}

}  // namespace
}  // namespace bedmix::test
