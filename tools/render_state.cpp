// SPDX-License-Identifier: Apache-2.0
#include "tools/render_state.h"

#include "core/fingerprint.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace alidade {

namespace {

constexpr std::string_view kMagic = "Alidade tiles 1\n";
constexpr uint32_t kLongestText = 1 << 16;   ///< of a head: ours have some 500 bytes

template <class T> void put(std::vector<std::byte>& out, const T& value) {
    const auto* bytes = reinterpret_cast<const std::byte*>(&value);
    out.insert(out.end(), bytes, bytes + sizeof value);
}
template <class T> T get(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

/// Exactly `size` bytes from `at`, or false.
bool read_at(int file, uint64_t at, std::byte* to, size_t size) {
    while (size) {
        const ssize_t n = ::pread(file, to, size, off_t(at));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        to += n, at += uint64_t(n), size -= size_t(n);
    }
    return true;
}

std::string identity_text(const Identity& identity) {
    std::string out;
    for (const auto& [name, value] : identity) out += fmt::format("{} {}\n", name, value);
    return out;
}

/// The first line in which two heads differ, as a reason.
std::string difference(std::string_view theirs, std::string_view ours) {
    while (!theirs.empty() && !ours.empty()) {
        const std::string_view a = theirs.substr(0, theirs.find('\n')), b = ours.substr(0, ours.find('\n'));
        const size_t name = b.find(' ') + 1;
        if (a != b && a.substr(0, name) == b.substr(0, name)) return fmt::format("it is of another picture: its {} is {}, not {}", b.substr(0, name - 1), a.substr(name), b.substr(name));
        if (a != b) break;
        theirs.remove_prefix(std::min(a.size() + 1, theirs.size())), ours.remove_prefix(b.size() + 1);
    }
    return "it is of another picture";
}

const char* const kDamagedHead = "its head is damaged";
const char* const kCutHead = "its head was cut off";

}  // namespace

RenderState::RenderState(int file, const std::string& path, const TileGrid& grid, int channels, const Warn& warn)
    : file_(file), path_(path), grid_(grid), channels_(channels), warn_(warn), places_(grid.count()) {}

RenderState::~RenderState() { ::close(file_); }

std::unique_ptr<RenderState> RenderState::open(const std::string& path, const TileGrid& grid, int channels, const Identity& identity, bool continued, const Warn& warn) {
    const auto without = [&](const char* why) {
        warn(fmt::format("{}: {}: this picture cannot be continued if it is interrupted", path, why));
        return nullptr;
    };
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);   // non-blocking: a pipe must not hang us
    if (file < 0) return without(std::strerror(errno));
    std::unique_ptr<RenderState> state(new RenderState(file, path, grid, channels, warn));
    struct stat status {};
    if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return without("it is not a regular file");
    if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return without("another process is rendering this picture");
    const std::string head = identity_text(identity);
    const bool anew = !continued || status.st_size == 0;
    const std::string why = anew ? "" : state->take(head);
    if (!why.empty()) warn(fmt::format("{} cannot be continued: {}; the picture is made from its beginning", path, why));
    if (anew || !why.empty()) state->begin(head);
    return state;
}

/// Takes what is there, or says why nothing can be used.
std::string RenderState::take(const std::string& head) {
    std::byte first[kMagic.size() + sizeof(uint32_t)];
    if (!read_at(file_, 0, first, sizeof first)) return kCutHead;
    if (std::memcmp(first, kMagic.data(), kMagic.size()) != 0) return "it is not a state of Alidade";
    const uint32_t size = get<uint32_t>(first + kMagic.size());
    if (size > kLongestText) return kDamagedHead;
    std::vector<std::byte> all(sizeof first + size + sizeof seal_);
    if (!read_at(file_, 0, all.data(), all.size())) return kCutHead;
    seal_ = fingerprint(std::span(all).first(all.size() - sizeof seal_));
    if (get<uint64_t>(&all[all.size() - sizeof seal_]) != seal_) return kDamagedHead;
    const std::string_view text(reinterpret_cast<const char*>(&all[sizeof first]), size);
    if (text != head) return difference(text, head);
    end_ = all.size();
    return take_records();
}

