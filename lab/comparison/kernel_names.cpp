#include "lab/comparison/kernel_names.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "lab/comparison/named_list.h"
#include "lab/triangle/variants.h"

namespace carom::pipeline {

namespace {

using namespace render::triangle;

constexpr auto kNameOf = [](auto member) { return name(member); };

}  // namespace

std::vector<KernelName> kernels_from_text(const std::string& text) {
    std::vector<KernelName> all;
    std::ranges::transform(kKernels, std::back_inserter(all), &KernelFacts::kernel);
    return named_in<KernelName>(text, "kernel", all, kNameOf);
}

std::vector<Technique> techniques_from_text(const std::string& text) {
    if (text.empty()) {
        return {};
    }
    static_assert(kTechniques[0] == Technique::plain);
    return named_in<Technique>(text, "technique", std::span(kTechniques).subspan(1), kNameOf);
}

}  // namespace carom::pipeline
