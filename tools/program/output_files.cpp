#include "program/output_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "program/descriptor.h"
#include "program/file_identity.h"
#include "program/files.h"
#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

constexpr int kMostPartNames = 1000;
constexpr mode_t kNewFileMode = 0666;  // Less what the umask takes away.
constexpr mode_t kPermissionBits = 07777;

tl::unexpected<Error> failed(const std::string& path, std::string_view what) {
  return fail(ErrorCode::kFile, fmt::format("{}: {}", what, std::strerror(errno)), {shownText(path)});
}

tl::unexpected<Error> cannotWrite(const std::string& path) {
  return failed(path, "cannot be written");
}

/// Waits until a pipe takes more; false when nobody reads.
bool waitFor(int descriptor) {
  struct pollfd waiting {
    descriptor, POLLOUT, 0
  };
  return ::poll(&waiting, 1, kPipeMilliseconds) > 0;
}

bool writeAll(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count >= 0)
      content.remove_prefix(static_cast<std::size_t>(count));
    else if (errno == EAGAIN && !waitFor(descriptor)) {
      errno = ETIMEDOUT;
      return false;
    } else if (errno != EAGAIN && errno != EINTR)
      return false;
  }
  return true;
}

/// Pipes and devices cannot be flushed; their errors come with writing.
bool flush(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS || errno == ENOTSUP;
}

/// The descriptor that a path names: /dev/stdout, /dev/stderr, /dev/fd/N.
std::optional<int> descriptorOf(const std::string& path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string digits = path.substr(folder.size());
    int number = -1;
    const auto [end, wrong] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (wrong == std::errc() && end == digits.data() + digits.size() && number >= 0) return number;
  }
  return std::nullopt;
}

Result<void> writeDirectly(const std::string& path, std::string_view content) {
  std::fflush(stdout);
  const std::optional<int> number = descriptorOf(path);
  Descriptor file(number ? ::dup(*number)
                         : ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (!file.isOpen() && errno == ENXIO)
    return fail(ErrorCode::kFile, "found a pipe that nobody reads, expected a file", {shownText(path)});
  if (!file.isOpen() || !writeAll(file.number(), content) || !flush(file.number()) || !file.close())
    return cannotWrite(path);
  return {};
}

/// An open temporary file beside the target.
struct Part {
  std::string path;
  int descriptor = -1;
};

Part openPart(const std::string& target) {
  for (int i = 0; i < kMostPartNames; ++i) {
    Part part{fmt::format("{}/.stridegraph-{}-{}.part", folderOf(target), ::getpid(), i)};
    part.descriptor = ::open(part.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
    if (part.descriptor >= 0 || errno != EEXIST) return part;
  }
  return {};
}

/// Owner and permissions of the file that is replaced; the owner only where that is allowed.
bool takeAfter(const struct stat& before, int descriptor) {
  const bool isGiven = ::fchown(descriptor, before.st_uid, before.st_gid) == 0;
  // Rights to act as the owner are not handed to another one.
  const mode_t mode = before.st_mode & (isGiven ? kPermissionBits : kNewFileMode);
  return ::fchmod(descriptor, mode) == 0;
}

}  // namespace

OutputFiles::OutputFiles() = default;

OutputFiles::~OutputFiles() {
  for (const Pending& pending : pending_) {
    if (!pending.part.empty()) ::unlink(pending.part.c_str());
  }
  if (signalsBefore_) ::sigprocmask(SIG_SETMASK, &*signalsBefore_, nullptr);
}

void OutputFiles::holdSignals() {
  if (signalsBefore_) return;
  sigset_t held{};
  sigemptyset(&held);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&held, signal);
  signalsBefore_.emplace();
  ::sigprocmask(SIG_BLOCK, &held, &*signalsBefore_);
}

Result<void> OutputFiles::add(const std::string& path, std::string_view content) {
  holdSignals();
  Pending pending{path, path, {}, {}};
  struct stat before {};
  if (!descriptorOf(path)) {
    pending.target = resolveLinks(path);
    const bool isThere = ::stat(path.c_str(), &before) == 0;
    if (isThere && S_ISDIR(before.st_mode))
      return fail(ErrorCode::kFile, "found a folder, expected a file", {shownText(path)});
    if (isThere && S_ISBLK(before.st_mode))
      return fail(ErrorCode::kFile, "found a disk, expected a file", {shownText(path)});
    if (!isThere || S_ISREG(before.st_mode)) return addPart(std::move(pending), content);
  }
  pending.content = content;
  pending_.push_back(std::move(pending));
  return {};
}

Result<void> OutputFiles::add(const std::string& path, std::span<const std::uint8_t> bytes) {
  return add(path, textOf(bytes));
}

Result<void> OutputFiles::addPart(Pending pending, std::string_view content) {
  struct stat before {};
  const bool isThere = ::stat(pending.target.c_str(), &before) == 0;
  // A file that may not be written to is not replaced either.
  if (isThere && ::access(pending.target.c_str(), W_OK) != 0) return cannotWrite(pending.path);
  const Part part = openPart(pending.target);
  Descriptor file(part.descriptor);
  if (!file.isOpen()) return failed(pending.path, "cannot be written, since its folder takes no new file");
  pending.part = part.path;
  pending_.push_back(pending);
  if (isThere && !takeAfter(before, file.number())) return cannotWrite(pending.path);
  if (!writeAll(file.number(), content) || !flush(file.number()) || !file.close())
    return cannotWrite(pending.path);
  return {};
}

Result<void> OutputFiles::commit() {
  for (const Pending& pending : pending_) {
    if (!pending.part.empty()) continue;
    if (auto written = writeDirectly(pending.path, pending.content); !written) return written;
  }
  for (Pending& pending : pending_) {
    if (pending.part.empty()) continue;
    if (std::rename(pending.part.c_str(), pending.target.c_str()) != 0) return cannotWrite(pending.path);
    pending.part.clear();
  }
  pending_.clear();
  return {};
}

Result<void> writeFile(const std::string& path, std::string_view content) {
  OutputFiles files;
  if (auto added = files.add(path, content); !added) return added;
  return files.commit();
}

Result<void> writeFile(const std::string& path, std::span<const std::uint8_t> bytes) {
  return writeFile(path, textOf(bytes));
}

bool isStandardOutput(const std::string& path) {
  return descriptorOf(path) == STDOUT_FILENO;
}

bool isFileThere(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

Result<void> makeFolder(const std::string& folder) {
  std::error_code wrong;
  std::filesystem::create_directories(folder, wrong);
  if (wrong)
    return fail(ErrorCode::kFile, fmt::format("cannot be made: {}", wrong.message()), {shownText(folder)});
  if (!std::filesystem::is_directory(folder, wrong))
    return fail(ErrorCode::kFile, "found a file, expected a folder", {shownText(folder)});
  return {};
}

}  // namespace stridegraph::tools
