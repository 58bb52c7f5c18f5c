#include "program/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "program/descriptor.h"
#include "program/rounding.h"
#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{1} << 16U;

tl::unexpected<Error> refused(const std::string& path, std::string message) {
  return fail(ErrorCode::kFile, std::move(message), {shownText(path)});
}

tl::unexpected<Error> failed(const std::string& path, std::string_view what) {
  return refused(path, fmt::format("{}: {}", what, std::strerror(errno)));
}

tl::unexpected<Error> tooLarge(const std::string& path, std::string_view found, std::uint64_t most) {
  return refused(path, fmt::format("found {}, expected at most {}", found, roundedBytes(most)));
}

/// What is wrong with a file of that kind as input; empty when nothing is.
std::string_view faultInKind(const struct stat& status) {
  if (S_ISDIR(status.st_mode)) return "found a folder, expected a file";
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) return "found a device, expected a file";
  if (S_ISREG(status.st_mode) || S_ISFIFO(status.st_mode)) return {};
  return "found neither a file nor a pipe, expected a file";
}

/// Waits until there is something to read; false when nothing comes.
bool waitFor(int descriptor) {
  struct pollfd waiting {
    descriptor, POLLIN, 0
  };
  return ::poll(&waiting, 1, kPipeMilliseconds) > 0;
}

/// `content` is empty and has room for what is expected; `path` is for messages.
Result<std::string> readAll(const Descriptor& file, const std::string& path, std::uint64_t most,
                            std::string content) {
  for (;;) {
    const std::size_t size = content.size();
    content.resize(size + kBlockBytes);
    const ssize_t count = ::read(file.number(), content.data() + size, kBlockBytes);
    content.resize(size + (count > 0 ? static_cast<std::size_t>(count) : 0));
    if (count == 0) return content;
    if (content.size() > most) return tooLarge(path, "more", most);
    if (count > 0 || errno == EINTR) continue;
    if (errno != EAGAIN) return failed(path, "cannot be read");
    if (!waitFor(file.number()))
      return refused(path, fmt::format("found a pipe that gives nothing for {} s, expected a file",
                                       kPipeMilliseconds / 1000));
  }
}

}  // namespace

Result<std::string> readFile(const std::string& path, std::uint64_t mostBytes) {
  if (path.empty()) return refused("\"\"", "found an empty name, expected that of a file");
  // Without waiting: a pipe that nothing writes to would never open.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (!file.isOpen()) return failed(path, "cannot be opened");
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) return failed(path, "cannot be opened");
  if (const std::string_view fault = faultInKind(status); !fault.empty())
    return refused(path, std::string(fault));
  const bool isPipe = S_ISFIFO(status.st_mode);
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (!isPipe && size > mostBytes) return tooLarge(path, roundedBytes(size), mostBytes);
  std::string room;
  room.reserve(static_cast<std::size_t>(size) + kBlockBytes);
  Result<std::string> content = readAll(file, path, mostBytes, std::move(room));
  if (content && isPipe && content->empty())
    return refused(path, "found a pipe that nothing writes to, expected a file");
  return content;
}

std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string_view textOf(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace stridegraph::tools
