#include "lab/triangle/make_variant.h"
#include "lab/triangle/run_factories.h"
#include "lab/triangle/single_run.h"

namespace carom::render::triangle {

namespace {

constexpr bool is_single(const Variant& variant) {
    return variant.packing == Packing::single;
}

template <Variant kVariant>
using SingleRunOf = SingleRun<kVariant, NumberOf<kVariant.precision>>;

}  // namespace

std::unique_ptr<KernelRun> make_single_run(const Variant& variant, const TestSet& set) {
    return make_variant<SingleRunOf, is_single>(variant, set);
}

std::vector<NearestHit> reference_hits(Precision precision, const TestSet& set) {
    constexpr Variant kReference{{KernelName::moller_trumbore, Input::corners, Division::early}};
    std::unique_ptr<KernelRun> run;
    if (precision == Precision::single_precision) {
        run = std::make_unique<SingleRun<kReference, double>>(set);
    } else {
        run = std::make_unique<SingleRun<kReference, long double>>(set);
    }
    run->run();
    return run->hits();
}

}  // namespace carom::render::triangle
