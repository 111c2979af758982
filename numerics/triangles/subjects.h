// SPDX-License-Identifier: Apache-2.0
/// The accelerators that rows of the suite ask, and the meshes that they are asked about.
#pragma once

#include "numerics/suite.h"
#include "numerics/triangles/compare.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace alidade::numerics {

/// What rows ask about. To be set before rows begin.
const NumericsAsked& asked();
void ask(const NumericsAsked& what);
/// The precision that a case draws, unless one alone is asked about.
Precision precision_of(bool is_double);

/// A row of the registry in a precision.
struct Subject {
    const AcceleratorEntry* entry;
    Precision precision;
    bool usual;   ///< the structure that renders take when nobody asks for another
    Intersect intersect = asked().intersect;

    std::string text() const;
};
/// All but brute force, in the precisions and with the test that are asked about.
std::span<const Subject> subjects();
/// Those, and where the exact test is asked about the robust ones behind them: nothing may leak with either.
std::span<const Subject> watertight_subjects();

/// A structure over a mesh as it sees it.
struct Built {
    Subject subject;
    TriangleMesh mesh;
    std::unique_ptr<Accelerator> accelerator;

    Built(const Subject& of, const TriangleMesh& source);
    /// For failures: who, over what, asked what.
    std::string text(const Ray& ray) const;
};
/// All subjects of that precision.
std::vector<Built> built(Precision precision, const TriangleMesh& source);

/// Those over one mesh; brute force is the last.
struct Compared {
    TriangleMesh mesh;
    std::vector<Built> structures;

    Compared(Precision precision, const TriangleMesh& source);
};

/// What neighbouring cases share: made when the first of them asks for it, from its number alone, and kept until another is asked for.
template <class T> class Shared {
  public:
    template <class Make> T& at(uint64_t number, Make&& make) {
        if (!value_ || number != number_) value_ = std::make_unique<T>(make(number)), number_ = number;
        return *value_;
    }

  private:
    uint64_t number_ = 0;
    std::unique_ptr<T> value_;
};

}  // namespace alidade::numerics
