#include "lab/triangle/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cpu_time.h"
#include "lab/triangle/kernel_run.h"

namespace carom::render::triangle {

namespace {

constexpr std::array kPrecisions = {Precision::single_precision, Precision::double_precision};

/// Millions of tests per second: the better of two runs after one that warms the caches.
double rate_of(const Variant& variant, const TestSet& set) {
    const auto run = make_run(variant, set);
    run->run();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i) {
        const double start = thread_cpu_seconds();
        run->run();
        least = std::min(least, thread_cpu_seconds() - start);
    }
    return 1e-6 * static_cast<double>(set.test_count()) / std::max(least, 1e-9);
}

double slipped_fraction(const Form& form, Precision precision, const TestSet& edges) {
    const auto run = make_run({form, Packing::single, precision}, edges);
    run->run();
    const std::vector<NearestHit> hits = run->hits();
    const auto missed =
        std::ranges::count_if(hits, [](const NearestHit& hit) { return hit.triangle < 0; });
    return static_cast<double>(missed) / static_cast<double>(hits.size());
}

FormErrors errors_of(const Form& form, Precision precision, const TestSet& set,
                     const std::vector<NearestHit>& reference) {
    FormErrors errors{form, precision};
    const auto run = make_run({form, Packing::single, precision}, set);
    run->run();
    const std::vector<NearestHit> hits = run->hits();
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
    return errors;
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

bool measure_errors(const std::vector<Form>& forms, const MeasureOptions& options, Steps& steps,
                    KernelMeasurements& result) {
    const TestSet set = make_random_set(options.error_groups, options.seed);
    const TestSet edges = make_edge_set(64 * options.error_groups, options.seed);
    for (const Precision precision : kPrecisions) {
        const std::vector<NearestHit> reference = reference_hits(precision, set);
        for (const Form& form : forms) {
            if (!steps.next()) {
                return false;
            }
            FormErrors errors = errors_of(form, precision, set, reference);
            errors.slipped = slipped_fraction(form, precision, edges);
            result.errors.push_back(errors);
        }
    }
    return true;
}

bool measure_rates(const MeasureOptions& options, Steps& steps, KernelMeasurements& result) {
    const TestSet random = make_random_set(options.groups, options.seed + 1);
    const TestSet worst = make_worst_set(options.groups, options.seed + 2);
    for (int round = 0; round < options.rounds; ++round) {
        for (VariantRates& rates : result.rates) {
            if (!steps.next()) {
                return false;
            }
            rates.random.push_back(rate_of(rates.variant, random));
            rates.worst.push_back(rate_of(rates.variant, worst));
        }
    }
    return true;
}

}  // namespace

KernelMeasurements measure_kernels(const MeasureOptions& options, const WorkContext& context) {
    std::vector<Form> forms;
    KernelMeasurements result;
    for (const Form& form : all_forms()) {
        if (std::ranges::find(options.kernels, form.kernel) == options.kernels.end()) {
            continue;
        }
        forms.push_back(form);
        for (const Precision precision : kPrecisions) {
            for (const Packing packing : kPackings) {
                result.rates.push_back({{form, packing, precision}, {}, {}});
            }
        }
    }
    Steps steps(2 * forms.size() + static_cast<unsigned>(options.rounds) * result.rates.size(),
                context);
    result.is_whole =
        measure_errors(forms, options, steps, result) && measure_rates(options, steps, result);
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
