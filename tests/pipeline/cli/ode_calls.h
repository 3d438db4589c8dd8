// Counts how often the program under test has called ODE.
#pragma once

namespace carom::testing {

struct OdeCalls {
    int starts = 0;  // dInitODE2
    int worlds = 0;  // dWorldCreate
    int steps = 0;   // dWorldStep and dWorldQuickStep
};

/// The numbers of calls since the process started.
[[nodiscard]] OdeCalls ode_calls();

}  // namespace carom::testing
