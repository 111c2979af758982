// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cfenv>

namespace alidade {

/// The default floating-point mode while it lives: a caller that rounds otherwise or flushes denormals must not change what is computed.
class DefaultFloatMode {
  public:
    DefaultFloatMode() {
        std::fegetenv(&saved_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~DefaultFloatMode() { std::fesetenv(&saved_); }
    DefaultFloatMode(const DefaultFloatMode&) = delete;
    DefaultFloatMode& operator=(const DefaultFloatMode&) = delete;

  private:
    std::fenv_t saved_;
};

}  // namespace alidade
