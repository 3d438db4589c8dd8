// Counts the calls of libode: the functions here are found before those of the same names in the
// library, and call these.
#include "tests/pipeline/cli/ode_calls.h"

#include <atomic>

#include <dlfcn.h>
#include <ode/ode.h>

namespace {

std::atomic<int> starts{0};
std::atomic<int> worlds{0};
std::atomic<int> steps{0};

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int dInitODE2(unsigned int flags) {
    ++starts;
    return next<int (*)(unsigned int)>("dInitODE2")(flags);
}

dWorldID dWorldCreate() {
    ++worlds;
    return next<dWorldID (*)()>("dWorldCreate")();
}

int dWorldStep(dWorldID world, dReal step) {
    ++steps;
    return next<int (*)(dWorldID, dReal)>("dWorldStep")(world, step);
}

int dWorldQuickStep(dWorldID world, dReal step) {
    ++steps;
    return next<int (*)(dWorldID, dReal)>("dWorldQuickStep")(world, step);
}

}  // extern "C"

namespace carom::testing {

OdeCalls ode_calls() {
    return {starts, worlds, steps};
}

}  // namespace carom::testing
