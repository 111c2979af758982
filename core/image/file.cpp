// SPDX-License-Identifier: Apache-2.0
/// Whole files: read within a limit, written all or nothing.
#include "core/image.h"
#include "core/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace alidade {
namespace {

namespace fs = std::filesystem;

/// An open file descriptor, closed at the end of its scope.
class File {
  public:
    explicit File(int descriptor) : descriptor_(descriptor) {}
    ~File() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    bool is_open() const { return descriptor_ >= 0; }
    int get() const { return descriptor_; }

  private:
    int descriptor_;
};

tl::unexpected<std::string> failure(const char* verb, const std::string& path, const std::string& why) {
    return tl::unexpected(fmt::format("cannot {} {}: {}", verb, path, why));
}

std::string last_error() { return std::strerror(errno); }

bool write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return false;
        bytes = bytes.subspan(size_t(n));
    }
    return true;
}

/// Names of what is open already: /dev/stdout, /dev/fd/3, /proc/self/fd/3.
bool is_descriptor(const std::string& path) {
    return path == "/dev/stdout" || path == "/dev/stderr" || path.starts_with("/dev/fd/") || (path.starts_with("/proc/") && path.find("/fd/") != path.npos);
}

/// A device, a pipe, or a descriptor by its name: what stands there stays, and takes the bytes. A pipe without a reader is an error, and not waited for.
bool is_written_in_place(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && (!S_ISREG(status.st_mode) || is_descriptor(path));
}

/// The file that a chain of symbolic links ends at, there or not.
std::string behind_links(const std::string& path) {
    std::error_code error;
    fs::path at = path;
    for (int links = 0; links < 40 && fs::is_symlink(at, error); ++links) {
        const fs::path to = fs::read_symlink(at, error);
        at = to.is_absolute() ? to : at.parent_path() / to;
    }
    return at.string();
}

}  // namespace

tl::expected<std::vector<std::byte>, std::string> read_file(const std::string& path, uint64_t limit) {
    const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));   // non-blocking: a pipe without a writer must not hang us
    if (!file.is_open()) return failure("read", path, last_error());
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) return failure("read", path, last_error());
    if (S_ISDIR(status.st_mode)) return failure("read", path, "it is a directory");
    if (!S_ISREG(status.st_mode)) return failure("read", path, "it is not a regular file");
    if (uint64_t(status.st_size) > limit) return failure("read", path, fmt::format("it has {} bytes, the limit is {}", status.st_size, limit));

    std::vector<std::byte> bytes(static_cast<size_t>(status.st_size));
    size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t n = ::read(file.get(), bytes.data() + filled, bytes.size() - filled);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return failure("read", path, last_error());
        if (n == 0) break;   // it shrank meanwhile
        filled += size_t(n);
    }
    bytes.resize(filled);
    return bytes;
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
    if (is_written_in_place(path_)) {
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
        check(descriptor_ >= 0);
        if (good()) ::fcntl(descriptor_, F_SETFL, 0);
        return;
    }
    static std::atomic<unsigned> count{0};
    target_ = behind_links(path_);
    const std::string temporary = fmt::format("{}.{}-{}.part", target_, ::getpid(), count++);
    descriptor_ = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    check(descriptor_ >= 0);
    if (good()) temporary_ = temporary;
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::check(bool done) {
    if (!done && good()) error_ = failure("write", path_, last_error()).value();
}

void OutputFile::write(std::span<const std::byte> bytes) {
    if (good()) check(write_all(descriptor_, bytes));
}

tl::expected<void, std::string> OutputFile::finish() {
    if (good()) check(::close(std::exchange(descriptor_, -1)) == 0);   // a full disc may say so only here
    if (good() && !temporary_.empty()) check(std::rename(temporary_.c_str(), target_.c_str()) == 0);
    if (!good()) return tl::unexpected(error_);
    temporary_.clear();
    return {};
}

tl::expected<void, std::string> write_file(const std::string& path, std::span<const std::byte> bytes) {
    OutputFile file(path);
    file.write(bytes);
    return file.finish();
}

}  // namespace alidade
