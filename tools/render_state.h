// SPDX-License-Identifier: Apache-2.0
/// The finished tiles of a picture under way, in a file beside it: a render that was killed goes on from them.
///
/// File     A head, which says what the picture is made of; then a record for each finished tile, in the order in which they were finished: its
///          number, its pixels, a checksum. docs/pov-support.md has the bytes.
/// Safety   A record is appended by one write, so that the file is good whenever its writer is killed: a last record that was cut off is dropped.
///          Every checksum begins with that of the head, so a record counts in its own file alone. All that is read is checked: of a file that is
///          damaged, or belongs to another picture, nothing is used. What is read is never more than a state of this picture can have.
#pragma once

#include "tools/identity.h"
#include "tracer/tiles.h"

#include <functional>
#include <memory>
#include <mutex>

namespace alidade {

class RenderState {
  public:
    using Warn = std::function<void(const std::string& sentence)>;

    /// The state of a picture with `channels` floats a pixel, in the file `path`. If it is to be continued, with the tiles that are there; `warn` says
    /// why none can be used. Null, and a warning, if there can be no such file: then the picture is made without.
    static std::unique_ptr<RenderState> open(const std::string& path, const TileGrid& grid, int channels, const Identity& identity, bool continued, const Warn& warn);

    RenderState(const RenderState&) = delete;
    ~RenderState();

    /// The tiles that were there at the beginning.
    size_t known() const { return known_; }
    /// Monitor::recall and Monitor::keep: for several threads at once.
    bool recall(size_t tile, Picture& picture) const;
    void keep(size_t tile, const Picture& picture);
    /// The picture is done.
    void remove();

  private:
    RenderState(int file, const std::string& path, const TileGrid& grid, int channels, const Warn& warn);
    std::string take(const std::string& head);
    std::string take_records();
    void begin(const std::string& head);
    bool read_record(size_t tile, uint64_t at, std::vector<std::byte>& record) const;
    size_t record_size(size_t tile) const;
    void append(const std::vector<std::byte>& bytes);

    const int file_;
    const std::string path_;
    const TileGrid grid_;
    const int channels_;
    const Warn warn_;
    uint64_t seal_ = 0;                ///< the checksum of the head
    uint64_t end_ = 0;                 ///< of the good bytes
    bool full_ = false;                ///< a write has failed: nothing is kept any more
    size_t known_ = 0;
    std::vector<uint64_t> places_;     ///< of the known tiles' records; 0: not known
    std::mutex mutex_;
};

}  // namespace alidade
