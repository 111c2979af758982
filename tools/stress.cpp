// SPDX-License-Identifier: Apache-2.0
#include "core/image.h"
#include "stress/table.h"
#include "tools/interrupt.h"
#include "tools/stress/document.h"
#include "tools/stress/page.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade {

namespace {

void tell(const StressSource& source, const StressSize& size) {
    if (!size.left_out.empty()) return fmt::print("{}, {} triangles: left out: {}\n\n", source.name, size.asked, size.left_out);
    const StressFigures& f = size.figures;
    fmt::print("{}: {} triangles", source.name, f.triangles);
    if (f.places) fmt::print(" in {} places: {} in all", f.places, f.placed_triangles);
    fmt::print("\n{}\n", stress_table(f));
    std::fflush(stdout);
}

tl::expected<void, std::string> write_files(const StressRequest& request, const StressResults& results, int code) {
    const auto write = [](const std::string& path, const std::string& text) { return write_file(path, std::as_bytes(std::span(text))); };
    tl::expected<void, std::string> done;
    const Json document = stress_document(request, results, code);
    if (!request.csv.empty()) done = write(request.csv, stress_csv(results));
    if (done && !request.json.empty()) done = write(request.json, as_json_text(document));
    if (request.prints_json) fmt::print("{}", as_json_text(document));
    if (done && !request.report.empty()) done = write(request.report, stress_page(document));
    return done;
}

int exit_code(const StressResults& results) {
    if (results.disagreements()) return kError;
    return results.interrupted ? int(kInterrupted) : results.measured() ? int(kDone) : int(kError);
}

/// What ends with another code than 0 says why.
void tell_why(const StressResults& results) {
    if (const size_t count = results.disagreements()) fail(fmt::format("hits differ: {}, said above as WRONG", count == 1 ? "once" : fmt::format("{} times", count)));
    else if (results.interrupted) fmt::print(stderr, "alidade: interrupted; what was measured up to then is told\n");
    else if (!results.measured()) fail("nothing was measured: all was left out, for the reasons above; --time and --memory set the budgets");
}

}  // namespace

int run_stress(const Verb& verb, const Words& given) {
    const auto request = parse_stress_words(verb, given);
    if (!request) return request.error();
    if (request->embree && make_embree_peers().empty()) return fail("--against embree: this program was built without Embree 3, or the system has no libembree3.so.3");
    StressResults results;
    {
        const StopOnSignal signals;
        Progress progress(request->progress, stderr, "steps");
        constexpr size_t kSteps = 1000;
        results = measure_series(*request, signals.stop(), [&](double fraction) { progress.update(size_t(fraction * kSteps), kSteps); }, [&](const StressSource& source, const StressSize& size) {
            progress.hide();
            if (!request->prints_json) tell(source, size);
        });
    }
    fmt::print(stderr, "{}", results.said.text());
    if (results.said.has_errors()) return kError;
    for (const StressSeries& series : results.series)
        if (!series.growth.empty() && !request->prints_json) fmt::print("{}\n{}\n", series.source.name, growth_table(series.growth));
    const int code = exit_code(results);
    tell_why(results);
    if (const auto written = write_files(*request, results, code); !written) return fail(written.error());
    return code;
}

}  // namespace alidade
