#include "pipeline/job/damage_report.h"

#include <fmt/core.h>

namespace carom::pipeline {
namespace {

constexpr int kMaxNamed = 3;

}  // namespace

void DamageReport::add(const std::string& path, const std::string& damage) {
    const std::scoped_lock lock(mutex_);
    if (++count_ <= kMaxNamed) {
        observer_.warning("the stored frame '" + path +
                          "' is damaged and is rendered again: " + damage);
    }
}

DamageReport::~DamageReport() {
    if (const int others = count_ - kMaxNamed; others > 0) {
        observer_.warning(
            fmt::format("{}{} damaged; 'carom cache verify' checks every file of the cache", others,
                        others == 1 ? " more stored frame was" : " more stored frames were"));
    }
}

}  // namespace carom::pipeline
