// What lies at the path already: nothing but regular files is ever replaced.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>

#include "output/file.hpp"
#include "output/pvd.hpp"

namespace {

using namespace bempd::output;
namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class OutputPlaces : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("bempd_places_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::ptrdiff_t entries() const { return std::distance(fs::directory_iterator(folder_), {}); }
  static unsigned mode(const fs::path& path) { return static_cast<unsigned>(fs::status(path).permissions()); }

  // The sentence of the failure; empty when the writing went well.
  static std::string refusal(const fs::path& path, std::string_view text = "text") {
    try {
      write_file(path, text);
    } catch (const std::system_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(OutputPlaces, replaced_file_keeps_its_mode) {
  for (const mode_t wanted : {0640u, 0600u, 0666u}) {
    write_file(folder_ / "a", "old");
    ASSERT_EQ(::chmod((folder_ / "a").c_str(), wanted), 0);
    write_file(folder_ / "a", "new");
    EXPECT_EQ(content(folder_ / "a"), "new");
    EXPECT_EQ(mode(folder_ / "a"), wanted);
  }
}

TEST_F(OutputPlaces, new_file_has_the_mode_that_the_process_asks_for) {
  const mode_t before = ::umask(027);
  write_file(folder_ / "a", "new");
  ::umask(before);
  EXPECT_EQ(mode(folder_ / "a"), 0640u);
}

TEST_F(OutputPlaces, symbolic_links_stay_and_their_file_is_replaced) {
  fs::create_directories(folder_ / "data");
  write_file(folder_ / "data" / "file", "old");
  ASSERT_EQ(::chmod((folder_ / "data" / "file").c_str(), 0640), 0);
  fs::create_symlink("data/file", folder_ / "inner");
  fs::create_symlink(folder_ / "inner", folder_ / "outer");
  write_file(folder_ / "outer", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "outer"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "inner"));
  EXPECT_EQ(content(folder_ / "data" / "file"), "new");
  EXPECT_EQ(mode(folder_ / "data" / "file"), 0640u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "data"), {}), 1);
}

TEST_F(OutputPlaces, link_to_nothing_makes_its_file) {
  fs::create_symlink("target", folder_ / "link");
  write_file(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content(folder_ / "target"), "new");
}

TEST_F(OutputPlaces, links_in_a_circle_are_refused) {
  fs::create_symlink("b", folder_ / "a");
  fs::create_symlink("a", folder_ / "b");
  EXPECT_NE(refusal(folder_ / "a"), "");
  EXPECT_EQ(entries(), 2);
}

TEST_F(OutputPlaces, fifo_passes_the_text_to_its_reader_and_stays) {
  const fs::path fifo = folder_ / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const std::string sent(300000, 'x');  // more than a pipe holds
  std::string received;
  // Opened for both directions nothing waits, whatever the writer does.
  const int reader = ::open(fifo.c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  std::atomic<bool> done{false};
  std::thread reading([&] {
    char buffer[4096];
    for (;;) {
      const bool last = done;
      const ssize_t count = ::read(reader, buffer, sizeof buffer);
      if (count > 0)
        received.append(buffer, static_cast<std::size_t>(count));
      else if (last)
        return;
      else
        std::this_thread::yield();
    }
  });
  const std::string failure = refusal(fifo, sent);
  done = true;
  reading.join();
  ::close(reader);
  EXPECT_EQ(failure, "");
  EXPECT_TRUE(fs::is_fifo(fifo));
  EXPECT_EQ(received.size(), sent.size());
  EXPECT_EQ(entries(), 1);
}

TEST_F(OutputPlaces, reader_that_goes_away_is_an_error_and_no_signal) {
  const fs::path fifo = folder_ / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const int reader = ::open(fifo.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  std::thread leaving([&] {
    char buffer[64];
    while (::read(reader, buffer, sizeof buffer) <= 0) std::this_thread::yield();
    ::close(reader);
  });
  const std::string failure = refusal(fifo, std::string(1 << 22, 'x'));
  leaving.join();
  EXPECT_NE(failure.find(std::strerror(EPIPE)), std::string::npos) << failure;
  EXPECT_TRUE(fs::is_fifo(fifo));
}

TEST_F(OutputPlaces, devices_are_written_to_and_stay) {
  fs::create_symlink("/dev/null", folder_ / "null");
  write_file(folder_ / "null", "text");
  EXPECT_TRUE(fs::is_symlink(folder_ / "null"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  fs::create_symlink("/dev/full", folder_ / "full");
  const std::string failure = refusal(folder_ / "full");
  EXPECT_NE(failure.find(std::strerror(ENOSPC)), std::string::npos) << failure;
  EXPECT_TRUE(fs::is_symlink(folder_ / "full"));
  EXPECT_EQ(entries(), 2);
}

TEST_F(OutputPlaces, device_of_its_own_is_not_unlinked) {
  const fs::path device = folder_ / "null";
  if (::mknod(device.c_str(), S_IFCHR | 0666, makedev(1, 3)) != 0) GTEST_SKIP() << "making a device needs root";
  const std::string failure = refusal(device);  // some systems forbid opening devices outside /dev
  EXPECT_TRUE(fs::is_character_file(device)) << failure;
  EXPECT_EQ(entries(), 1);
}

TEST_F(OutputPlaces, open_files_of_the_process_are_continued) {
  const int number = ::open((folder_ / "log").c_str(), O_CREAT | O_RDWR, 0600);
  ASSERT_GE(number, 0);
  ASSERT_EQ(::write(number, "before\n", 7), 7);
  write_file("/proc/self/fd/" + std::to_string(number), "text\n");
  ::close(number);
  EXPECT_EQ(content(folder_ / "log"), "before\ntext\n");
}

TEST_F(OutputPlaces, sockets_and_folders_are_refused_with_their_kind) {
  fs::create_directories(folder_ / "folder");
  EXPECT_NE(refusal(folder_ / "folder").find("folder; give the name of a file"), std::string::npos);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = (folder_ / "socket").string();
  ASSERT_LT(name.size(), sizeof address.sun_path);
  std::memcpy(address.sun_path, name.c_str(), name.size() + 1);
  const int bound = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(bound, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_NE(refusal(folder_ / "socket").find("socket; give the name of a file"), std::string::npos);
  ::close(bound);
  EXPECT_TRUE(fs::is_socket(folder_ / "socket"));
  EXPECT_EQ(entries(), 2);
}

TEST_F(OutputPlaces, file_that_may_not_be_written_stays) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  write_file(folder_ / "a", "old");
  ASSERT_EQ(::chmod((folder_ / "a").c_str(), 0444), 0);
  EXPECT_NE(refusal(folder_ / "a"), "");
  EXPECT_EQ(content(folder_ / "a"), "old");
}

TEST_F(OutputPlaces, files_of_the_user_with_neighbouring_names_stay) {
  std::ofstream(folder_ / "a.part") << "mine";
  write_file(folder_ / "a", "new");
  EXPECT_EQ(content(folder_ / "a.part"), "mine");
  EXPECT_EQ(entries(), 2);
}

TEST_F(OutputPlaces, names_may_be_as_long_as_the_system_allows) {
  const fs::path path = folder_ / std::string(255, 'n');
  write_file(path, "new");
  EXPECT_EQ(content(path), "new");
}

TEST_F(OutputPlaces, series_is_written_through_and_not_replaced) {
  fs::create_symlink("/dev/null", folder_ / "a.pvd");
  write_pvd(folder_ / "a.pvd", {});
  EXPECT_TRUE(fs::is_symlink(folder_ / "a.pvd"));
}

TEST_F(OutputPlaces, series_refuses_names_that_xml_cannot_hold) {
  write_pvd(folder_ / "a.pvd", {{0, 0, "b\nc.vtu"}});
  const std::string before = content(folder_ / "a.pvd");
  EXPECT_NE(before.find("file=\"b&#10;c.vtu\""), std::string::npos) << before;
  EXPECT_THROW(write_pvd(folder_ / "a.pvd", {{0, 0, "b\x1B.vtu"}}), std::system_error);
  EXPECT_THROW(write_pvd(folder_ / "a.pvd", {{0, 0, "b\xFF.vtu"}}), std::system_error);
  EXPECT_EQ(content(folder_ / "a.pvd"), before);
}

}  // namespace
