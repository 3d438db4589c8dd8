#include "lab/triangle/variant.h"

namespace carom::render::triangle {

namespace {

constexpr std::string_view kNames[kKernelCount] = {
    "moller_trumbore", "kensler_shirley",     "shevtsov", "badouel", "wald",
    "keidy",           "perpendicular_planes"};
constexpr std::string_view kTitles[kKernelCount] = {
    "Möller–Trumbore", "Kensler–Shirley",     "Shevtsov–Soupikov–Kapustin", "Badouel", "Wald",
    "Keidy",           "perpendicular planes"};

std::vector<Form> make_forms() {
    using enum KernelName;
    using enum Input;
    std::vector<Form> forms;
    const auto add = [&](KernelName kernel, std::initializer_list<Input> inputs) {
        for (const Input input : inputs) {
            forms.push_back({kernel, input, Division::early});
            forms.push_back({kernel, input, Division::deferred});
        }
    };
    add(moller_trumbore, {corners, record});
    add(kensler_shirley, {corners, corners_and_normal, record});
    add(shevtsov, {record});
    add(badouel, {corners_and_normal, record});
    add(wald, {record});
    add(keidy, {corners, corners_and_normal});
    add(perpendicular_planes, {record});
    return forms;
}

}  // namespace

std::span<const Form> all_forms() {
    static const std::vector<Form> kForms = make_forms();
    return kForms;
}

std::string_view title(KernelName kernel) {
    return kTitles[static_cast<int>(kernel)];
}

std::string_view name(KernelName kernel) {
    return kNames[static_cast<int>(kernel)];
}

std::string_view name(Input input) {
    switch (input) {
        case Input::corners:
            return "corners";
        case Input::corners_and_normal:
            return "corners_and_normal";
        case Input::record:
            return "record";
    }
    return {};
}

std::string_view name(Division division) {
    return division == Division::early ? "early" : "deferred";
}

std::string_view name(Packing packing) {
    switch (packing) {
        case Packing::single:
            return "single";
        case Packing::four_rays:
            return "four_rays";
        case Packing::eight_rays:
            return "eight_rays";
        case Packing::four_triangles:
            return "four_triangles";
        case Packing::eight_triangles:
            return "eight_triangles";
    }
    return {};
}

std::string_view name(Precision precision) {
    return precision == Precision::single_precision ? "float" : "double";
}

std::optional<KernelName> find_kernel(std::string_view name) {
    for (int i = 0; i < kKernelCount; ++i) {
        if (kNames[i] == name) {
            return static_cast<KernelName>(i);
        }
    }
    return std::nullopt;
}

}  // namespace carom::render::triangle
