#include "sim/timeline/event.h"

namespace carom::sim {

std::string_view to_string(EventKind kind) {
    switch (kind) {
        case EventKind::impact:
            return "impact";
        case EventKind::sliding:
            return "sliding";
        case EventKind::rolling:
            return "rolling";
        case EventKind::spinning:
            return "spinning";
        case EventKind::resting:
            return "resting";
        case EventKind::airborne:
            return "airborne";
        case EventKind::potted:
            return "potted";
        case EventKind::off_table:
            return "off_table";
        case EventKind::force:
            return "force";
        case EventKind::torque:
            return "torque";
        case EventKind::impulse:
            return "impulse";
        case EventKind::velocity:
            return "velocity";
        case EventKind::strike:
            return "strike";
        case EventKind::placed:
            return "placed";
        case EventKind::removed:
            return "removed";
    }
    return "unknown";  // not a value of EventKind
}

}  // namespace carom::sim
