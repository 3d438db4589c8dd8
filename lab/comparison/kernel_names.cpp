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

}  // namespace carom::pipeline
