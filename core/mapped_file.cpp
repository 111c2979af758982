// SPDX-License-Identifier: Apache-2.0
#include "core/mapped_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace alidade {

tl::expected<std::shared_ptr<const MappedFile>, std::string> MappedFile::open(const std::string& path) {
    const auto failure = [&](const char* why) { return tl::unexpected(fmt::format("cannot read {}: {}", path, why)); };
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) return failure(std::strerror(errno));
    struct stat status {};
    const bool known = ::fstat(file, &status) == 0, regular = known && S_ISREG(status.st_mode);
    const auto size = regular ? size_t(status.st_size) : 0;
    void* const memory = size ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0) : nullptr;
    const int error = errno;
    ::close(file);   // the mapping stays
    if (!known || memory == MAP_FAILED) return failure(std::strerror(error));
    if (!regular) return failure("it is not a regular file");
    return std::shared_ptr<const MappedFile>(new MappedFile({static_cast<const std::byte*>(memory), size}));
}

MappedFile::~MappedFile() {
    if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

}  // namespace alidade
