#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

namespace carom::render {
namespace {

/// How often each instruction occurs in the code for devices.
std::map<std::string, int> instructions() {
    std::ifstream file(CAROM_PTX_FILE);
    EXPECT_TRUE(file.is_open()) << CAROM_PTX_FILE;
    std::map<std::string, int> counts;
    std::string line;
    while (std::getline(file, line)) {
        // "	mul.rn.f32 	%f3, %f1, %f2;", perhaps behind "@%p1 "
        const std::size_t first = line.find_first_not_of("\t ");
        if (first == std::string::npos || first == 0) {
            continue;
        }
        const std::size_t name = line[first] == '@' ? line.find(' ', first) + 1 : first;
        counts[line.substr(name, line.find_first_of(" \t;", name) - name)] += 1;
    }
    return counts;
}

bool has_part(const std::string& name, const std::string& part) {
    return ("." + name + ".").find("." + part + ".") != std::string::npos;
}

TEST(DeviceKernels, Arithmetic_IsRoundedAsOnProcessors) {
    for (const auto& [name, count] : instructions()) {
        EXPECT_FALSE(has_part(name, "fma") || has_part(name, "mad.rn")) << name << ": contracted";
        EXPECT_FALSE(has_part(name, "approx") || has_part(name, "full")) << name << ": inexact";
        const bool is_rounded = has_part(name, "add") || has_part(name, "sub") ||
                                has_part(name, "mul") || has_part(name, "div") ||
                                has_part(name, "sqrt") || has_part(name, "rcp");
        if (is_rounded && (has_part(name, "f32") || has_part(name, "f64"))) {
            // Without .rn the driver's compiler may contract it.
            EXPECT_TRUE(has_part(name, "rn")) << name << ": " << count << " times";
        }
    }
}

TEST(DeviceKernels, AllKernels_AreInTheCode) {
    auto counts = instructions();
    EXPECT_GT(counts["add.rn.f32"], 1000);
    EXPECT_GT(counts["mul.rn.f32"], 2000);
    EXPECT_GT(counts["div.rn.f32"], 200);
    EXPECT_GT(counts["sqrt.rn.f32"], 100);
}

}  // namespace
}  // namespace carom::render
