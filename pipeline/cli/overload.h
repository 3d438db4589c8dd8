// Several lambdas as one visitor.
#pragma once

namespace carom::cli {

template <class... Ts>
struct Overload : Ts... {
    using Ts::operator()...;
};
template <class... Ts>
Overload(Ts...) -> Overload<Ts...>;

}  // namespace carom::cli
