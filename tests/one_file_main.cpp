// Tests of many files are compiled into one program; this is how those of one file run: PROGRAM heat_test [GOOGLETEST'S
// FLAGS]. Without a name all run.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace {

// Stem of a path: heat_test of /somewhere/heat_test.cpp.
std::string stem(const std::string& path) {
  const std::string name = path.substr(path.find_last_of("/\\") + 1);
  return name.substr(0, name.find('.'));
}

// What googletest's filter already says, without every test that is written in another file.
std::string filter_of_file(const std::string& wanted) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  std::string filter = testing::GTEST_FLAG(filter);
  char separator = filter.find('-') == std::string::npos ? '-' : ':';
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const testing::TestInfo& test = *suite.GetTestInfo(t);
      if (stem(test.file()) == wanted) continue;
      filter += separator + std::string(suite.name()) + "." + test.name();
      separator = ':';
    }
  }
  return filter;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc > 1) testing::GTEST_FLAG(filter) = filter_of_file(argv[1]);
  const int failed = RUN_ALL_TESTS();
  if (testing::UnitTest::GetInstance()->test_to_run_count() > 0) return failed;
  std::fprintf(stderr, "there is no test of %s that the filter leaves\n", argc > 1 ? argv[1] : "this program");
  return 1;
}
