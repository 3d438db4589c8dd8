// Brute force: tests every shape for every ray. The other structures are compared with it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lab/structures/query.h"

namespace carom::render {

class BruteForce {
  public:
    explicit BruteForce(const Primitives& primitives)
        : count_(static_cast<std::uint32_t>(primitives.bounded().size())) {}

    template <class Query>
    void search(Query& query) const {
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (query.test(i)) {
                return;
            }
        }
    }
    [[nodiscard]] std::size_t bytes() const { return 0; }

  private:
    std::uint32_t count_;
};

}  // namespace carom::render
