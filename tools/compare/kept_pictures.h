// SPDX-License-Identifier: Apache-2.0
/// References that are kept, so that a scene that has not changed costs nothing.
#pragma once

#include "tools/compare/reference.h"

#include <optional>

namespace alidade {

/// The pictures of one key, a file each: <cache>/<key>.png, of further seeds <key>-1.exr and so on.
class KeptPictures {
  public:
    KeptPictures(const std::string& cache, const std::string& key, const std::string& ending, int count);
    /// What was kept, without the command that made it.
    std::optional<Rendered> find() const;
    /// A cache that cannot be written costs time, nothing else.
    void keep(const Rendered& rendered) const;

  private:
    std::string seconds_;               ///< the file of the CPU seconds that they cost
    std::vector<std::string> pictures_; ///< the first one is written last: what is there with it is whole
};

/// Where references are kept if nothing else is asked for.
std::string default_cache();

}  // namespace alidade
