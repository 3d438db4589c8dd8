#include "lab/triangle/memory.h"

#include "lab/triangle/scalar_kernels.h"

namespace carom::render::triangle {

namespace {

template <class Kernel, Input kInput>
InputMemory memory_of(KernelName name) {
    using Single = scalar::InputOf<Kernel, kInput, ScalarLanes<float>>;
    using Double = scalar::InputOf<Kernel, kInput, ScalarLanes<double>>;
    using OneAxis = scalar::InputOf<Kernel, kInput, ScalarLanes<float, AxisFromTable>>;
    InputMemory memory{name, kInput};
    memory.numbers = static_cast<int>(scalar::NumberIndices<Single>::size());
    memory.has_axis = Single::kHasAxis;
    memory.bytes_float = sizeof(Single);
    memory.bytes_double = sizeof(Double);
    memory.bytes_one_axis = sizeof(OneAxis);
    memory.bytes_in_block =
        (memory.numbers + (memory.has_axis ? 1 : 0)) * static_cast<int>(sizeof(float));
    return memory;
}

template <KernelName kName>
void add_inputs_of(std::vector<InputMemory>& all) {
    using Kernel = scalar::KernelOf<kName>;
    if constexpr (has_input(kName, Input::corners)) {
        all.push_back(memory_of<Kernel, Input::corners>(kName));
    }
    if constexpr (has_input(kName, Input::corners_and_normal)) {
        all.push_back(memory_of<Kernel, Input::corners_and_normal>(kName));
    }
    if constexpr (has_input(kName, Input::record)) {
        all.push_back(memory_of<Kernel, Input::record>(kName));
    }
}

}  // namespace

std::vector<InputMemory> memory_of_inputs() {
    std::vector<InputMemory> all;
    [&]<std::size_t... kIndices>(std::index_sequence<kIndices...>) {
        (add_inputs_of<static_cast<KernelName>(kIndices)>(all), ...);
    }
    (std::make_index_sequence<kKernels.size()>());
    return all;
}

}  // namespace carom::render::triangle
