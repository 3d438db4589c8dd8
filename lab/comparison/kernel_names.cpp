#include "lab/comparison/kernel_names.h"

#include <algorithm>
#include <optional>
#include <span>

#include "core/error.h"
#include "lab/triangle/variants.h"

namespace carom::pipeline {

namespace {

using namespace render::triangle;

/// The members of a set that are named in a list. `what`: "kernel".
template <class Named>
std::vector<Named> named_in(const std::string& text, const std::string& what,
                            std::span<const Named> all) {
    if (text == "all") {
        return {all.begin(), all.end()};
    }
    std::vector<Named> chosen;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string given = text.substr(begin, end - begin);
        const auto found = std::ranges::find(all, given, [](Named one) { return name(one); });
        if (found == all.end()) {
            std::string names;
            for (const Named one : all) {
                names += std::string(name(one)) + ", ";
            }
            throw Error("unknown " + what + " '" + given + "'; use one of " + names + "or all");
        }
        if (std::ranges::find(chosen, *found) != chosen.end()) {
            throw Error("the " + what + " '" + given + "' is named twice");
        }
        chosen.push_back(*found);
        begin = end + 1;
    }
    return chosen;
}

}  // namespace

std::vector<KernelName> kernels_from_text(const std::string& text) {
    std::vector<KernelName> all;
    for (const KernelFacts& kernel : kKernels) {
        all.push_back(kernel.kernel);
    }
    return named_in<KernelName>(text, "kernel", all);
}

std::vector<Technique> techniques_from_text(const std::string& text) {
    if (text.empty()) {
        return {};
    }
    static_assert(kTechniques[0] == Technique::plain);
    return named_in<Technique>(text, "technique", std::span(kTechniques).subspan(1));
}

const char* title_of(Input input) {
    switch (input) {
        case Input::corners:
            return "corners";
        case Input::corners_and_normal:
            return "with normal";
        case Input::record:
            return "record";
    }
    return "";
}

const char* title_of(Packing packing) {
    switch (packing) {
        case Packing::single:
            return "one";
        case Packing::four_rays:
            return "4 rays";
        case Packing::eight_rays:
            return "8 rays";
        case Packing::four_triangles:
            return "4 triangles";
        case Packing::eight_triangles:
            return "8 triangles";
    }
    return "";
}

const char* title_of(Technique technique) {
    switch (technique) {
        case Technique::plain:
            return "plain";
        case Technique::arrays:
            return "structure of arrays";
        case Technique::structures:
            return "array of structures";
        case Technique::newton:
            return "estimated reciprocal and a Newton step";
        case Technique::sign_bits:
            return "tests of sign bits";
        case Technique::axis_from_table:
            return "following axes from a table";
        case Technique::axis_by_versions:
            return "a version of the code for each axis";
        case Technique::axis_by_order:
            return "coordinates in the order of the axis";
        case Technique::axis_fixed:
            return "the same axis for all triangles";
        case Technique::any_hit:
            return "whether anything is hit";
        case Technique::common_origin:
            return "rays from one point";
        case Technique::parallel_rays:
            return "parallel rays";
    }
    return "";
}

std::string title_of(const Form& form) {
    return std::string(title(form.kernel)) + ", " + title_of(form.input) + ", " +
           std::string(name(form.division));
}

}  // namespace carom::pipeline
