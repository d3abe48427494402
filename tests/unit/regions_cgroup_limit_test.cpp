// Limits of memory by control groups, from files as the kernel shows them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "regions/cgroup_limit.hpp"

namespace {

namespace fs = std::filesystem;

class ControlGroups : public ::testing::Test {
 protected:
  ControlGroups() { fs::remove_all(folder_); }
  ~ControlGroups() override { fs::remove_all(folder_); }

  void write(const fs::path& file, const std::string& contents) {
    fs::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file) << contents;
  }
  double limit() const { return bempd::regions::cgroup_memory_limit(folder_ / "membership", folder_ / "root"); }

 private:
  fs::path folder_ = fs::temp_directory_path() /
                     (std::string("bempd_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(ControlGroups, of_version_2_limit_by_the_least_of_a_group_and_those_above_it) {
  write("membership", "0::/user.slice/session.scope\n");
  write("root/user.slice/session.scope/memory.max", "max\n");
  EXPECT_TRUE(std::isinf(limit()));
  write("root/user.slice/memory.max", "2147483648\n");
  EXPECT_EQ(limit(), 2147483648.0);
  write("root/user.slice/session.scope/memory.max", "1048576\n");
  EXPECT_EQ(limit(), 1048576.0);
}

TEST_F(ControlGroups, of_a_container_are_mounted_as_the_root) {
  write("membership", "0::/\n");
  write("root/memory.max", "536870912\n");
  EXPECT_EQ(limit(), 536870912.0);
}

TEST_F(ControlGroups, of_version_1_are_those_of_the_controller_of_memory) {
  write("membership", "5:cpu,cpuacct:/a\n4:pids:/b\n3:hugetlb,memory:/docker/c\n0::/elsewhere\n");
  write("root/memory/memory.limit_in_bytes", "9223372036854771712\n");
  write("root/memory/docker/c/memory.limit_in_bytes", "268435456\n");
  EXPECT_EQ(limit(), 268435456.0);
}

TEST_F(ControlGroups, that_do_not_exist_set_no_limit) {
  EXPECT_TRUE(std::isinf(limit()));
  write("membership", "nonsense\n7:memory\n");
  EXPECT_TRUE(std::isinf(limit()));
}

}  // namespace
