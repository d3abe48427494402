// Tests of many files are compiled into one program; this is how those of one file run: PROGRAM heat_test [GOOGLETEST'S
// FLAGS]. Without a name all run.
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

namespace {

// Stem of a path: heat_test of /somewhere/heat_test.cpp.
std::string stem(const std::string& path) {
  const std::string name = path.substr(path.find_last_of("/\\") + 1);
  return name.substr(0, name.find('.'));
}

bool one_matches(const std::string& patterns, const std::string& name) {
  std::istringstream each(patterns);
  for (std::string pattern; std::getline(each, pattern, ':');)
    if (fnmatch(pattern.c_str(), name.c_str(), 0) == 0) return true;
  return false;
}

// The tests of a file that googletest's filter, WANTED:WANTED-UNWANTED:UNWANTED, leaves.
std::string filter_of_file(const std::string& file, const std::string& filter) {
  const std::size_t minus = filter.find('-');
  const std::string wanted = minus == 0 ? "*" : filter.substr(0, minus);
  const std::string unwanted = minus == std::string::npos ? "" : filter.substr(minus + 1);
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  std::string left;
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const testing::TestInfo& test = *suite.GetTestInfo(t);
      const std::string name = std::string(suite.name()) + "." + test.name();
      if (stem(test.file()) == file && one_matches(wanted, name) && !one_matches(unwanted, name))
        left += (left.empty() ? "" : ":") + name;
    }
  }
  return left;
}

}  // namespace

int main(int argc, char** argv) {
  setenv("BEMPD_TEST_HOOKS", "1", 1);  // options whose names begin with test.
  testing::InitGoogleTest(&argc, argv);
  if (argc > 1) testing::GTEST_FLAG(filter) = filter_of_file(argv[1], testing::GTEST_FLAG(filter));
  const int failed = RUN_ALL_TESTS();
  if (testing::UnitTest::GetInstance()->test_to_run_count() > 0) return failed;
  std::fprintf(stderr, "there is no test of %s that the filter leaves\n", argc > 1 ? argv[1] : "this program");
  return 1;
}
