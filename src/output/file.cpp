#include "output/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <linux/magic.h>
#include <sys/vfs.h>
#endif

#include <atomic>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>
#include <utility>

#include "output/utf8.hpp"

namespace bempd::output {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int reason, const char* detail = "") {
  throw std::system_error(reason, std::generic_category(), "cannot write " + printable(path.native()) + detail);
}

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC | O_NOCTTY, 0666)) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }

  bool write(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t written = ::write(number_, content.data(), content.size());
      if (written < 0) return false;
      content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  bool close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0;
  }

 private:
  int number_;
};

// Scope without the signal SIGPIPE, which would end the host if the reader of a FIFO goes away while the FIFO is
// written. The signal is blocked in this thread, and removed at the end of the scope if it was not pending before.
class WithoutBrokenPipe {
 public:
  WithoutBrokenPipe() {
    sigset_t pending;
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~WithoutBrokenPipe() {
    const int kept = errno;
    sigset_t pending;
    sigpending(&pending);
    int taken = 0;
    if (!was_pending_ && sigismember(&pending, SIGPIPE) == 1) sigwait(&pipe_, &taken);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = kept;
  }
  WithoutBrokenPipe(const WithoutBrokenPipe&) = delete;
  WithoutBrokenPipe& operator=(const WithoutBrokenPipe&) = delete;

 private:
  sigset_t pipe_, before_;
  bool was_pending_;
};

struct Place {
  fs::path target;  // file at the end of symbolic links, which need not exist
  // Whether the path leads over a link that the system keeps for an open file, such as /proc/self/fd/1.
  bool open_already;
};

// Whether the system keeps links for open files in a folder. Only Linux has such folders.
bool has_open_files([[maybe_unused]] const fs::path& folder) {
#ifdef __linux__
  struct statfs system {};
  return ::statfs(folder.empty() ? "." : folder.c_str(), &system) == 0 && system.f_type == PROC_SUPER_MAGIC;
#else
  return false;
#endif
}

Place place_of(const fs::path& path) {
  constexpr int most_links = 40;  // as Linux itself
  fs::path target = path;
  for (int links = 0; links <= most_links; ++links) {
    std::error_code none;
    const fs::path next = fs::read_symlink(target, none);
    if (none) return {target, false};
    const fs::path folder = target.parent_path();
    if (has_open_files(folder)) return {target, true};
    target = folder / next;
  }
  fail(path, ELOOP);
}

void write_through(const fs::path& path, const fs::path& target, int flags, std::string_view content) {
  const WithoutBrokenPipe guard;
  Descriptor file(target, O_WRONLY | flags);
  if (!file.is_open() || !file.write(content) || !file.close()) fail(path, errno);
}

// Name of the unfinished file, which lies in the folder of the target so that it can take the target's place. The name
// is short, because the target's own name may be as long as the system allows.
fs::path unfinished_name(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  return target.parent_path() / (".bempd_" + std::to_string(::getpid()) + "_" + std::to_string(count++) + ".part");
}

void replace(const fs::path& path, const fs::path& target, const struct stat* old, std::string_view content,
             bool to_disk) {
  if (old != nullptr && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) fail(path, errno);
  const fs::path unfinished = unfinished_name(target);
  Descriptor file(unfinished, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open()) fail(path, errno);
  if (old != nullptr) {
    // The new file gets owner and mode of the old one as far as the file system and the rights of the process allow.
    [[maybe_unused]] const bool same_owner = ::fchown(file.number(), old->st_uid, old->st_gid) == 0;
    [[maybe_unused]] const bool same_mode = ::fchmod(file.number(), old->st_mode & 0777) == 0;
  }
  const bool written = file.write(content) && (!to_disk || ::fsync(file.number()) == 0);
  if (written && file.close() && ::rename(unfinished.c_str(), target.c_str()) == 0) return;
  const int reason = errno;
  ::unlink(unfinished.c_str());
  fail(path, reason);
}

}  // namespace

fs::path path_from_utf8(std::string_view utf8) { return fs::path(std::u8string(utf8.begin(), utf8.end())); }

void write_file(const fs::path& path, std::string_view content, bool to_disk) {
  const Place place = place_of(path);
  struct stat found {};
  if (::stat(place.target.c_str(), &found) != 0) {
    if (errno != ENOENT) fail(path, errno);
    return replace(path, place.target, nullptr, content, to_disk);
  }
  // Content is appended to a file that this process has open for its own output. Other regular files are replaced as a
  // whole, so that they never have half of the content.
  if (S_ISDIR(found.st_mode)) fail(path, EISDIR, ", which is a folder; give the name of a file");
  if (S_ISSOCK(found.st_mode)) fail(path, ENOTSUP, ", which is a socket; give the name of a file");
  if (S_ISBLK(found.st_mode)) fail(path, ENOTSUP, ", which is a disk; give the name of a file");
  if (place.open_already) return write_through(path, place.target, O_APPEND, content);
  if (S_ISREG(found.st_mode)) return replace(path, place.target, &found, content, to_disk);
  write_through(path, place.target, 0, content);
}

std::vector<std::uint8_t> read_file(const fs::path& path) {
  const auto refuse = [&](int reason) {
    throw std::system_error(reason, std::generic_category(), "cannot read " + printable(path.native()));
  };
  Descriptor file(path, O_RDONLY);
  if (!file.is_open()) refuse(errno);
  std::vector<std::uint8_t> bytes;
  constexpr std::size_t piece = 1 << 20;
  for (;;) {
    const std::size_t size = bytes.size();
    bytes.resize(size + piece);
    const ssize_t got = ::read(file.number(), bytes.data() + size, piece);
    if (got < 0) refuse(errno);
    bytes.resize(size + static_cast<std::size_t>(got));
    if (got == 0) return bytes;
  }
}

}  // namespace bempd::output
