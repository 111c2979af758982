// SPDX-License-Identifier: Apache-2.0
/// What is measured already: a line of JSON each, appended as it comes, so that a run that was killed goes on.
#pragma once

#include "tools/json.h"
#include "tools/values.h"

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <map>

namespace alidade::tradeoff {

class Store {
  public:
    /// In memory alone.
    Store() = default;
    /// In `folder`, which is made if it is not there. `head` says what the measurements are of: a folder of other ones is refused.
    static Value<Store> open(const std::string& folder, const Json& head);
    /// What a folder holds, of whatever; what is kept then is kept in memory alone.
    static Value<Store> read(const std::string& folder);

    const Json* find(const std::string& key) const;
    /// Hands what is known of `key` to `reader`. What it cannot read (Json::exception) counts as not measured. Was it read?
    template <class Reader> bool read(const std::string& key, Reader&& reader) const {
        const Json* known = find(key);
        if (!known) return false;
        try {
            return reader(*known), true;
        } catch (const Json::exception&) {
            return false;
        }
    }
    /// An error: it cannot be written.
    Value<bool> keep(const std::string& key, Json value);
    /// "" in memory.
    const std::string& folder() const { return folder_; }

  private:
    /// Is the last line cut off?
    bool take(std::istream& lines);

    std::string folder_;
    std::map<std::string, Json> known_;
};

}  // namespace alidade::tradeoff
