// What the messages between carom's studio and its page have in common.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace carom::studio {

inline constexpr const char* kProtocol = "carom-studio/1";

using Triple = std::array<double, 3>;
using Turn = std::array<double, 4>;  // unit quaternion, w first

/// Keys from the top of the shot to a value; elements of lists by their index:
/// ["cameras", "0", "position", "bezier", "1"].
using KeyPath = std::vector<std::string>;

/// A range in a file. Lines and columns count from 1, columns and lengths in characters (code
/// points); line 0: no place.
struct TextRange {
    std::string file;  // a path of Files, or the name of an option such as "--set"
    int line = 0;
    int column = 0;
    int length = 0;
};

}  // namespace carom::studio
