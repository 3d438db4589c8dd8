// Tests of what is measured, not of the speed.
#include "lab/triangle/measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "lab/triangle/memory.h"

namespace carom::render::triangle {
namespace {

MeasureOptions small_options() {
    MeasureOptions options;
    options.kernels = {KernelName::wald, KernelName::keidy};
    options.rounds = 2;
    options.groups = 1;
    options.streamed = 64;
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
    ASSERT_EQ(measured.compilers.size(), 1u);
    EXPECT_TRUE(measured.compilers[0].starts_with("g++ ") ||
                measured.compilers[0].starts_with("clang++ "));
    for (const VariantRates& rates : measured.rates) {
        EXPECT_EQ(rates.random.size(), 2u);
        EXPECT_EQ(rates.worst.size(), 2u);
        EXPECT_GT(best_rate(rates.random), 0);
        EXPECT_GT(best_rate(rates.worst), 0);
        EXPECT_TRUE(rates.streamed.empty());
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
        const bool is_angles = errors.form.kernel == KernelName::angle_sum;
        EXPECT_GT(errors.hits, 200);
        EXPECT_LE(errors.others, is_float && is_angles ? 10 : 0);
        EXPECT_EQ(errors.rays, 8 * 64);
        EXPECT_EQ(errors.slipped > 0,
                  is_float && !is_angles && errors.form.kernel != KernelName::origin_half_spaces);
        EXPECT_LT(errors.slipped, 0.2);
        EXPECT_GT(errors.distance, is_float ? 1e-8 : 1e-17);
        EXPECT_LT(errors.distance, is_float ? 1e-5 : 1e-14);
        EXPECT_GT(errors.weights, is_float ? 1e-8 : 1e-17);
        EXPECT_LT(errors.weights, is_float ? 2e-5 : 2e-14);
    }
}

TEST(MeasureKernels, Techniques_OnlyWhereTheyExist) {
    MeasureOptions options = small_options();
    options.techniques = {Technique::structures, Technique::newton, Technique::axis_fixed};
    const KernelMeasurements measured = measure_kernels(options, {});
    // The plain ones; structures early in four packings; Newton's step early and deferred in five;
    // Wald's axis early in five.
    EXPECT_EQ(measured.rates.size(), 6u * 2 * 5 + 2 * 4 + 2 * 2 * 5 + 5);
    EXPECT_EQ(measured.errors.size(), 6u * 2 + 2 * 2 + 1);
    for (const VariantRates& rates : measured.rates) {
        const bool is_newton = rates.variant.technique == Technique::newton;
        const bool is_one_layout =
            rates.variant.form.division == Division::deferred ||
            rates.variant.precision == Precision::double_precision ||
            rates.variant.form.input != best_input(rates.variant.form.kernel) || is_newton ||
            rates.variant.technique == Technique::axis_fixed;
        EXPECT_EQ(rates.streamed.size(), is_one_layout ? 0u : 2u);
    }
}

/// Two libraries, which here are the same.
TEST(MeasureKernels, Libraries_SideBySide) {
    MeasureOptions options = small_options();
    options.kernels = {KernelName::wald};
    options.libraries.push_back({"another", make_run});
    const KernelMeasurements measured = measure_kernels(options, {});
    EXPECT_EQ(measured.compilers,
              (std::vector<std::string>{options.libraries[0].compiler, "another"}));
    ASSERT_EQ(measured.rates.size(), 2u * 2 * 2 * 5);
    for (std::size_t i = 0; i < measured.rates.size(); i += 2) {
        EXPECT_EQ(measured.rates[i].variant, measured.rates[i + 1].variant);
        EXPECT_EQ(measured.rates[i].library, 0u);
        EXPECT_EQ(measured.rates[i + 1].library, 1u);
    }
    ASSERT_EQ(measured.errors.size(), 2u * 2 * 2);
    EXPECT_EQ(measured.errors[0].distance, measured.errors[1].distance);
}

/// The second compiler's kernels are a target of their own, so that tests do not need it. Where
/// they are built, they compute the same bits.
TEST(OtherKernels, SameBitsOrASentence) {
    KernelLibrary other;
    try {
        other = other_kernels();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(),
                    ::testing::StartsWith("the kernels of a second compiler cannot be loaded: "));
        EXPECT_THAT(error.what(), ::testing::HasSubstr("carom-other-kernels"));
        return;
    }
    EXPECT_NE(other.compiler, own_kernels().compiler);
    const TestSet set = make_random_set(20, 9);
    for_each_variant([&](const Variant& variant) {
        const auto own = make_run(variant, set);
        const auto others = other.make_run(variant, set);
        ASSERT_NE(others, nullptr);
        own->run();
        others->run();
        const auto hits = own->hits();
        const auto other_hits = others->hits();
        for (std::size_t i = 0; i < hits.size(); ++i) {
            ASSERT_EQ(hits[i].triangle, other_hits[i].triangle) << name(variant.form.kernel);
            ASSERT_EQ(hits[i].t, other_hits[i].t) << name(variant.form.kernel);
            ASSERT_EQ(hits[i].u, other_hits[i].u) << name(variant.form.kernel);
            ASSERT_EQ(hits[i].v, other_hits[i].v) << name(variant.form.kernel);
        }
    });
}

TEST(Memory, Records_AsTheirTypesAre) {
    const auto memory = memory_of_inputs();
    EXPECT_EQ(memory.size(), all_forms().size() / 2);
    for (const InputMemory& of : memory) {
        const int axes = of.has_axis ? 3 : 0;
        EXPECT_EQ(of.bytes_float, 4 * (of.numbers + axes));
        EXPECT_EQ(of.bytes_one_axis, 4 * (of.numbers + (of.has_axis ? 1 : 0)));
        EXPECT_EQ(of.bytes_in_block, of.bytes_one_axis);
        EXPECT_GE(of.bytes_double, 8 * of.numbers + 4 * axes);
        if (of.kernel == KernelName::wald || of.kernel == KernelName::perpendicular_planes) {
            EXPECT_EQ(of.bytes_float, 48);
        }
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
