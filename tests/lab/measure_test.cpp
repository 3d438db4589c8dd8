// Tests of what is measured, not of the speed.
#include "lab/triangle/measure.h"

#include <gtest/gtest.h>

namespace carom::render::triangle {
namespace {

MeasureOptions small_options() {
    MeasureOptions options;
    options.kernels = {KernelName::wald, KernelName::keidy};
    options.rounds = 2;
    options.groups = 1;
    options.error_groups = 8;
    return options;
}

TEST(MeasureKernels, TwoKernels_EveryFormPackingAndPrecision) {
    std::vector<double> fractions;
    WorkContext context;
    context.progress = [&](double fraction) { fractions.push_back(fraction); };
    const KernelMeasurements measured = measure_kernels(small_options(), context);
    EXPECT_TRUE(measured.is_whole);
    EXPECT_EQ(measured.errors.size(), 6u * 2);  // Wald's has two forms, Keidy's four
    EXPECT_EQ(measured.rates.size(), 6u * 2 * 5);
    for (const VariantRates& rates : measured.rates) {
        EXPECT_EQ(rates.random.size(), 2u);
        EXPECT_EQ(rates.worst.size(), 2u);
        EXPECT_GT(best_rate(rates.random), 0);
        EXPECT_GT(best_rate(rates.worst), 0);
    }
    EXPECT_EQ(fractions.front(), 0);
    EXPECT_EQ(fractions.back(), 1);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
}

/// In float at most some millionths, in double some 1e-14.
TEST(MeasureKernels, Errors_AreRoundings) {
    MeasureOptions options = small_options();
    for (int i = 0; i < kKernelCount; ++i) {
        options.kernels.push_back(static_cast<KernelName>(i));
    }
    options.rounds = 0;
    const KernelMeasurements measured = measure_kernels(options, {});
    EXPECT_EQ(measured.errors.size(), 2 * all_forms().size());
    EXPECT_TRUE(measured.rates.empty());
    for (const FormErrors& errors : measured.errors) {
        const bool is_float = errors.precision == Precision::single_precision;
        EXPECT_GT(errors.hits, 200);
        EXPECT_EQ(errors.others, 0);
        EXPECT_EQ(errors.slipped > 0, is_float);
        EXPECT_LT(errors.slipped, 0.2);
        EXPECT_GT(errors.distance, is_float ? 1e-8 : 1e-17);
        EXPECT_LT(errors.distance, is_float ? 1e-5 : 1e-14);
        EXPECT_GT(errors.weights, is_float ? 1e-8 : 1e-17);
        EXPECT_LT(errors.weights, is_float ? 2e-5 : 2e-14);
    }
}

TEST(MeasureKernels, Stopped_KeepsWhatIsDone) {
    std::stop_source stop;
    int steps = 0;
    WorkContext context;
    context.stop = stop.get_token();
    context.progress = [&](double) {
        steps += 1;
        if (steps == 12 + 7) {  // the errors, then variants
            stop.request_stop();
        }
    };
    const KernelMeasurements measured = measure_kernels(small_options(), context);
    EXPECT_FALSE(measured.is_whole);
    EXPECT_EQ(measured.errors.size(), 12u);
    ASSERT_EQ(measured.rates.size(), 7u);
    EXPECT_EQ(measured.rates[6].random.size(), 1u);
    EXPECT_EQ(measured.rates[6].worst.size(), 1u);
}

TEST(Rates, BestAndMiddle_OfRounds) {
    EXPECT_EQ(best_rate({}), 0);
    EXPECT_EQ(best_rate({2, 5, 3}), 5);
    EXPECT_EQ(middle_ratio({}, {1}), 0);
    EXPECT_EQ(middle_ratio({2, 9, 8}, {1, 3, 1}), 3);
    EXPECT_EQ(middle_ratio({2, 9, 8, 8}, {1, 3, 1, 2}), 3.5);
}

}  // namespace
}  // namespace carom::render::triangle
