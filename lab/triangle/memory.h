// The memory that a triangle takes in each of its forms.
#pragma once

#include <vector>

#include "lab/triangle/variant.h"

namespace carom::render::triangle {

/// Of a kernel's input, taken from its types.
struct InputMemory {
    KernelName kernel = KernelName::moller_trumbore;
    Input input = Input::corners;
    int numbers = 0;  // without the axis
    bool has_axis = false;
    /// In bytes: one by one, in float and double; with one axis instead of three, in float; and
    /// among several triangles at once, in float.
    int bytes_float = 0, bytes_double = 0, bytes_one_axis = 0, bytes_in_block = 0;
};

/// Of all kernels with all inputs, in the order of all_forms().
[[nodiscard]] std::vector<InputMemory> memory_of_inputs();

}  // namespace carom::render::triangle
