#include "lab/triangle/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cpu_time.h"
#include "lab/triangle/kernel_run.h"

namespace carom::render::triangle {

namespace {

bool contains(const auto& list, const auto& item) {
    return std::ranges::find(list, item) != list.end();
}

/// Millions of tests per second: the better of two runs after one that warms the caches.
double rate_of(const KernelLibrary& library, const Variant& variant, const TestSet& set) {
    const auto run = library.make_run(variant, set);
    run->run();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i) {
        const double start = thread_cpu_seconds();
        run->run();
        least = std::min(least, thread_cpu_seconds() - start);
    }
    return 1e-6 * static_cast<double>(set.test_count()) / std::max(least, 1e-9);
}

std::vector<NearestHit> hits_of(const KernelLibrary& library, const FormErrors& of,
                                const TestSet& set) {
    const auto run = library.make_run({of.form, Packing::single, of.precision, of.technique}, set);
    run->run();
    return run->hits();
}

double slipped_fraction(const std::vector<NearestHit>& hits) {
    const auto missed =
        std::ranges::count_if(hits, [](const NearestHit& hit) { return hit.triangle < 0; });
    return static_cast<double>(missed) / static_cast<double>(hits.size());
}

void set_errors(FormErrors& errors, const std::vector<NearestHit>& hits,
                const std::vector<NearestHit>& reference) {
    errors.rays = static_cast<std::int64_t>(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const NearestHit& expected = reference[i];
        if (hits[i].triangle != expected.triangle) {
            errors.others += 1;
        } else if (expected.triangle >= 0) {
            errors.hits += 1;
            errors.distance += std::abs(hits[i].t - expected.t) / expected.t;
            errors.weights += 0.5 * (std::abs(hits[i].u - expected.u) / expected.u +
                                     std::abs(hits[i].v - expected.v) / expected.v);
        }
    }
    const double count = static_cast<double>(std::max<std::int64_t>(errors.hits, 1));
    errors.distance /= count;
    errors.weights /= count;
}

/// Steps of about the same duration.
class Steps {
  public:
    Steps(std::size_t total, const WorkContext& context) : total_(total), context_(context) {}

    /// Returns false when no step is left.
    [[nodiscard]] bool next() {
        if (context_.stop.stop_requested()) {
            return false;
        }
        if (context_.progress) {
            context_.progress(static_cast<double>(done_) / static_cast<double>(total_));
        }
        done_ += 1;
        return true;
    }
    void finish() const {
        if (context_.progress) {
            context_.progress(1);
        }
    }

  private:
    std::size_t total_;
    std::size_t done_ = 0;
    const WorkContext& context_;
};

/// What is to be measured, without results.
KernelMeasurements planned(const MeasureOptions& options) {
    KernelMeasurements plan;
    for (const KernelLibrary& library : options.libraries) {
        plan.compilers.push_back(library.compiler);
    }
    for_each_variant([&](const Variant& variant) {
        if (!contains(options.kernels, variant.form.kernel) ||
            (variant.technique != Technique::plain &&
             !contains(options.techniques, variant.technique))) {
            return;
        }
        for (std::size_t library = 0; library < options.libraries.size(); ++library) {
            plan.rates.push_back({variant, library, {}, {}, {}});
            if (variant.packing == Packing::single &&
                (variant.technique == Technique::plain || changes_numbers(variant.technique))) {
                plan.errors.push_back(
                    {variant.form, variant.precision, variant.technique, library});
            }
        }
    });
    return plan;
}

bool measure_errors(const MeasureOptions& options, Steps& steps, std::vector<FormErrors>& results) {
    const TestSet set = make_random_set(options.error_groups, options.seed);
    const TestSet edges = make_edge_set(64 * options.error_groups, options.seed);
    const std::array references = {reference_hits(Precision::single_precision, set),
                                   reference_hits(Precision::double_precision, set)};
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (!steps.next()) {
            results.resize(i);
            return false;
        }
        FormErrors& errors = results[i];
        const KernelLibrary& library = options.libraries[errors.library];
        set_errors(errors, hits_of(library, errors, set),
                   references[static_cast<std::size_t>(errors.precision)]);
        errors.slipped = slipped_fraction(hits_of(library, errors, edges));
    }
    return true;
}

/// The sets of a measurement; those that exceed the caches only if layouts are measured.
class TimedSets {
  public:
    explicit TimedSets(const MeasureOptions& options)
        : random_(make_random_set(options.groups, options.seed + 1)),
          worst_(make_worst_set(options.groups, options.seed + 2)),
          has_streamed_(contains(options.techniques, Technique::arrays) ||
                        contains(options.techniques, Technique::structures)) {
        if (has_streamed_) {
            triangles_ = make_streamed_set(8, options.streamed, options.seed + 3);
            rays_ = make_streamed_set(options.streamed, 8, options.seed + 4);
        }
    }

    void measure(const KernelLibrary& library, VariantRates& rates) const {
        const Variant& variant = rates.variant;
        rates.random.push_back(rate_of(library, variant, set_for(variant.technique, random_)));
        rates.worst.push_back(rate_of(library, variant, set_for(variant.technique, worst_)));
        if (has_streamed_ && has_layouts(variant)) {
            const TestSet& streamed = is_several_rays(variant.packing) ? rays_ : triangles_;
            rates.streamed.push_back(rate_of(library, variant, streamed));
        }
    }

  private:
    static bool has_layouts(Variant variant) {
        const bool is_layout = variant.technique == Technique::plain ||
                               variant.technique == Technique::arrays ||
                               variant.technique == Technique::structures;
        variant.technique = Technique::arrays;
        return is_layout && exists(variant);
    }

    TestSet random_, worst_;
    bool has_streamed_;
    TestSet triangles_, rays_;
};

bool measure_rates(const MeasureOptions& options, Steps& steps,
                   std::vector<VariantRates>& results) {
    const TimedSets sets(options);
    for (int round = 0; round < options.rounds; ++round) {
        for (VariantRates& rates : results) {
            if (!steps.next()) {
                return false;
            }
            sets.measure(options.libraries[rates.library], rates);
        }
    }
    return true;
}

}  // namespace

KernelMeasurements measure_kernels(const MeasureOptions& options, const WorkContext& context) {
    KernelMeasurements result = planned(options);
    Steps steps(result.errors.size() + static_cast<unsigned>(options.rounds) * result.rates.size(),
                context);
    result.is_whole = measure_errors(options, steps, result.errors) &&
                      measure_rates(options, steps, result.rates);
    std::erase_if(result.rates, [](const VariantRates& rates) { return rates.worst.empty(); });
    if (result.is_whole) {
        steps.finish();
    }
    return result;
}

double best_rate(const std::vector<double>& rates) {
    return rates.empty() ? 0 : *std::ranges::max_element(rates);
}

double middle_ratio(const std::vector<double>& rates, const std::vector<double>& others) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(rates.size(), others.size()); ++i) {
        ratios.push_back(rates[i] / others[i]);
    }
    if (ratios.empty()) {
        return 0;
    }
    std::ranges::sort(ratios);
    return 0.5 * (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]);
}

}  // namespace carom::render::triangle
