#include "lab/triangle/variant.h"

#include <algorithm>
#include <vector>

#include "lab/triangle/variants.h"

namespace carom::render::triangle {

std::span<const Form> all_forms() {
    static const std::vector<Form> kForms = [] {
        std::vector<Form> forms;
        for_each_variant([&](const Variant& variant) {
            if (forms.empty() || forms.back() != variant.form) {
                forms.push_back(variant.form);
            }
        });
        return forms;
    }();
    return kForms;
}

std::string_view title(KernelName kernel) {
    return facts(kernel).title;
}

std::string_view name(KernelName kernel) {
    return facts(kernel).name;
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

std::string_view name(Technique technique) {
    switch (technique) {
        case Technique::plain:
            return "plain";
        case Technique::arrays:
            return "arrays";
        case Technique::structures:
            return "structures";
        case Technique::newton:
            return "newton";
        case Technique::sign_bits:
            return "sign_bits";
        case Technique::axis_from_table:
            return "axis_from_table";
        case Technique::axis_by_versions:
            return "axis_by_versions";
        case Technique::axis_by_order:
            return "axis_by_order";
        case Technique::axis_fixed:
            return "axis_fixed";
        case Technique::any_hit:
            return "any_hit";
        case Technique::common_origin:
            return "common_origin";
        case Technique::parallel_rays:
            return "parallel_rays";
    }
    return {};
}

std::optional<KernelName> find_kernel(std::string_view name) {
    const auto found = std::ranges::find(kKernels, name, &KernelFacts::name);
    return found == kKernels.end() ? std::nullopt : std::optional(found->kernel);
}

std::optional<Technique> find_technique(std::string_view text) {
    const auto found =
        std::ranges::find(kTechniques, text, [](Technique technique) { return name(technique); });
    return found == kTechniques.end() ? std::nullopt : std::optional(*found);
}

}  // namespace carom::render::triangle
