#include "lab/triangle/variant.h"

#include <algorithm>
#include <vector>

#include <fmt/core.h>

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

namespace {

template <class Enum, std::size_t kCount>
const Named<Enum>& named(const std::array<Named<Enum>, kCount>& names, Enum value) {
    return *std::ranges::find(names, value, &Named<Enum>::value);
}

}  // namespace

std::string_view name(KernelName kernel) {
    return facts(kernel).name;
}
std::string_view name(Input input) {
    return named(kInputNames, input).name;
}
std::string_view name(Division division) {
    return named(kDivisionNames, division).name;
}
std::string_view name(Packing packing) {
    return named(kPackingNames, packing).name;
}
std::string_view name(Precision precision) {
    return named(kPrecisionNames, precision).name;
}
std::string_view name(Technique technique) {
    return named(kTechniqueNames, technique).name;
}

std::string_view title(KernelName kernel) {
    return facts(kernel).title;
}
std::string_view title(Input input) {
    return named(kInputNames, input).title;
}
std::string_view title(Packing packing) {
    return named(kPackingNames, packing).title;
}
std::string_view title(Technique technique) {
    return named(kTechniqueNames, technique).title;
}
std::string title(const Form& form) {
    return fmt::format("{}, {}, {}", title(form.kernel), title(form.input), name(form.division));
}

}  // namespace carom::render::triangle
