// What is wrong in a text such as the value of an option.
#pragma once

#include <cstddef>
#include <string>

namespace carom::pipeline::measures {

struct TextProblem {
    std::string sentence;    // without a full stop
    std::size_t offset = 0;  // in bytes, of the part in question
    std::size_t length = 0;
};

}  // namespace carom::pipeline::measures