std::string RenderState::take_records() {
    const uint64_t size = uint64_t(std::max<off_t>(::lseek(file_, 0, SEEK_END), 0));
    std::vector<std::byte> record(sizeof(uint32_t));
    while (size - end_ >= sizeof(uint32_t)) {
        if (!read_at(file_, end_, record.data(), sizeof(uint32_t))) return std::strerror(errno);
        const uint32_t tile = get<uint32_t>(record.data());
        const bool possible = tile < places_.size() && !places_[tile];
        if (possible && record_size(tile) > size - end_) break;   // the writer was killed within it
        if (!possible || !read_record(tile, end_, record)) return fmt::format("it is damaged at byte {}", end_);
        places_[tile] = end_;
        end_ += record.size();
        ++known_;
    }
    return ::ftruncate(file_, off_t(end_)) == 0 ? "" : std::strerror(errno);
}

/// An empty state.
void RenderState::begin(const std::string& head) {
    std::fill(places_.begin(), places_.end(), 0);
    known_ = end_ = 0;
    std::vector<std::byte> bytes;
    for (const char c : kMagic) bytes.push_back(std::byte(c));
    put(bytes, uint32_t(head.size()));
    for (const char c : head) bytes.push_back(std::byte(c));
    seal_ = fingerprint(bytes);
    put(bytes, seal_);
    full_ = ::ftruncate(file_, 0) != 0;
    append(bytes);
}

size_t RenderState::record_size(size_t tile) const {
    const Region r = grid_.tile(tile);
    return sizeof(uint32_t) + size_t(r.x1 - r.x0) * size_t(r.y1 - r.y0) * size_t(channels_) * sizeof(float) + sizeof(uint64_t);
}

bool RenderState::read_record(size_t tile, uint64_t at, std::vector<std::byte>& record) const {
    record.resize(record_size(tile));
    const size_t sealed = record.size() - sizeof(uint64_t);
    return read_at(file_, at, record.data(), record.size()) && get<uint64_t>(&record[sealed]) == fingerprint(std::span(record).first(sealed), seal_);
}

bool RenderState::recall(size_t tile, Picture& picture) const {
    std::vector<std::byte> record;
    if (!places_[tile] || !read_record(tile, places_[tile], record)) return false;
    const Region r = grid_.tile(tile);
    const size_t row = size_t(r.x1 - r.x0) * size_t(channels_) * sizeof(float);
    const std::byte* from = &record[sizeof(uint32_t)];
    for (int y = r.y0; y < r.y1; ++y, from += row) std::memcpy(picture.at(r.x0, y), from, row);
    return true;
}

void RenderState::keep(size_t tile, const Picture& picture) {
    std::vector<std::byte> record;
    record.reserve(record_size(tile));
    put(record, uint32_t(tile));
    const Region r = grid_.tile(tile);
    const size_t row = size_t(r.x1 - r.x0) * size_t(channels_) * sizeof(float);
    for (int y = r.y0; y < r.y1; ++y) {
        const auto* from = reinterpret_cast<const std::byte*>(picture.at(r.x0, y));
        record.insert(record.end(), from, from + row);
    }
    put(record, fingerprint(record, seal_));
    const std::lock_guard lock(mutex_);
    append(record);
}

/// All or nothing: half a record would be damage once another follows it.
void RenderState::append(const std::vector<std::byte>& bytes) {
    if (full_) return;
    ssize_t n = 0;
    do n = ::write(file_, bytes.data(), bytes.size());
    while (n < 0 && errno == EINTR);
    if (n == ssize_t(bytes.size())) {
        end_ += bytes.size();
        return;
    }
    full_ = true;
    const char* const why = n < 0 ? std::strerror(errno) : "the disc is full";
    const bool cut = ::ftruncate(file_, off_t(end_)) == 0;
    warn_(fmt::format("{}: {}: what is rendered from now on is lost if this process is interrupted{}", path_, why, cut ? "" : ", and so is what stands there"));
}

void RenderState::remove() { ::unlink(path_.c_str()); }

}  // namespace alidade
