// The text output of measured kernels.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "lab/comparison/kernel_names.h"
#include "lab/comparison/kernel_ratios.h"
#include "lab/comparison/reports.h"

namespace carom::pipeline {
namespace {

using namespace render::triangle;
using ::testing::HasSubstr;

/// Wald's at 100 and 50 million tests per second, perpendicular planes at 120 and 40; more for
/// larger packings, half in double; the second of the two rounds is better.
KernelMeasurements two_kernels() {
    KernelMeasurements measured;
    measured.is_whole = true;
    measured.compilers = {"g++ 12.2.0"};
    for (const Form& form : all_forms()) {
        const bool is_wald = form.kernel == KernelName::wald;
        if (!is_wald && form.kernel != KernelName::perpendicular_planes) {
            continue;
        }
        for (const Precision precision : kPrecisions) {
            const bool is_float = precision == Precision::single_precision;
            measured.errors.push_back({form, precision, Technique::plain, 0,
                                       is_float ? 1.25e-6 : 2e-15, is_float ? 2.5e-6 : 3e-15,
                                       is_float ? 0.125 : 0, 100, is_float ? 3 : 0, 200});
            for (const Packing packing : kPackings) {
                const double scale = (is_float ? 1 : 0.5) * (1 + static_cast<int>(packing));
                const double random = scale * (is_wald ? 100 : 120);
                const double worst = scale * (is_wald ? 50 : 40);
                measured.rates.push_back({{form, packing, precision},
                                          0,
                                          {0.9 * random, random},
                                          {0.9 * worst, worst},
                                          {}});
            }
        }
    }
    return measured;
}

TEST(KernelText, WholeOutput) {
    EXPECT_EQ(report_text(two_kernels()),
              R"(Millions of tests per second of CPU time, the best of 2 rounds, g++ 12.2.0

random rays, float                      one  4 rays  8 rays  4 triangles  8 triangles
Wald, record, early                     100     200     300          400          500
Wald, record, deferred                  100     200     300          400          500
perpendicular planes, record, early     120     240     360          480          600
perpendicular planes, record, deferred  120     240     360          480          600

every ray hits, float                    one  4 rays  8 rays  4 triangles  8 triangles
Wald, record, early                     50.0     100     150          200          250
Wald, record, deferred                  50.0     100     150          200          250
perpendicular planes, record, early     40.0    80.0     120          160          200
perpendicular planes, record, deferred  40.0    80.0     120          160          200

random rays, double                      one  4 rays  8 rays  4 triangles  8 triangles
Wald, record, early                     50.0     100     150          200          250
Wald, record, deferred                  50.0     100     150          200          250
perpendicular planes, record, early     60.0     120     180          240          300
perpendicular planes, record, deferred  60.0     120     180          240          300

every ray hits, double                   one  4 rays  8 rays  4 triangles  8 triangles
Wald, record, early                     25.0    50.0    75.0          100          125
Wald, record, deferred                  25.0    50.0    75.0          100          125
perpendicular planes, record, early     20.0    40.0    60.0         80.0          100
perpendicular planes, record, deferred  20.0    40.0    60.0         80.0          100

Mean relative errors of the distance t and the weights u and v; rays aimed at an edge of two
triangles that slip between them; of 200 random rays, those with another hit

                                        t, float  u v, float    slip  other  t, double  u v, double   slip  other
Wald, record, early                     1.25e-06    2.50e-06  12.5 %      3   2.00e-15     3.00e-15  0.0 %      0
Wald, record, deferred                  1.25e-06    2.50e-06  12.5 %      3   2.00e-15     3.00e-15  0.0 %      0
perpendicular planes, record, early     1.25e-06    2.50e-06  12.5 %      3   2.00e-15     3.00e-15  0.0 %      0
perpendicular planes, record, deferred  1.25e-06    2.50e-06  12.5 %      3   2.00e-15     3.00e-15  0.0 %      0

perpendicular planes, times as fast as Wald   one  4 rays  8 rays  4 triangles  8 triangles
random rays, float, early                    1.20    1.20    1.20         1.20         1.20
random rays, float, deferred                 1.20    1.20    1.20         1.20         1.20
every ray hits, float, early                 0.80    0.80    0.80         0.80         0.80
every ray hits, float, deferred              0.80    0.80    0.80         0.80         0.80
random rays, double, early                   1.20    1.20    1.20         1.20         1.20
random rays, double, deferred                1.20    1.20    1.20         1.20         1.20
every ray hits, double, early                0.80    0.80    0.80         0.80         0.80
every ray hits, double, deferred             0.80    0.80    0.80         0.80         0.80

Bytes per triangle: with the indices of three axes, with one; in a block of several triangles

                                 numbers  float  one axis  in a block  double
Wald, record                  9 and axis     48        40          40      88
perpendicular planes, record          12     48        48          48      96
)");
}

TEST(KernelText, Interrupted_MissingRatesAreDashes) {
    KernelMeasurements measured = two_kernels();
    measured.is_whole = false;
    measured.rates.resize(3);
    const std::string text = report_text(measured);
    EXPECT_THAT(
        text, HasSubstr("\nWald, record, early  100     200     300            -            -\n"));
    EXPECT_EQ(text.find("rays, double"), std::string::npos);
    EXPECT_EQ(text.find("times as fast"), std::string::npos);
    EXPECT_THAT(text, ::testing::EndsWith("\ninterrupted: rounds or kernels are missing\n"));
}

/// Layouts at half the speed with random rays, a quarter where every ray hits, a tenth from memory.
TEST(KernelText, Techniques_RelativeToThePlainVariant) {
    KernelMeasurements measured = two_kernels();
    const std::size_t count = measured.rates.size();
    for (std::size_t i = 0; i < count; ++i) {
        VariantRates rates = measured.rates[i];
        rates.variant.technique = Technique::structures;
        if (exists(rates.variant)) {
            rates.random = {0.5 * rates.random[0], 0.5 * rates.random[1]};
            rates.worst = {0.25 * rates.worst[0], 0.25 * rates.worst[1]};
            measured.rates[i].streamed = {10, 20};
            rates.streamed = {1, 2};
            measured.rates.push_back(rates);
        }
    }
    const std::string text = report_text(measured);
    EXPECT_THAT(
        text,
        HasSubstr(
            "\narray of structures, times as fast   one              4 rays              8 rays"
            "         4 triangles         8 triangles\n"
            "Wald, record, early                    -  0.50 / 0.25 / 0.10  0.50 / 0.25 / 0.10"));
    EXPECT_EQ(text.find("structure of arrays"), std::string::npos);
    EXPECT_EQ(techniques_against_plain(measured).size(), 2u * 4);
    // The other tables are as before.
    EXPECT_THAT(text, ::testing::StartsWith(report_text(two_kernels())));
}

TEST(KernelText, SecondCompiler_RelativeToTheFirst) {
    KernelMeasurements measured = two_kernels();
    measured.compilers.emplace_back("clang++ 14.0.6");
    const std::size_t count = measured.rates.size();
    for (std::size_t i = 0; i < count; ++i) {
        VariantRates rates = measured.rates[i];
        rates.library = 1;
        rates.random = {2 * rates.random[0], 2 * rates.random[1]};
        measured.rates.push_back(rates);
    }
    const std::string text = report_text(measured);
    EXPECT_THAT(text, HasSubstr("\nclang++ 14.0.6 relative to g++ 12.2.0: random rays / every ray "
                                "hits\n\nfloat, times as fast"));
    EXPECT_THAT(text, HasSubstr("\nWald, record, early                     2.00 / 1.00  "));
    EXPECT_THAT(text, HasSubstr("\ndouble, times as fast"));
    EXPECT_THAT(text, ::testing::StartsWith(report_text(two_kernels())));
}

TEST(KernelPlot, HasABarForEveryPacking) {
    const std::string svg = report_plot(two_kernels(), PlanPage::automatic);
    for (const char* text : {"Wald, record", "perpendicular planes, record", "8 triangles",
                             "random rays, float", "every ray hits, double", ">600<", ">25.0<"}) {
        EXPECT_THAT(svg, HasSubstr(text));
    }
    std::size_t bars = 0;
    for (std::size_t at = svg.find("<rect"); at != std::string::npos;
         at = svg.find("<rect", at + 1)) {
        bars += 1;
    }
    // The page, five legends; two kernels, five packings, four panels.
    EXPECT_EQ(bars, 1u + 5 + 2 * 5 * 4);
}

TEST(KernelNames, ListOfNames) {
    EXPECT_EQ(kernels_from_text("all").size(), static_cast<std::size_t>(kKernelCount));
    EXPECT_EQ(kernels_from_text("wald,keidy"), (std::vector{KernelName::wald, KernelName::keidy}));
    const auto complaint = [](const std::string& text) {
        try {
            (void)kernels_from_text(text);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(complaint("wald,,keidy"),
              "unknown kernel ''; use one of moller_trumbore, kensler_shirley, shevtsov, "
              "badouel, wald, keidy, perpendicular_planes, angle_sum, half_spaces, "
              "origin_half_spaces, signed_areas, or all");
    EXPECT_THAT(complaint("woop"), HasSubstr("unknown kernel 'woop'; "));
    EXPECT_EQ(complaint("wald,wald"), "the kernel 'wald' is named twice");
}

TEST(TechniqueNames, ListOfNames) {
    EXPECT_TRUE(techniques_from_text("").empty());
    EXPECT_EQ(techniques_from_text("all").size(), kTechniques.size() - 1);
    EXPECT_EQ(techniques_from_text("newton,arrays"),
              (std::vector{Technique::newton, Technique::arrays}));
    EXPECT_THROW((void)techniques_from_text("plain"), Error);
}

}  // namespace
}  // namespace carom::pipeline
