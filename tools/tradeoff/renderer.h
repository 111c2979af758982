// SPDX-License-Identifier: Apache-2.0
/// Settings to pictures, in this process.
#pragma once

#include "tools/options.h"
#include "tools/values.h"
#include "tracer/render.h"

#include <map>

namespace alidade::tradeoff {

struct Run {
    Picture picture;              ///< R G B, linear
    RenderStats stats;
    double build_seconds = 0;     ///< CPU, all threads; of compile()
    double cpu_seconds() const { return build_seconds + stats.cpu_seconds; }
};

class Renderer {
  public:
    /// Reads (or, of an analytic scene, makes), compiles, renders. `reading` stands for what decides how the scene is read: one that was read already is not
    /// read again. What has to be said is said once, on stderr; an error is "" if it was said there.
    Value<Run> run(const Request& request, const std::string& reading, const Monitor& monitor = {});
    /// The scene ready for its rays.
    Value<std::shared_ptr<const CompiledScene>> compiled(const Request& request, const std::string& reading);

  private:
    Value<std::shared_ptr<const Scene>> scene(const Request& request, const std::string& reading);
    void say(const Diagnostics& said);

    std::map<std::string, std::shared_ptr<const Scene>> scenes_;
    std::map<std::string, bool> said_;
};

}  // namespace alidade::tradeoff
